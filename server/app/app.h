// server/app: the use cases (machines, families, parts, programs, checks, releases, jobs), the lines that feed, the
// ledger's writer and what happens at a restart. It speaks to the outside through ports/ and to the database through
// store; it knows no JSON, HTTP, socket or command line.
#pragma once

#include "server/app/lines/line.h"

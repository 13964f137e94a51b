// server/json: every document's reading and writing: machine profiles, part values, diagnostics, reports, events, the
// records that the API shows. Each kind has a file pair; the parser's own types stay inside. A document that is wrong
// gives every fault with its JSON pointer; nothing is guessed, and unknown members are faults, because a misspelled
// limit is a limit that is not kept.
#pragma once

#include "server/json/diagnostics.h"
#include "server/json/documents.h"
#include "server/json/profile_document.h"
#include "server/json/records.h"
#include "server/json/reports.h"
#include "server/json/requests.h"

// server/machine: the whole machine profile as plain data: control settings + what the checks need + line settings +
// link URL. It reads no JSON (server/json does), opens nothing, and makes no control tables: the application asks the
// dialect for them and lays the profile's settings over them.
#pragma once

#include "server/machine/link_url.h"
#include "server/machine/profile.h"

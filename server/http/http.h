// server/http: the REST API, live events and the page over HTTP/1.1. The connection (Beast) knows requests and answers
// only; the router knows paths and rights; handlers read and write documents (server/json) and call the application. No
// use case lives here.
#pragma once

#include "server/http/request.h"
#include "server/http/router.h"
#include "server/http/server.h"

// The headers of answers, and which problems a route may answer with, for openapi.json: by what it takes, not by what
// its handler does, so that a row of the table of routes is enough.
#pragma once

#include "server/json/openapi.h"
#include "server/json/parse.h"

namespace dripfeed::json {

// A header that an answer always has, by its name in the table of openapi_headers.h.
Document header_object(std::string_view name);
// components/responses: one a status, with its codes.
Document problem_responses();
// Adds those of one route; `default` stands for those that any route may meet.
void add_problems(const OpenApiRoute& route, Document& responses);

}  // namespace dripfeed::json

// Examples of the documents that go over the wire, for openapi.json: an object of examples.json for each schema that a
// request or an answer is. One part's path from its order to its job runs through them. A test compares each with its
// schema, and finds none missing.
#pragma once

#include <string_view>

namespace dripfeed::json {

// JSON: by the name of the schema.
std::string_view api_examples();

}  // namespace dripfeed::json

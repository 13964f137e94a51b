// Examples of the documents that a MES sends and gets, for openapi.json: one part's path from its order to its job. A
// test holds each against its schema.
#pragma once

#include <span>
#include <string_view>

namespace dripfeed::json {

struct ApiExample {
  std::string_view schema;
  std::string_view document;  // JSON
};
std::span<const ApiExample> api_examples();

}  // namespace dripfeed::json

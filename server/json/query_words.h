// What a query parameter of a route may be: for openapi.json. The handlers refuse everything else, and a test of the
// API asks for each word.
#pragma once

#include <span>
#include <string_view>

namespace dripfeed::json {

// Empty where a parameter is any text.
std::span<const std::string_view> query_words(std::string_view path, std::string_view name);
// Whether it is a whole number from 0.
bool is_query_number(std::string_view name);

}  // namespace dripfeed::json

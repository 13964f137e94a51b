// What openapi.json says in words besides bodies and answers: which group a route belongs to, and what its parameters
// mean.
#pragma once

#include <span>
#include <string_view>

namespace dripfeed::json {

struct ApiTag {
  std::string_view name;
  std::string_view about;
};
// The groups, in the order of the reference.
std::span<const ApiTag> api_tags();
// The group of a path; "" where no row has it.
std::string_view tag_of(std::string_view path);
// Of a parameter in the path, the query or a header of this route; "" where no row has it.
std::string_view parameter_about(std::string_view path, std::string_view name);

}  // namespace dripfeed::json

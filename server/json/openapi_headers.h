// The headers of answers, each once; the routes name them.
#pragma once

#include <string_view>

namespace dripfeed::json {

struct ApiHeader {
  std::string_view name;
  std::string_view about;
  std::string_view pattern = "";  // ECMA 262; "": any text
  bool is_seconds = false;
};

// A name that is not in the table ends the program: a test writes the document of every route.
const ApiHeader& api_header(std::string_view name);

}  // namespace dripfeed::json

// Reserved words of which the parser needs to know the role only: words with names that are kept as written, functions
// and statements that are not read, standard cycles, attributes.
#pragma once

#include <span>
#include <string_view>

#include "dialects/sinumerik/keywords.h"

namespace dripfeed::sinumerik {

struct PlainNames {
  Role role = Role::native;
  std::span<const std::string_view> names;
};

std::span<const PlainNames> plain_names();

}  // namespace dripfeed::sinumerik

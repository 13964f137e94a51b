// Taking a new name from the text: shape, keywords and doubles are checked in one place for parameters, lets and loops.
#pragma once

#include <optional>

#include "dialects/family/cursor.h"
#include "dialects/family/scope.h"

namespace dripfeed::family {

struct NewName {
  std::string name;
  text::Span span;
};

// A name that may be defined here; nothing after a fault.
std::optional<NewName> expect_new_name(Cursor& cursor, const Scope& scope);

}  // namespace dripfeed::family

// What the definition files next to a program declare for every program of the control: global data and macros. Names
// are in upper case.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "dialects/ir/statement.h"

namespace dripfeed::ir {

struct SharedVariable {
  ValueType type = ValueType::real;
  std::array<std::uint16_t, 3> dimensions = {};  // 0: none
};

struct SharedDefinitions {
  std::map<std::string, SharedVariable, std::less<>> variables;
  std::map<std::string, std::string, std::less<>> macros;  // the text that the name stands for
};

// `shared` may be nullptr: then no name is.
inline bool is_shared(const SharedDefinitions* shared, std::string_view name) {
  return shared != nullptr && (shared->variables.contains(name) || shared->macros.contains(name));
}

}  // namespace dripfeed::ir

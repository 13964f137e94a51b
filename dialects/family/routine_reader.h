// A family's own functions and subprograms.
//   function NAME(NAME kind, ...) = value or condition
//   sub NAME(NAME kind, ...) ... end
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dialects/family/cursor.h"
#include "dialects/family/expression_reader.h"
#include "dialects/family/model.h"
#include "dialects/family/scope.h"

namespace dripfeed::family {

class RoutineReader {
 public:
  RoutineReader(Cursor& cursor, Scope& scope, ExpressionReader& expressions, Family& family)
      : cursor_(cursor), scope_(scope), expressions_(expressions), family_(family) {}

  // Each reads what follows its keyword; a function but for the end of its line, a subprogram with its `end`.
  void function();
  void subprogram();
  // A kind of quantity; feeds and speeds, which are of two kinds, with a unit. Nothing after a fault.
  std::optional<Dimension> dimension();

 private:
  // A name that no function and no subprogram has yet; nothing after a fault.
  std::optional<std::string> new_name();
  // "(" NAME kind, ... ")"; defines the names. None without brackets.
  std::vector<FunctionParameter> parameters();

  Cursor& cursor_;
  Scope& scope_;
  ExpressionReader& expressions_;
  Family& family_;
};

}  // namespace dripfeed::family

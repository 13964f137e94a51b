// Declarations of the drawing that people see next to a family's values: its lines, and where its parameters are seen.
#pragma once

#include <string_view>

#include "dialects/family/cursor.h"
#include "dialects/family/expression_reader.h"
#include "dialects/family/model.h"
#include "dialects/family/scope.h"

namespace dripfeed::family {

// Each call stands after the first word of its declaration and reads the rest of the line, but for its end.
class DrawingReader {
 public:
  DrawingReader(Cursor& cursor, Scope& scope, ExpressionReader& expressions, Family& family)
      : cursor_(cursor), scope_(scope), expressions_(expressions), family_(family) {}

  // outline [for NAME in A .. B] (circle at P diameter D | from P to P {to P} [closed])
  void outline();
  // dimension PARAMETER (length | diameter | radius) from P to P, or dimension PARAMETER angle at P from P to P
  void dimension();

 private:
  void figure(OutlineShape& out);
  // After that word. The first place of a declaration decides its axes.
  DrawnPlace place(std::string_view word, std::string_view& axes);
  [[nodiscard]] std::string_view axes_of(std::string_view one, std::string_view other) const;

  Cursor& cursor_;
  Scope& scope_;
  ExpressionReader& expressions_;
  Family& family_;
};

}  // namespace dripfeed::family

// Declarations of nominal geometry: profiles of lathes, surfaces and plane curves of mills.
#pragma once

#include <functional>
#include <initializer_list>
#include <string_view>

#include "dialects/family/cursor.h"
#include "dialects/family/expression_reader.h"
#include "dialects/family/model.h"
#include "dialects/family/scope.h"

namespace dripfeed::family {

// Each call stands after `nominal` and reads the rest of its declaration, but for the end of its last line.
class NominalReader {
 public:
  NominalReader(Cursor& cursor, Scope& scope, ExpressionReader& expressions, Family& family)
      : cursor_(cursor), scope_(scope), expressions_(expressions), family_(family) {}

  void profile();
  void of_mill();

 private:
  void surface();
  void nurbs_surface();
  void surface_line(NurbsSurfaceShape& out);
  void curve_line(CurveShape& out);
  // The lines of a declaration and its end. False: a fault in one of them was reported.
  bool lines_to_end(const std::function<void()>& read_line);
  void expect_list(Dimension dimension, ir::SymbolId& into);
  void formula_curve(CurveShape out);
  void point_curve(CurveShape out);
  void point(CurveShape& out);
  void points(CurveShape& out);
  std::int32_t order();
  bool accept_list(Dimension dimension, ir::SymbolId& into);
  // "in" a ".." b, both of that dimension.
  ExpressionRange range(Dimension dimension);
  void tolerance(ir::ExpressionId& out);
  // A length that is calculated without interpolating by the name: places are measured between its corners.
  ir::ExpressionId formula_by(std::initializer_list<ir::SymbolId> names);
  void add(CurveShape out, text::Span head);
  ir::SymbolId axis(ir::SymbolId& known, std::string_view name);

  Cursor& cursor_;
  Scope& scope_;
  ExpressionReader& expressions_;
  Family& family_;
};

}  // namespace dripfeed::family

// A family as it was read: names, geometry and the steps of the body, flat, with every expression in one arena. All
// expressions hold stored units (unit.h) and name variables of bank `named`. Values are given by bind, programs by
// build.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dialects/family/unit.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/statement.h"
#include "dialects/text/source.h"

namespace dripfeed::family {

struct Parameter {
  std::string name;
  Dimension dimension = {};
  bool whole = false;          // count: whole numbers only
  const Unit* unit = nullptr;  // as its default was written; nullptr for count and ratio
  double standard = 0.0;       // the default, stored unit
  double low = 0.0;            // stored unit
  double high = 0.0;
  std::string text = {};  // what it is, for people; may be empty
  ir::SymbolId symbol = ir::SymbolId::none;
  text::Span span;  // of its name
};

// `let name = value` before the body. `line` is 1-based.
struct Definition {
  ir::SymbolId symbol = ir::SymbolId::none;
  ir::ExpressionId value = ir::ExpressionId::none;
  std::uint32_t line = 0;
};

struct Requirement {
  ir::ExpressionId condition = ir::ExpressionId::none;
  text::Span span;   // of the condition
  std::string text;  // after it, for people; may be empty
};

struct ExpressionRange {
  ir::ExpressionId low = ir::ExpressionId::none;
  ir::ExpressionId high = ir::ExpressionId::none;
};

enum class StockKind : std::uint8_t { cylinder, box };
struct StockShape {
  StockKind kind = StockKind::cylinder;
  ir::ExpressionId diameter = ir::ExpressionId::none;  // cylinder
  ir::ExpressionId bore = ir::ExpressionId::none;      // cylinder; none: solid
  ExpressionRange x, y;                                // box
  ExpressionRange z = {};
};

// x = f(z) over a range of z. Several follow one another.
struct NominalShape {
  ir::ExpressionId x = ir::ExpressionId::none;
  ExpressionRange z = {};
  ir::ExpressionId tolerance = ir::ExpressionId::none;
  std::uint32_t line = 0;
};

// z = f(x, y) over a region of the plane. Later ones are carved into earlier ones.
struct SurfaceShape {
  ir::ExpressionId z = ir::ExpressionId::none;
  ExpressionRange x = {};
  ExpressionRange y = {};  // may depend on x
  ir::ExpressionId tolerance = ir::ExpressionId::none;
  std::uint32_t line = 0;
};

struct CurvePoint {
  ir::ExpressionId x = ir::ExpressionId::none;
  ir::ExpressionId y = ir::ExpressionId::none;
  ir::ExpressionId weight = ir::ExpressionId::none;  // none: 1
};

// A curve of the x-y plane: by formulas of a parameter, or by the points of a Bezier or NURBS curve.
struct CurveShape {
  ir::SymbolId parameter = ir::SymbolId::none;  // formulas
  ExpressionRange t = {};
  ir::ExpressionId x = ir::ExpressionId::none;
  ir::ExpressionId y = ir::ExpressionId::none;
  std::int32_t order = 0;  // points: degree + 1; 0: Bezier, as many as points
  std::vector<CurvePoint> points;
  std::vector<ir::ExpressionId> knots;  // empty: clamped and uniform
  bool of_center = false;               // where the tool's centre goes, not what it leaves
  ir::ExpressionId tolerance = ir::ExpressionId::none;
  std::uint32_t line = 0;
  text::Span span;
};

enum class StepKind : std::uint8_t {
  work_offset,  // number
  tool,         // number; nose radius, tip; values[0] diameter, values[1] corner radius
  spindle,      // values[0] rpm or m/min; values[1] limit
  spindle_off,
  coolant,     // number: CoolantState
  compensate,  // number: CompSide; takes effect with the next rapid or cut
  feed,        // values[0]
  rapid,
  cut,
  arc_cw,
  arc_ccw,  // words
  profile_begin,
  profile_end,
  for_begin,  // target; values: from, to, step
  for_end,
  if_begin,  // values[0]
  if_else,
  if_end,
  let,      // target = values[0]
  message,  // text
  dwell,    // values[0]
  stop,
  optional_stop,
};

struct StepWord {
  ir::Address address = ir::Address::x;
  ir::ExpressionId value = ir::ExpressionId::none;
};

// One verb of the body. Which fields count is by kind, as written there.
struct Step {
  StepKind kind = StepKind::stop;
  std::uint32_t line = 0;  // 1-based
  text::Span span = {};
  std::int32_t number = 0;
  Dimension dimension;                          // feed, spindle: of values[0]
  ir::Function direction = ir::Function::none;  // spindle: spindle_cw, spindle_ccw, none
  bool down = false;                            // for
  ir::SymbolId target = ir::SymbolId::none;
  ir::ExpressionId values[3] = {ir::ExpressionId::none, ir::ExpressionId::none, ir::ExpressionId::none};
  std::uint32_t first_word = 0;  // Family::words
  std::uint32_t word_count = 0;
  std::string text;
  double nose_radius_mm = 0.0;  // tool: 0 when not given
  std::int32_t tip = 0;         // tool: imaginary tip 0..9
};

struct LineRange {
  std::uint32_t first = 0;  // 1-based, both included
  std::uint32_t last = 0;
};

struct Family {
  std::string name;   // "hyperbolic-roll"
  std::string title;  // for people; may be empty
  text::Source source;
  ir::MachineKind machine = ir::MachineKind::mill;
  bool x_is_diameter = false;
  std::string program_name;  // after `program`
  std::uint32_t program_line = 0;

  std::vector<Parameter> parameters;
  std::vector<Definition> definitions;
  std::vector<Requirement> requirements;
  std::optional<StockShape> stock;
  std::vector<NominalShape> nominals;
  std::vector<SurfaceShape> surfaces;
  std::vector<CurveShape> curves;
  // x, y and z of the nominals, where they are used.
  ir::SymbolId x_variable = ir::SymbolId::none;
  ir::SymbolId y_variable = ir::SymbolId::none;
  ir::SymbolId z_variable = ir::SymbolId::none;

  std::vector<Step> steps;
  std::vector<StepWord> words;
  std::vector<LineRange> profiles;  // lines between `profile` and its `end`

  // Expressions, variables, symbols and strings; it has no statements.
  ir::Program arena;

  [[nodiscard]] const Parameter* find_parameter(std::string_view parameter_name) const;
};

// "120 mm", "3": a stored value in the unit of the parameter's default.
std::string format_value(const Parameter& parameter, double stored);
// Arguments of family_value_out_of_range.
std::vector<std::string> range_arguments(const Parameter& parameter, double stored);
bool is_whole(double value);

}  // namespace dripfeed::family

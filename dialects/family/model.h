// A family as it was read: names, geometry and the steps of the body, flat, with every expression in one arena. All
// expressions hold stored units (unit.h) and name variables of bank `named`. Values are given by bind, programs by
// build.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/family/contour.h"
#include "dialects/family/native_text.h"
#include "dialects/family/unit.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/statement.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::family {

// number: a quantity or a count; tool: the number of one. choice and yes_no are decided when the program is built.
// text: a name, for messages and comments.
enum class ParameterKind : std::uint8_t { number, choice, yes_no, tool, list, text };

struct Parameter {
  std::string name;
  ParameterKind kind = ParameterKind::number;
  std::string_view quantity;           // number, list: "length", as it was written
  Dimension dimension = {};            // lists: of each number
  bool whole = false;                  // count, tool: whole numbers only
  const Unit* unit = nullptr;          // as its default was written; nullptr for count and ratio
  double standard = 0.0;               // the default, stored unit; choice: its place in `choices`; yes_no: 1 or 0
  std::vector<double> standards = {};  // list: the default
  std::string standard_text = {};      // text: the default
  double low = 0.0;                    // stored unit
  double high = 0.0;
  double step = 0.0;        // stored unit; values are low + a whole number of steps; 0: any
  std::int32_t fewest = 0;  // how many numbers a list or characters a text has
  std::int32_t most = 0;
  std::vector<std::string> choices = {};  // words
  std::string text = {};                  // what it is, for people; may be empty
  std::string group = {};                 // heading under which forms show it; may be empty
  ir::SymbolId symbol = ir::SymbolId::none;
  text::Span span;  // of its name
};

// Numbers of one kind, counted from 0: consecutive variables at the control.
struct List {
  ir::SymbolId symbol = ir::SymbolId::none;
  ir::SymbolId count = ir::SymbolId::none;  // how many there are, as a name that expressions use
  Dimension dimension;
  std::vector<ir::ExpressionId> elements;  // empty for a parameter and for numbers that the program sets
  std::int32_t size = 0;                   // of the latter
  std::uint32_t line = 0;
  bool counts_chords = false;  // of a curve, by piece: see ChordedCurve
  std::int32_t curve = -1;     // row of Family::point_curves that its numbers are found from; -1: none
};

// A list of points: one list parameter an axis, "corners.x" and "corners.y", of equal length.
struct PointParameter {
  std::string name;         // "corners"
  std::uint32_t first = 0;  // row of Family::parameters
  std::string_view axes;    // "xy": one letter a row
  text::Span span;
};

// `let name = value` or `const name = value` before the body. `line` is 1-based.
struct Definition {
  ir::SymbolId symbol = ir::SymbolId::none;
  ir::ExpressionId value = ir::ExpressionId::none;
  std::uint32_t line = 0;
  bool is_constant = false;
};

// function name(parameters) = value. Where it is used, its value stands with the arguments in it.
struct FunctionParameter {
  ir::SymbolId symbol = ir::SymbolId::none;
  Dimension dimension;
  std::uint32_t uses = 0;  // places of the value that name it
};
struct UserFunction {
  std::string name;
  std::vector<FunctionParameter> parameters;
  ir::ExpressionId value = ir::ExpressionId::none;
  Dimension dimension;
  bool is_condition = false;
  std::uint32_t size = 0;  // nodes of its tree
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

// A NURBS surface by lists: points row by row, a row along v. It stands among the surfaces by its line.
struct NurbsSurfaceShape {
  std::int32_t order = 0;
  ir::ExpressionId row = ir::ExpressionId::none;  // points of a row
  ir::SymbolId x_list = ir::SymbolId::none;
  ir::SymbolId y_list = ir::SymbolId::none;
  ir::SymbolId z_list = ir::SymbolId::none;
  ir::SymbolId weight_list = ir::SymbolId::none;  // none: all 1
  ir::SymbolId knot_u_list = ir::SymbolId::none;  // none: clamped and uniform, and so is the other
  ir::SymbolId knot_v_list = ir::SymbolId::none;
  ir::ExpressionId tolerance = ir::ExpressionId::none;
  std::uint32_t line = 0;
  text::Span span;
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
  // Or of all points, their weights and the knots as lists; none where there is no such list.
  ir::SymbolId x_list = ir::SymbolId::none;
  ir::SymbolId y_list = ir::SymbolId::none;
  ir::SymbolId weight_list = ir::SymbolId::none;
  ir::SymbolId knot_list = ir::SymbolId::none;
  bool of_center = false;  // where the tool's centre goes, not what it leaves
  ir::ExpressionId tolerance = ir::ExpressionId::none;
  std::uint32_t line = 0;
  text::Span span;
};

// `cut along ... within`: a curve whose chords lie no farther from it than `error`. It is cut in pieces that are equal
// in its parameter, each with a count of chords of its own, which bind finds.
inline constexpr std::int32_t kCurvePieces = 8;
struct ChordedCurve {
  ir::SymbolId parameter = ir::SymbolId::none;
  ExpressionRange t = {};  // from where to where, as it is cut
  ir::ExpressionId error = ir::ExpressionId::none;
  ir::SymbolId counts = ir::SymbolId::none;  // a list of kCurvePieces
  std::uint32_t first_word = 0;              // Family::words
  std::uint32_t word_count = 0;
  text::Span span;
};

// `cut along bezier` and `cut along nurbs`: points, weights and knots are lists that no step changes. Within an error
// it has kSpanPieces counts of chords between two knots, which bind finds, none between knots that are equal.
inline constexpr std::int32_t kSpanPieces = 4;
struct PointCurve {
  struct Axis {
    ir::Address address = ir::Address::x;
    ir::SymbolId list = ir::SymbolId::none;
  };
  std::int32_t order = 0;                     // degree + 1; 0: Bezier, as many as points
  std::vector<Axis> axes;                     // two or three
  ir::SymbolId weights = ir::SymbolId::none;  // none: all 1
  ir::SymbolId knots = ir::SymbolId::none;    // Bezier: none
  bool has_own_knots = false;                 // clamped and uniform, found by bind
  ir::ExpressionId error = ir::ExpressionId::none;
  ir::SymbolId counts = ir::SymbolId::none;  // none: equal steps
  text::Span span;
  [[nodiscard]] bool is_bezier() const { return order == 0; }
};

// A place of the drawing. Its view has two of the axes, the first one across: lathes have z and x, mills x and y, x and
// z or y and z.
struct DrawnPlace {
  ir::ExpressionId across = ir::ExpressionId::none;
  ir::ExpressionId up = ir::ExpressionId::none;
};

// One line, or one circle, of the drawing; with a counter one for each of its whole numbers.
struct OutlineShape {
  std::string_view axes;                               // "zx"
  std::vector<DrawnPlace> places;                      // circle: its center
  ir::ExpressionId diameter = ir::ExpressionId::none;  // circle
  bool is_closed = false;
  ir::SymbolId counter = ir::SymbolId::none;
  ExpressionRange counts = {};
};

enum class DimensionKind : std::uint8_t { length, diameter, radius, angle };
inline constexpr std::array<std::string_view, 4> kDimensionKindNames = {"length", "diameter", "radius", "angle"};

// Where a parameter is seen in the drawing.
struct DimensionShape {
  DimensionKind kind = DimensionKind::length;
  std::size_t parameter = 0;  // row of Family::parameters
  std::string_view axes;
  DrawnPlace from, to;
  DrawnPlace at = {};  // angle: its corner
};

enum class StepKind : std::uint8_t {
  work_offset,  // number
  tool,         // number; tip; values[0] diameter, values[1] corner radius, values[2] nose radius
  spindle,      // values[0] rpm or m/min; values[1] limit
  spindle_off,
  coolant,     // number: CoolantState
  compensate,  // number: CompSide; takes effect with the next rapid or cut
  feed,        // values[0]; number: 0, kPassingFeed or kFeedBefore
  rapid,
  cut,
  arc_cw,
  arc_ccw,      // words
  thread,       // words, with f: the pitch
  drill_begin,  // number: ir::DrillCycle; words r, z, q, f, p: levels, peck, pitch, dwell; values[0] return level
  hole,         // words
  drill_end,
  engrave,  // target: a text; words x, y: its place, q: height, z: depth, r: return level
  profile_begin,
  profile_end,
  for_begin,  // target; values: from, to, step
  for_end,
  for_in_begin,  // target; number: row of Family::lists
  for_in_end,
  while_begin,  // values[0]
  while_end,
  if_begin,  // values[0]
  if_else,
  if_end,
  let,      // target = values[0]
  set,      // target = values[0], or target[values[1]] of a list
  message,  // text
  dwell,    // values[0]
  stop,
  optional_stop,
  plane,        // number: 0 xy, 1 zx, 2 yz
  native,       // number: row of Family::natives
  require,      // values[0]: a condition that a verb's values fulfil; text; or equal steps, see check_equal_steps
  contour,      // number: row of Family::contours, which its values fulfil
  offset,       // number: row of Family::offsets, likewise
  polar_begin,  // y is a length across x on the face, until the end
  polar_end,
  cylinder_begin,  // values[0]: its diameter; y is a length on its circumference
  cylinder_end,
};

// Of a feed: it counts until kFeedBefore, which gives back the one before it.
inline constexpr std::int32_t kPassingFeed = 1;
inline constexpr std::int32_t kFeedBefore = 2;
// Of an if_begin: its condition is decided when the family gets its values.
inline constexpr std::int32_t kCornerBranch = 1;

// A block of the controls' own languages, word for word.
struct NativeVerb {
  struct Row {
    std::string dialect;
    std::string text;
  };
  std::vector<Row> rows;
  bool changes_motion = false;  // what is in effect after it is not known
  bool changes_feed = false;
  text::Span span;
  // nullptr: it has no text for that language.
  [[nodiscard]] const Row* find(std::string_view dialect) const;
};
// In a built program this M function stands for row n of Family::natives; what is printed has its text instead.
inline constexpr std::int16_t kFirstNativeFunction = 30'000;
inline constexpr std::size_t kMostNatives = 1000;

struct StepWord {
  ir::Address address = ir::Address::x;
  ir::ExpressionId value = ir::ExpressionId::none;
  bool is_step = false;  // of an axis: from where it is
};

// One verb of the body. Which fields count is by kind, as written there.
struct Step {
  StepKind kind = StepKind::stop;
  std::uint32_t line = 0;  // 1-based
  text::Span span = {};
  std::int32_t number = 0;                      // tool: 0 when `target` is a parameter
  Dimension dimension;                          // feed, spindle: of values[0]
  ir::Function direction = ir::Function::none;  // spindle: spindle_cw, spindle_ccw, none
  bool down = false;                            // for
  ir::SymbolId target = ir::SymbolId::none;
  ir::ExpressionId values[3] = {ir::ExpressionId::none, ir::ExpressionId::none, ir::ExpressionId::none};
  std::uint32_t first_word = 0;  // Family::words
  std::uint32_t word_count = 0;
  std::string text;
  std::int32_t tip = 0;         // tool: imaginary tip 0..9
  std::uint8_t skip_level = 0;  // block skip of its blocks; 0: they have none
  bool begins_pocket = false;   // the first step of that verb
  text::Span mirrored_by = {};  // the mirrored block that reverses the direction of milling; empty: none does
};

// Whether it begins the cycle of a tap.
bool begins_taps(const Step& step);
// Whether its pitch takes the place of the feed, which must be written again after it.
bool takes_feed_away(const Step& step);
// Of a word of drill_begin: whether it is a number in the text, which no variable stands for (pitch, dwell).
bool is_number_of_cycle(ir::Address address);

// Its steps stand wherever it is called, after the assignments of its arguments.
struct Subprogram {
  std::string name;
  std::vector<FunctionParameter> parameters;
  std::vector<Step> steps;
  bool needs_feed = false;  // it cuts before it sets a feed
  bool sets_feed = false;
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
  text::Span machine_span;  // of its word
  bool x_is_diameter = false;
  std::string program_name;  // after `program`
  std::uint32_t program_line = 0;

  std::vector<Parameter> parameters;
  std::vector<PointParameter> points;
  std::vector<Definition> definitions;
  std::vector<List> lists;
  std::vector<UserFunction> functions;
  std::map<std::string, std::size_t, std::less<>> function_rows;    // by name
  std::map<std::string, std::size_t, std::less<>> subprogram_rows;  // by name
  std::vector<Requirement> requirements;
  std::optional<StockShape> stock;
  std::vector<NominalShape> nominals;
  std::vector<SurfaceShape> surfaces;
  std::vector<NurbsSurfaceShape> nurbs_surfaces;
  std::vector<CurveShape> curves;
  std::vector<ChordedCurve> chorded;
  std::vector<PointCurve> point_curves;
  std::vector<RoughContour> contours;
  std::vector<OffsetContour> offsets;
  std::vector<OutlineShape> outlines;
  std::vector<DimensionShape> dimensions;
  // x, y and z of the nominals, where they are used.
  ir::SymbolId x_variable = ir::SymbolId::none;
  ir::SymbolId y_variable = ir::SymbolId::none;
  ir::SymbolId z_variable = ir::SymbolId::none;

  std::vector<Subprogram> subprograms;
  std::vector<Step> steps;
  std::vector<StepWord> words;
  std::vector<NativeVerb> natives;
  std::vector<LineRange> profiles;  // lines between `profile` and its `end`

  std::optional<NativeText> native;  // instead of the steps
  std::vector<Binding> bindings;     // in the order of the text

  // Expressions, variables, symbols and strings; it has no statements.
  ir::Program arena;

  [[nodiscard]] const Parameter* find_parameter(std::string_view parameter_name) const;
  [[nodiscard]] const PointParameter* find_points(std::string_view points_name) const;
  // nullptr when none is so called.
  [[nodiscard]] const UserFunction* find_function(std::string_view routine_name) const;
  [[nodiscard]] const Subprogram* find_subprogram(std::string_view routine_name) const;
  void add(UserFunction function);
  void add(Subprogram subprogram);
  // nullptr for what is not a list.
  [[nodiscard]] const List* find_list(ir::SymbolId symbol) const;
};

// "length", "list of length", "choice": as `param` lines name it.
std::string kind_of(const Parameter& parameter);
// The default as one would write it: "100 mm", "10 mm, 12 mm", "rough", the text itself.
std::string format_standard(const Parameter& parameter);
// "120 mm", "3": a stored value in the unit of the parameter's default.
std::string format_value(const Parameter& parameter, double stored);
// What forbids a stored value, or one number of a list: beyond the range, between the steps, no whole number. `written`
// is the value as a person wrote it.
struct ValueFault {
  text::DiagnosticId id;
  std::vector<std::string> arguments;
};
std::optional<ValueFault> fault_of_value(const Parameter& parameter, double stored, const std::string& written);
bool is_whole(double value);

}  // namespace dripfeed::family

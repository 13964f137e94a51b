// The body of a family, from after `program NAME` to its `end`: verbs become steps, blocks are matched.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/family/cursor.h"
#include "dialects/family/expression_reader.h"
#include "dialects/family/model.h"
#include "dialects/family/naming.h"
#include "dialects/family/scope.h"
#include "dialects/family/verb_copy.h"
#include "dialects/ir/cycle.h"

namespace dripfeed::family {

// Moves are read in body_reader.cpp, what the machine switches in machine_reader.cpp, its drilling cycles in
// drill_reader.cpp, grooves and whole threads in turning_reader.cpp, curves in along_reader.cpp and
// point_curve_reader.cpp, faces and pockets in milling_reader.cpp, roughing in rough_reader.cpp, offsets in
// offset_reader.cpp, native text in native_verb_reader.cpp, mirrored and repeated moves in copies_reader.cpp, faces and
// cylinders in face_reader.cpp, blocks, assignments and calls in flow_reader.cpp.
class BodyReader {
 public:
  // The steps go to `steps`.
  BodyReader(Cursor& cursor, Scope& scope, ExpressionReader& expressions, Family& family, std::vector<Step>& steps)
      : cursor_(cursor), scope_(scope), expressions_(expressions), family_(family), steps_(steps) {}

  // Reads up to and with the `end` of the program, or reports that it is missing.
  void read();
  // The same of a subprogram, which stands at `head`: its caller may have set the feed.
  void read_subprogram(text::Span head);
  [[nodiscard]] bool has_feed() const { return has_feed_; }
  [[nodiscard]] bool needs_feed() const { return needs_feed_; }

 private:
  using Verb = void (BodyReader::*)();
  struct VerbRow {
    std::string_view word;
    Verb read;
  };
  static std::span<const VerbRow> verb_rows();
  static const VerbRow* find_verb(std::string_view word);
  static std::vector<std::string_view> verbs();

  void work_offset();
  void tool();
  void spindle();
  void coolant();
  void compensate();
  void feed();
  void rapid();
  void cut();
  void arc();
  void thread();
  void groove();
  void engrave();
  void face();
  void pocket();
  void rough();
  void offset();
  void retract();
  void drill();
  void ream();
  void bore();
  void tap();
  void hole();
  void profile();
  void for_loop();
  void for_in(const NewName& name);
  void while_loop();
  void if_block();
  void else_block();
  void end();
  void let();
  void set();
  void call();
  void message();
  void dwell();
  void stop();
  void optional_stop();
  void skip();
  void plane();
  void native();
  void mirror();
  void repeat();
  void polar();
  void cylinder();

  // Steps that stand for a verb.
  struct Groove {
    bool inside = false;
    bool down = false;  // from z to last_z
    ir::ExpressionId from = ir::ExpressionId::none;
    ir::ExpressionId to = ir::ExpressionId::none;
    ir::ExpressionId z = ir::ExpressionId::none;
    ir::ExpressionId last_z = ir::ExpressionId::none;  // none: one plunge
    ir::ExpressionId step = ir::ExpressionId::none;
    ir::ExpressionId peck = ir::ExpressionId::none;
    ir::ExpressionId dwell = ir::ExpressionId::none;
  };
  // A curve by its parameter, which takes the values of a loop.
  struct Along {
    Step loop;  // from, to
    Step cut;
    Dimension dimension;  // of the parameter
  };
  void cut_along();
  void equal_steps(const Along& along, ir::ExpressionId count);
  void chords(const Along& along, ir::ExpressionId error);
  ir::SymbolId chord_list(const Along& along, ir::ExpressionId error);
  ir::ExpressionId span_of(const Step& loop);

  // A block whose moves are mirrored or repeated, see copies_reader.cpp.
  struct Copies {
    bool is_repeat = false;
    ir::Address address = ir::Address::x;         // mirrored
    ir::ExpressionId x = ir::ExpressionId::none;  // mirrored: where; turned: the center; shifted: how far
    ir::ExpressionId y = ir::ExpressionId::none;
    ir::ExpressionId z = ir::ExpressionId::none;
    ir::ExpressionId angle = ir::ExpressionId::none;
    ir::ExpressionId cosine = ir::ExpressionId::none;  // turned
    ir::ExpressionId sine = ir::ExpressionId::none;
    std::size_t first_step = 0;
    [[nodiscard]] bool mirrors() const { return !is_repeat; }
  };
  [[nodiscard]] bool may_copy();
  void end_copies(const Copies& copies, text::Span head);
  void warn_of_reversed_milling();
  bool mirror_words(const Copies& copies, Step& step, std::vector<StepWord>& words);
  bool shift_words(const Copies& copies, std::vector<StepWord>& words);
  bool turn_words(const Copies& copies, std::vector<StepWord>& words);

  // A curve by its points, see point_curve_reader.cpp.
  struct PointScheme {
    PointCurve curve;
    ir::ExpressionId order = ir::ExpressionId::none;
    ir::ExpressionId count = ir::ExpressionId::none;  // of points
    std::vector<ir::SymbolId> rows;                   // of the scheme, an axis each, and last that of the weights
    ir::ExpressionId first = ir::ExpressionId::none;  // of the points that count; none: all do
  };
  void cut_along_points(bool is_bezier);
  bool read_points(PointCurve& curve);
  ir::SymbolId expect_list(Dimension dimension);
  ir::SymbolId hidden_list(std::string_view stem, Dimension dimension, std::int32_t size, bool counts_chords = false);
  PointScheme scheme_of(PointCurve curve);
  void equal_point_steps(PointScheme& scheme, ir::ExpressionId count);
  void point_chords(PointScheme& scheme);
  void cut_point(const PointScheme& scheme, ir::ExpressionId t);
  ir::ExpressionId knot(const PointScheme& scheme, ir::ExpressionId at);
  ir::ExpressionId knot_ends(const PointScheme& scheme, bool last);
  ir::ExpressionId number(double value) { return family_.arena.add_constant(value, verb_); }
  void set_number(ir::SymbolId list, ir::ExpressionId index, ir::ExpressionId value);
  ir::ExpressionId count_hidden_down(std::string_view stem, ir::ExpressionId first, ir::ExpressionId last);
  void while_hidden(ir::Operator op, ir::ExpressionId a, ir::ExpressionId b);

  // Verbs of the library: what is read of them, in the order of its parameters.
  struct LibraryVerb {
    std::vector<ir::ExpressionId> arguments;
    std::optional<VerbFeeds> feeds = std::nullopt;
    bool swaps_axes = false;
    bool is_pocket = false;
  };
  struct VerbRule {
    std::string_view function;
    std::vector<std::size_t> arguments;
    std::string_view text;
  };
  [[nodiscard]] bool may_mill(std::string_view verb);
  bool clause(LibraryVerb& verb, std::string_view word, Dimension dimension = kLength);
  bool next_clause(LibraryVerb& verb, std::string_view word);
  void entry_feed(LibraryVerb& verb);
  void write(std::string_view subprogram, const LibraryVerb& verb, std::span<const VerbRule> rules);

  // A contour that is roughed, see rough_reader.cpp.
  struct RoughPoint {
    ir::ExpressionId x = ir::ExpressionId::none;  // with the allowance
    ir::ExpressionId z = ir::ExpressionId::none;
    bool moves_x = true;
    bool moves_z = true;
    bool is_arc = false;
    bool clockwise = false;
    ir::ExpressionId i = ir::ExpressionId::none;
    ir::ExpressionId k = ir::ExpressionId::none;
    ir::ExpressionId radius = ir::ExpressionId::none;
    ir::ExpressionId center_x = ir::ExpressionId::none;
    ir::ExpressionId center_z = ir::ExpressionId::none;
    ir::ExpressionId when = ir::ExpressionId::none;  // none: always
    std::uint32_t line = 0;
  };
  struct Rough {
    RoughContour contour;
    Step head;
    std::size_t first_step = 0;
    std::set<ir::SymbolId> changing = {};
  };
  void end_rough();
  bool read_contour(Rough& rough, const std::vector<Step>& steps, std::vector<RoughPoint>& points);
  static std::set<ir::SymbolId> assigned_twice(const std::vector<Step>& steps);
  [[nodiscard]] bool names_one(const std::set<ir::SymbolId>& symbols, ir::ExpressionId value) const;
  bool add_point(Rough& rough, const Step& step, std::vector<RoughPoint>& points);
  ir::ExpressionId point_value(const Rough& rough, std::string_view stem, ir::ExpressionId value, bool is_x);
  void find_center(RoughPoint& point, const RoughPoint& before);
  void rough_passes(const Rough& rough, const std::vector<RoughPoint>& points);
  ir::ExpressionId pass_end(const Rough& rough, const std::vector<RoughPoint>& points, ir::ExpressionId level);
  void pass_end_at(const Rough& rough, const RoughPoint& from, const RoughPoint& to, ir::ExpressionId level,
                   const Step& end);
  void last_rough_pass(const Rough& rough, const std::vector<RoughPoint>& points);
  void leave_rough(const Rough& rough, ir::ExpressionId x, ir::ExpressionId z);
  ir::ExpressionId sum(ir::Operator op, ir::ExpressionId a, ir::ExpressionId b);
  void open_if(ir::Operator op, ir::ExpressionId a, ir::ExpressionId b);
  void open_branch(ir::ExpressionId condition);
  void set_name(ir::SymbolId target, ir::ExpressionId value);

  // A contour that is moved aside, see offset_reader.cpp.
  class OffsetWriter;
  struct Offset {
    bool is_left = false;
    ir::ExpressionId distance = ir::ExpressionId::none;
    Step head;
    std::size_t first_step = 0;
  };
  void end_offset();

  // Polar and cylindrical interpolation, see face_reader.cpp.
  void open_face(StepKind kind, ir::ExpressionId diameter);
  void close_face();
  [[nodiscard]] bool may_stand_on_face(StepKind kind);
  void enter_face(const Step& cut);
  void check_increments();

  // What the last tool, compensation and plane in the order of the text are.
  void tool_changes(ir::ExpressionId diameter);

  void plunge(const Groove& groove);
  void thread_passes(const Step& one, ir::ExpressionId pitch);
  [[nodiscard]] std::string unused_name(std::string_view stem) const;
  Step hidden_loop(std::string_view stem, Dimension dimension);
  void end_hidden_loop();
  ir::ExpressionId kept(std::string_view stem, ir::ExpressionId value, Dimension dimension);
  void move_to(StepKind kind, ir::Address axis, ir::ExpressionId value);
  ir::ExpressionId name_of(const Step& step);
  ir::ExpressionId name_of(ir::SymbolId symbol, ir::ExpressionId index = ir::ExpressionId::none);
  ir::ExpressionId count_hidden(std::string_view stem, double first, ir::ExpressionId last);
  ir::ExpressionId calculated(ir::Operator op, ir::ExpressionId a, ir::ExpressionId b);
  ir::ExpressionId in_x(ir::ExpressionId on_radius);

  // A cycle from its first word to the `end` of its holes.
  void open_drill(ir::DrillCycle cycle);
  void level(Step& step, std::string_view name, ir::Address address);
  bool accept_clause(Step& step, std::string_view name, ir::Address address, Dimension dimension);
  // A fault for what would move or switch among holes.
  [[nodiscard]] bool may_stand_here(StepKind kind);

  [[nodiscard]] bool may_cut();
  Step step(StepKind kind) const;
  void add(Step step);
  void move(Step step);
  void axis_words(Step& step);
  void corner(Step& step);
  void word(Step& step, ir::Address address, Typed value);
  [[nodiscard]] bool at_axis() const;
  [[nodiscard]] bool takes_corner(const Step& step) const;

  // A block that is open: what began it, and where that stands.
  struct Open {
    StepKind kind;
    text::Span span;
    std::uint32_t line;
    bool has_else = false;
    bool changes_tool = false;    // in it
    bool takes_diameter = false;  // a verb in it, of a tool that stands before that verb
    std::optional<Copies> copies = std::nullopt;
  };

  Cursor& cursor_;
  Scope& scope_;
  ExpressionReader& expressions_;
  Family& family_;
  std::vector<Step>& steps_;
  std::vector<Open> open_;
  std::size_t open_profiles_ = 0;  // of those
  std::size_t open_drills_ = 0;
  text::Span verb_;  // first word of the line
  std::uint32_t line_ = 0;
  bool ended_ = false;
  bool has_feed_ = false;
  bool compensation_waits_ = false;  // for a straight move
  bool corner_waits_ = false;        // for the cut after it
  bool surface_speed_ = false;       // of the last spindle above
  bool is_subprogram_ = false;
  bool needs_feed_ = false;
  std::uint8_t skip_level_ = 0;  // of the line
  ir::ExpressionId tool_diameter_ = ir::ExpressionId::none;
  Dimension feed_dimension_ = kFeedPerMin;
  bool compensated_ = false;
  bool other_plane_ = false;
  std::optional<Rough> rough_;    // whose contour is read
  std::optional<Offset> offset_;  // likewise
  bool writes_offset_ = false;    // its steps are added
  std::optional<StepKind> face_;  // what began it; nothing outside of one
  bool on_face_ = false;          // its first cut is read
};

}  // namespace dripfeed::family

// What gives a family its values, in three parts: those of parameters, what follows from them, and whether the steps of
// the program can run with them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "dialects/family/bind.h"
#include "dialects/family/evaluate.h"
#include "dialects/family/model.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::family {

class Binder {
 public:
  Binder(std::shared_ptr<const Family> family, std::span<const Override> overrides)
      : family_(*family), overrides_(overrides) {
    const std::size_t symbols = family_.arena.symbols.size();
    result_.bound = {std::move(family), std::vector<double>(symbols, 0.0), {}};
    known_.assign(symbols, 0);
  }
  BindResult bind();

 private:
  double& value_of(ir::SymbolId symbol) { return result_.bound.values[static_cast<std::size_t>(symbol)]; }
  void know(ir::SymbolId symbol, double value) {
    value_of(symbol) = value;
    known_[static_cast<std::size_t>(symbol)] = 1;
  }
  void report(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments) {
    result_.diagnostics.push_back(text::make_diagnostic(id, span, std::move(arguments)));
  }

  // --- parameters: bind_parameters.cpp
  void parameters();
  // The overrides, with a list of points as one list an axis.
  std::vector<Override> with_axes();
  [[nodiscard]] std::string standard_point(const PointParameter& points) const;
  void check_axes(const PointParameter& points);
  void set(const Parameter& parameter, const std::string& written);
  void set_text(const Parameter& parameter, const std::string& written);
  void set_choice(const Parameter& parameter, const std::string& written);
  // "10 mm, 12 mm"
  void set_list(const Parameter& parameter, const std::string& written);
  // The stored value of a quantity that the parameter may have; nothing after a fault.
  std::optional<double> number_of(const Parameter& parameter, const std::string& written);

  // --- what follows from them: bind.cpp
  // The value, or nothing and a diagnostic at the operation that has none.
  std::optional<double> compute(ir::ExpressionId expression);
  // The points of every interpolation in it: two or more, from left to right, which no step changes.
  bool check_points(ir::ExpressionId id);
  [[nodiscard]] std::string fault_of_points(const PointLists& lists) const;
  void define(const Definition& definition);
  // Its numbers follow all others; see list_in.
  void define(const List& list);
  void check(const Requirement& requirement);
  void check_curve(const CurveShape& curve);
  void check_surface(const NurbsSurfaceShape& surface);
  // Only where the curve depends on nothing of the body its chords are counted before the program runs.
  void count_chords(const ChordedCurve& curve);
  // Checks a curve by its points, and finds the lists that follow from them.
  void find_points(const PointCurve& curve);
  // Numbers of a list, for which there is room.
  void put(ir::SymbolId list, const std::vector<double>& numbers);

  // --- steps: bind_steps.cpp
  // Of verbs that stand for many moves, but not in a branch that these values do not take.
  void check_verbs();
  void check_verb(const Step& step);
  // A require whose number is not 0: of values[0] equal steps of the point curve with that number, counted from 1, none
  // may leave the curve by more than values[1].
  void check_equal_steps(const Step& step);
  void follow(const Step& step);
  void check_offset(const OffsetContour& contour);
  // Those that are known before the program runs.
  void check_indices(const Step& step);
  void check_indices(ir::ExpressionId id);
  void check_index(ir::SymbolId list, ir::ExpressionId index);
  // The shape of a tool is known before the program runs.
  void check_tool(const Step& step);
  // Only loops that depend on nothing of the body are known before the program runs.
  void check_loop(const Step& step);
  // Its pitch is its last word.
  void check_thread(const Step& step);
  void check_cylinder(const Step& step);
  void check_engraving(const Step& step);
  // No control can write what it computes into a message.
  void check_message(const Step& step);
  // Levels that depend on the body are the control's to find; a dwell and a pitch are numbers in the text.
  void check_holes(const Step& step);
  static std::string fault_of_hole(ir::Address address, double value, const std::optional<double>& top);

  const Family& family_;
  std::span<const Override> overrides_;
  BindResult result_;
  std::vector<std::uint8_t> known_;                          // by symbol
  std::set<ir::SymbolId> sets_;                              // what a `set` of the body changes
  std::map<ir::SymbolId, std::vector<double>> given_lists_;  // of parameters
};

}  // namespace dripfeed::family

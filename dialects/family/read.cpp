// The header and the declarations; the body is body_reader's. The order is free between `machine` and `program`, but a
// name must be declared before it is used, so that values can be computed in one pass.
#include "dialects/family/read.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/body_reader.h"
#include "dialects/family/cursor.h"
#include "dialects/family/expression_reader.h"
#include "dialects/family/naming.h"
#include "dialects/family/nominal_reader.h"
#include "dialects/family/scope.h"

namespace dripfeed::family {

namespace {

// What a parameter may be: by its kind the dimensions that its default may have.
struct KindRow {
  std::string_view name;
  std::array<Dimension, 2> dimensions;
  bool whole;
};
constexpr auto kKinds = std::to_array<KindRow>({
    {"length", {kLength, kLength}, false},
    {"angle", {kAngle, kAngle}, false},
    {"feed", {kFeedPerMin, kFeedPerRev}, false},
    {"speed", {kSpeed, kSurfaceSpeed}, false},
    {"time", {kTime, kTime}, false},
    {"count", {kRatio, kRatio}, true},
    {"ratio", {kRatio, kRatio}, false},
});

constexpr std::array<std::pair<std::string_view, ir::MachineKind>, 3> kMachines = {
    {{"lathe", ir::MachineKind::lathe}, {"mill", ir::MachineKind::mill}, {"mill-turn", ir::MachineKind::mill_turn}}};

class FamilyReader {
 public:
  explicit FamilyReader(const text::Source& source)
      : cursor_(source.text(), lex(source.text())), expressions_(cursor_, scope_, family_.arena) {
    family_.source = source;
  }

  ReadFamilyResult read() {
    skip_blank();
    header();
    bool has_program = false;
    while (!cursor_.at_end()) {
      if (cursor_.at_line_end()) {
        cursor_.advance();
      } else if (cursor_.accept_word("program")) {
        if (std::exchange(has_program, true)) cursor_.syntax(cursor_.last_span(), "a family has one program");
        program();
      } else {
        declaration();
      }
    }
    if (!has_program) cursor_.syntax(cursor_.peek().span, "the family has no 'program'");
    return {std::move(family_), std::move(cursor_.diagnostics)};
  }

 private:
  void skip_blank() {
    while (cursor_.at_line_end() && !cursor_.at_end()) cursor_.advance();
  }

  void header() {
    if (cursor_.expect_word("family")) {
      family_.name = cursor_.expect_hyphenated("the family's name");
      if (auto title = cursor_.accept_string()) family_.title = std::move(*title);
    }
    cursor_.finish_line();
    skip_blank();
    if (cursor_.expect_word("machine")) machine();
    cursor_.finish_line();
  }

  void machine() {
    const text::Span at = cursor_.peek().span;
    const std::string kind = cursor_.expect_hyphenated("lathe, mill or mill-turn");
    const auto row = std::ranges::find(kMachines, kind, &std::pair<std::string_view, ir::MachineKind>::first);
    if (row == kMachines.end()) {
      cursor_.syntax(at, fmt::format("expected lathe, mill or mill-turn, found '{}'", kind));
      return;
    }
    family_.machine = row->second;
    const bool stated = cursor_.accept_symbol(",");
    if (stated && cursor_.expect_word("x") && cursor_.expect_word("is")) {
      family_.x_is_diameter = cursor_.accept_word("diameter");
      if (!family_.x_is_diameter) cursor_.expect_word("radius");
    } else if (!stated && family_.machine != ir::MachineKind::mill) {
      cursor_.expected("', x is diameter' or ', x is radius'");
    }
  }

  void declaration() {
    if (cursor_.accept_word("param")) {
      parameter();
    } else if (cursor_.accept_word("let")) {
      definition();
    } else if (cursor_.accept_word("require")) {
      requirement();
    } else if (cursor_.accept_word("stock")) {
      stock();
    } else if (cursor_.accept_word("nominal")) {
      nominal();
    } else {
      cursor_.expected("param, let, require, stock, nominal or program");
    }
    cursor_.finish_line();
  }

  void parameter() {
    const std::optional<NewName> name = expect_new_name(cursor_, scope_);
    if (!name) return;
    const auto kind = std::ranges::find(kKinds, cursor_.word(), &KindRow::name);
    if (kind == kKinds.end()) return cursor_.expected("length, angle, feed, speed, time, count or ratio");
    cursor_.advance();
    Parameter out{.name = name->name, .dimension = kind->dimensions.front(), .whole = kind->whole, .span = name->span};
    parameter_values(out, *kind);
    // The name stays known when its line is wrong, so that its uses are not reported as well.
    out.symbol = scope_.define(family_.arena, out.name, out.dimension, out.span);
    family_.parameters.push_back(std::move(out));
  }

  void parameter_values(Parameter& out, const KindRow& kind) {
    const auto standard = expressions_.literal(true);
    if (!standard || !has_kind(*standard, kind)) return;
    out.unit = standard->unit;
    out.dimension = out.unit == nullptr ? kRatio : out.unit->dimension;
    out.standard = Quantity{standard->written, standard->unit}.stored();
    cursor_.expect_word("in");
    const auto low = bound(out);
    cursor_.expect_symbol("..");
    const auto high = bound(out);
    if (auto text = cursor_.accept_string()) out.text = std::move(*text);
    if (!cursor_.line_failed() && low && high) check_range(out, *standard, *low, *high);
  }

  // The default's unit must be one of the kind's.
  bool has_kind(const Literal& literal, const KindRow& kind) {
    const Dimension found = literal.unit == nullptr ? kRatio : literal.unit->dimension;
    if (std::ranges::find(kind.dimensions, found) != kind.dimensions.end()) return true;
    Typed typed{.dimension = found, .is_bare = literal.unit == nullptr, .span = literal.span};
    return expressions_.require_dimension(typed, kind.dimensions.front());
  }

  // One end of the range, stored unit.
  std::optional<double> bound(const Parameter& parameter) {
    const auto literal = expressions_.literal(parameter.unit != nullptr);
    if (!literal) return std::nullopt;
    const Unit* unit = literal->unit == nullptr ? parameter.unit : literal->unit;
    Typed typed{.dimension = unit == nullptr ? kRatio : unit->dimension, .span = literal->span};
    if (!expressions_.require_dimension(typed, parameter.dimension)) return std::nullopt;
    return Quantity{literal->written, unit}.stored();
  }

  void check_range(Parameter& out, const Literal& standard, double low, double high) {
    out.low = low;
    out.high = high;
    if (low > high) {
      cursor_.syntax(out.span, fmt::format("the range of {} ends before it begins", out.name));
    } else if (out.standard < low || out.standard > high) {
      cursor_.report(text::DiagnosticId::family_value_out_of_range, standard.span, range_arguments(out, out.standard));
    } else if (out.whole && !is_whole(out.standard)) {
      cursor_.report(text::DiagnosticId::family_wrong_unit, standard.span,
                     {std::string(standard.span.in(cursor_.text())), "a fraction", "a whole number"});
    }
  }

  void definition() {
    const std::uint32_t line = cursor_.peek().line;
    const std::optional<NewName> name = expect_new_name(cursor_, scope_);
    if (!name || !cursor_.expect_symbol("=")) return;
    const Typed value = expressions_.value();
    if (cursor_.line_failed()) return;
    const ir::SymbolId symbol = scope_.define(family_.arena, name->name, value.dimension, name->span);
    family_.definitions.push_back({symbol, value.id, line});
  }

  void requirement() {
    const Typed condition = expressions_.condition();
    Requirement out{condition.id, condition.span, {}};
    if (auto text = cursor_.accept_string()) out.text = std::move(*text);
    if (!cursor_.line_failed()) family_.requirements.push_back(std::move(out));
  }

  ExpressionRange range() {
    ExpressionRange out;
    out.low = expressions_.value_of(kLength).id;
    cursor_.expect_symbol("..");
    if (!cursor_.line_failed()) out.high = expressions_.value_of(kLength).id;
    return out;
  }

  void stock() {
    StockShape out;
    if (family_.stock) return cursor_.syntax(cursor_.last_span(), "a family has one stock");
    if (cursor_.accept_word("cylinder")) {
      cursor_.expect_word("diameter");
      out.diameter = expressions_.value_of(kLength).id;
      if (!cursor_.line_failed() && cursor_.accept_word("bore")) out.bore = expressions_.value_of(kLength).id;
    } else if (cursor_.expect_word("box")) {
      out.kind = StockKind::box;
      cursor_.expect_word("x");
      out.x = range();
      if (!cursor_.line_failed() && cursor_.expect_word("y")) out.y = range();
    }
    if (!cursor_.line_failed() && cursor_.expect_word("z")) out.z = range();
    if (!cursor_.line_failed()) family_.stock = out;
  }

  void nominal() {
    const bool turns = family_.machine != ir::MachineKind::mill;
    const bool mills = family_.machine != ir::MachineKind::lathe;
    if (turns && cursor_.at_word("x")) return NominalReader(cursor_, scope_, expressions_, family_).profile();
    if (mills) return NominalReader(cursor_, scope_, expressions_, family_).of_mill();
    cursor_.expected("x = ..., the nominal of a lathe");
  }

  void program() {
    family_.program_line = cursor_.peek().line;
    family_.program_name = cursor_.expect_hyphenated("the program's name");
    cursor_.finish_line();
    BodyReader(cursor_, scope_, expressions_, family_).read();
  }

  Family family_;
  Scope scope_;
  Cursor cursor_;
  ExpressionReader expressions_;
};

}  // namespace

ReadFamilyResult read_family(const text::Source& source) { return FamilyReader(source).read(); }

}  // namespace dripfeed::family

// The header and the declarations; the body is body_reader's. The order is free between `machine` and `program`, but a
// name must be declared before it is used, so that values can be computed in one pass.
#include "dialects/family/read.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/body_reader.h"
#include "dialects/family/cursor.h"
#include "dialects/family/drawing_reader.h"
#include "dialects/family/evaluate.h"
#include "dialects/family/expression_reader.h"
#include "dialects/family/naming.h"
#include "dialects/family/native_reader.h"
#include "dialects/family/native_text.h"
#include "dialects/family/nominal_reader.h"
#include "dialects/family/parameter_reader.h"
#include "dialects/family/routine_reader.h"
#include "dialects/family/scope.h"

namespace dripfeed::family {

namespace {

// What a parameter may be: by its kind the dimensions that its default may have.
class FamilyReader {
 public:
  explicit FamilyReader(const text::Source& source)
      : cursor_(source.text(), lex(source.text().substr(0, native_begin(source.text())))),
        expressions_(cursor_, scope_, family_),
        native_(cursor_, family_) {
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
      } else if (cursor_.accept_word("native")) {
        if (has_program) cursor_.syntax(cursor_.last_span(), "a family has a program or a native one, not both");
        native_.dialect();
      } else {
        declaration();
      }
    }
    if (!has_program && !family_.native) cursor_.syntax(cursor_.peek().span, "the family has no 'program'");
    native_.check();
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
    const auto row = std::ranges::find(ir::kMachineKindNames, kind);
    if (row == ir::kMachineKindNames.end()) {
      cursor_.syntax(at, fmt::format("expected lathe, mill or mill-turn, found '{}'", kind));
      return;
    }
    family_.machine = static_cast<ir::MachineKind>(row - ir::kMachineKindNames.begin());
    family_.machine_span = at;
    const bool stated = cursor_.accept_symbol(",");
    if (stated && cursor_.expect_word("x") && cursor_.expect_word("is")) {
      family_.x_is_diameter = cursor_.accept_word("diameter");
      if (!family_.x_is_diameter) cursor_.expect_word("radius");
    } else if (!stated && family_.machine != ir::MachineKind::mill) {
      cursor_.expected("', x is diameter' or ', x is radius'");
    }
  }

  void declaration() {
    using Read = void (FamilyReader::*)();
    static constexpr auto kRows = std::to_array<std::pair<std::string_view, Read>>({
        {"param", &FamilyReader::parameter},
        {"let", &FamilyReader::definition},
        {"const", &FamilyReader::constant},
        {"list", &FamilyReader::list},
        {"function", &FamilyReader::function},
        {"sub", &FamilyReader::subprogram},
        {"require", &FamilyReader::requirement},
        {"stock", &FamilyReader::stock},
        {"nominal", &FamilyReader::nominal},
        {"outline", &FamilyReader::outline},
        {"dimension", &FamilyReader::dimension},
    });
    const auto row = std::ranges::find(kRows, cursor_.word(), &std::pair<std::string_view, Read>::first);
    if (row == kRows.end()) {
      cursor_.expected(
          "param, let, const, list, function, sub, require, stock, nominal, outline, dimension or program");
    } else {
      cursor_.advance();
      (this->*row->second)();
    }
    cursor_.finish_line();
  }

  void parameter() {
    const std::size_t before = family_.parameters.size();
    ParameterReader(cursor_, scope_, expressions_, family_).read();
    if (family_.parameters.size() == before) return;
    const Parameter& read = family_.parameters.back();
    native_.target(read.symbol, read.dimension, read.unit);
  }

  void definition() { define(false); }
  void constant() { define(true); }

  void define(bool is_constant) {
    const std::uint32_t line = cursor_.peek().line;
    const std::optional<NewName> name = expect_new_name(cursor_, scope_);
    if (!name || !cursor_.expect_symbol("=")) return;
    const Typed value = expressions_.value();
    if (is_constant && depends_on_values(value.id))
      cursor_.syntax(value.span,
                     "a const is made of numbers and other consts; use let for what follows from parameters");
    if (cursor_.line_failed()) return;
    const ir::SymbolId symbol = scope_.define(family_.arena, name->name, value.dimension, name->span);
    family_.definitions.push_back({symbol, value.id, line, is_constant});
    native_.target(symbol, value.dimension, nullptr);
  }

  [[nodiscard]] bool depends_on_values(ir::ExpressionId value) const {
    if (value == ir::ExpressionId::none) return false;
    const auto names_one = [&](const auto& one) { return names(family_.arena, value, one.symbol); };
    return std::ranges::any_of(family_.parameters, names_one) || std::ranges::any_of(family_.lists, names_one) ||
           std::ranges::any_of(family_.definitions,
                               [&](const Definition& one) { return !one.is_constant && names_one(one); });
  }

  // list NAME = value, value, ..., or list NAME of KIND COUNT
  void list() {
    const std::uint32_t line = cursor_.peek().line;
    const std::optional<NewName> name = expect_new_name(cursor_, scope_);
    if (!name) return;
    List out;
    out.line = line;
    if (cursor_.accept_word("of")) return work_list(*name, std::move(out));
    if (!cursor_.at_symbol("=")) return cursor_.expected("'=' and its numbers, or 'of', a kind and how many");
    cursor_.advance();
    const Typed first = expressions_.value();
    out.dimension = first.dimension;
    out.elements.push_back(first.id);
    while (!cursor_.line_failed() && cursor_.accept_symbol(","))
      out.elements.push_back(expressions_.value_of(out.dimension).id);
    if (out.elements.size() > kMostNumbers)
      cursor_.syntax(name->span, fmt::format("a list has at most {} numbers", kMostNumbers));
    const auto most = static_cast<std::int32_t>(out.elements.size());
    if (!cursor_.line_failed()) add_list(family_, scope_, *name, std::move(out), most);
  }

  void work_list(const NewName& name, List out) {
    const std::optional<Dimension> dimension = RoutineReader(cursor_, scope_, expressions_, family_).dimension();
    if (!dimension) return;
    out.dimension = *dimension;
    const text::Span at = cursor_.peek().span;
    out.size = cursor_.expect_integer("how many numbers it has");
    if (!cursor_.line_failed() && (out.size < 1 || out.size > kMostNumbers))
      cursor_.syntax(at, fmt::format("a list has 1 to {} numbers", kMostNumbers));
    const std::int32_t size = out.size;
    if (!cursor_.line_failed()) add_list(family_, scope_, name, std::move(out), size);
  }

  void function() { RoutineReader(cursor_, scope_, expressions_, family_).function(); }
  void subprogram() { RoutineReader(cursor_, scope_, expressions_, family_).subprogram(); }

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

  void outline() { DrawingReader(cursor_, scope_, expressions_, family_).outline(); }
  void dimension() { DrawingReader(cursor_, scope_, expressions_, family_).dimension(); }

  void program() {
    family_.program_line = cursor_.peek().line;
    family_.program_name = cursor_.expect_hyphenated("the program's name");
    cursor_.finish_line();
    BodyReader(cursor_, scope_, expressions_, family_, family_.steps).read();
    refuse_pitch_among_feeds();
  }

  // A pitch takes the place of the feed; after it the feed before is written again, whatever path leads there.
  void refuse_pitch_among_feeds() {
    const auto sets = [&](Dimension kind) {
      return std::ranges::any_of(family_.steps,
                                 [&](const Step& one) { return one.kind == StepKind::feed && one.dimension == kind; });
    };
    const auto pitch = std::ranges::find_if(family_.steps, takes_feed_away);
    if (pitch != family_.steps.end() && sets(kFeedPerMin) && sets(kFeedPerRev))
      cursor_.syntax(pitch->span, "a program with taps or threads has one kind of feed, per minute or per revolution");
  }

  Family family_;
  Scope scope_;
  Cursor cursor_;
  ExpressionReader expressions_;
  NativeReader native_;
};

}  // namespace

ReadFamilyResult read_family(const text::Source& source) { return FamilyReader(source).read(); }

}  // namespace dripfeed::family

// Words that the block's codes do not take: the centre of an arc with a line, anything with a code that needs its
// block for itself, directions of rotary axes on linear ones; and indices and values that system variables do not have.
#include <algorithm>
#include <array>
#include <string>

#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/validator/validate.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;
using text::DiagnosticId;

// G0, G1, CIP and CT as far as they are certain: after labels, jumps, calls and native statements the motion code may
// be another.
class LineWords {
 public:
  explicit LineWords(const Check& check) : check_(check) {}

  void run() {
    for (const ir::Statement& s : check_.program.statements) {
      const bool others = s.kind == StatementKind::call || s.kind == StatementKind::modal_call ||
                          s.kind == StatementKind::go_to || ir::is_structure(s.kind) ||
                          s.kind == StatementKind::native || s.is_label;
      if (others) line_ = found_ = {};
      if (s.kind == StatementKind::block) block(check_.block_of(s));
    }
  }

 private:
  void block(const ir::Block& block) {
    bool own_words = false;
    for (const ir::Code& code : check_.program.codes_of(block)) {
      if (code.number != ir::ExpressionId::none) line_ = found_ = {};
      own_words |= code.group == ir::ModalGroup::non_modal || code.group == ir::ModalGroup::frame ||
                   code.function == Function::not_modelled || code.function == Function::transformation;
      if (code.group != ir::ModalGroup::motion) continue;
      const bool line = code.function == Function::rapid || code.function == Function::linear;
      line_ = line ? code.span : text::Span{};
      const bool found = code.function == Function::arc_via || code.function == Function::arc_tangent;
      found_ = found ? code.span : text::Span{};
    }
    if (own_words) return;
    if (!found_.empty()) arc_that_is_found(block);
    if (line_.empty()) return;
    for (const ir::Word& word : check_.program.words_of(block)) {
      if (!is_of_arc(word.address)) continue;
      const std::string written(check_.text_of(word.span));
      check_
          .report(DiagnosticId::syntax_error, word.span,
                  {written + " belongs to an arc, and " + std::string(check_.text_of(line_)) + " moves in a line"})
          .alarm = "12110";
      return;
    }
  }

  // CIP and CT find the circle themselves. What the control does with a radius in their block no manual states.
  void arc_that_is_found(const ir::Block& block) {
    for (const ir::Word& word : check_.program.words_of(block)) {
      if (!is_of_arc(word.address) || word.address == Address::turns) continue;
      text::Diagnostic& finding = check_.report(DiagnosticId::syntax_error, word.span,
                                                {std::string(check_.text_of(word.span)) + " belongs to G2 or G3, and " +
                                                 std::string(check_.text_of(found_)) + " finds its circle without it"});
      finding.severity = text::Severity::warning;
      finding.alarm.clear();
    }
  }

  static bool is_of_arc(Address a) {
    return (a >= Address::i && a <= Address::k) || a == Address::arc_radius || a == Address::opening_angle ||
           a == Address::turns;
  }

  const Check& check_;
  text::Span line_;   // G0 or G1 in effect
  text::Span found_;  // CIP or CT in effect
};

// G4, frames, poles and G25, G26 stand without auxiliary functions, tools and feeds (12120).
bool wants_block(const ir::Code& code) {
  return code.function == Function::dwell || (code.group == ir::ModalGroup::frame && code.letter == 'G');
}

void check_alone(const Check& check, const ir::Block& block) {
  const auto codes = check.program.codes_of(block);
  const auto alone = std::ranges::find_if(codes, wants_block);
  if (alone == codes.end()) return;
  const bool function = std::ranges::find(codes, 'M', &ir::Code::letter) != codes.end();
  const bool word = std::ranges::any_of(check.program.words_of(block), [](const ir::Word& w) {
    return w.address == Address::t || w.address == Address::d || w.address == Address::h;
  });
  if (!function && !word) return;
  text::Diagnostic& d =
      check.report(DiagnosticId::statement_not_alone, alone->span, {std::string(check.text_of(alone->span))});
  d.alarm = "12120";
  if (alone->function != Function::dwell) return;
  d.severity = text::Severity::warning;
  d.notes.push_back({alone->span, "the manual asks for a block of its own; controls in use take M functions with it"});
}

// X=DC(…): the shortest direction is of an axis that turns.
void check_axis_modes(const Check& check, const ir::Word& word) {
  struct Row {
    std::string_view mode;
    std::string_view alarm;
  };
  static constexpr Row kRows[] = {{"DC", "16800"}, {"ACP", "16810"}, {"ACN", "16820"}};
  if (word.name == ir::StringId::none || word.address < Address::x || word.address > Address::z) return;
  const auto* const row = std::ranges::find(kRows, check.program.strings.at(word.name), &Row::mode);
  if (row == std::end(kRows)) return;
  const std::string letter(1, static_cast<char>('A' + static_cast<int>(word.address)));
  check.report(DiagnosticId::addresses_exclude, word.span, {std::string(row->mode), "the linear axis " + letter})
      .alarm = row->alarm;
}

// System variables have no elements below zero, and edges are counted from 1; $TC_DP1[t,0]=0 deletes all of a tool.
void check_indices(const Check& check, const ir::Variable& v) {
  if (v.bank != ir::Bank::system || v.name == ir::StringId::none) return;
  const std::string_view name = check.program.strings.at(v.name);
  const bool edges = name.starts_with("$TC_DP") && name != "$TC_DP1";
  const std::array indices = {v.index, v.index2, v.index3};
  for (std::size_t n = 0; n < indices.size(); ++n) {
    if (indices[n] == ir::ExpressionId::none) continue;
    const ir::Expression& e = check.program.at(indices[n]);
    if (e.op != ir::Operator::constant || e.value >= (edges && n == 1 ? 1.0 : 0.0)) continue;
    check.report(DiagnosticId::variable_out_of_range, v.span, {std::string(check.text_of(v.span))}).alarm =
        n == 0 ? "17020" : "17030";
    return;
  }
}

// What a tool's data may be (PGA, "Tool offset data"): its type, and the place of a turning tool's edge.
struct DataRow {
  std::string_view name;
  double last;
};
constexpr DataRow kData[] = {{"$TC_DP1", 9999.0}, {"$TC_DP2", 9.0}};

void check_data(const Check& check, const ir::Statement& s) {
  const ir::Assign& assign = check.program.assigns[s.payload];
  if (assign.target == ir::VariableId::none || assign.value == ir::ExpressionId::none) return;
  const ir::Variable& v = check.program.at(assign.target);
  if (v.bank != ir::Bank::system || v.name == ir::StringId::none) return;
  const ir::Expression& value = check.program.at(assign.value);
  const std::string_view name = check.program.strings.at(v.name);
  const std::string written(check.text_of(value.span));
  if (value.op == ir::Operator::string && (name.starts_with("$TC_DP") || name == "$P_UIFR"))
    check.report(DiagnosticId::wrong_type, value.span, {written, "STRING", "a number"});
  const auto* const row = std::ranges::find(kData, name, &DataRow::name);
  if (row == std::end(kData) || value.op != ir::Operator::constant) return;
  if (value.value >= 0.0 && value.value <= row->last) return;
  check
      .report(DiagnosticId::value_out_of_range, value.span,
              {std::string(name), written, "0", text::format_shortest(row->last)})
      .alarm = "17050";
}

// TML(tool): only the program that replaces T may say it.
void check_tool_call(const Check& check, const ir::Statement& s) {
  if (check.native_name(s) != "TML" || may_have_caller(check.program)) return;
  check.report(DiagnosticId::code_not_in_mode, s.span, {"TML", "a main program"}).alarm = "14085";
}

}  // namespace

void check_words(const Check& check) {
  LineWords(check).run();
  for (const ir::Statement& s : check.program.statements) {
    if (s.kind == StatementKind::assign) check_data(check, s);
    if (s.kind == StatementKind::native) check_tool_call(check, s);
    if (s.kind == StatementKind::block) check_alone(check, check.block_of(s));
  }
  for (const ir::Word& word : check.program.words) check_axis_modes(check, word);
  for (const ir::Variable& v : check.program.variables) check_indices(check, v);
}

}  // namespace dripfeed::sinumerik

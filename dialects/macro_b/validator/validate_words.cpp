// Words and variables of blocks, one block at a time: nothing here depends on what was active before.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "dialects/ir/axis_letters.h"
#include "dialects/ir/offset_words.h"
#include "dialects/macro_b/validator/validate.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using enum text::DiagnosticId;

bool holds(std::string_view letters, Address address) { return letters.contains(letter_of(address)); }

// A word as written without its value: "X", ",C".
std::string address_name(const ir::Program& program, const ir::Word& word) {
  const std::string_view written = text_of(program, word.span);
  return std::string(written.substr(0, written.starts_with(',') ? 2 : 1));
}

// What the codes of a block make of its words.
struct BlockUse {
  bool arc = false;          // I J K R are lengths
  bool hole = false;         // R is a level
  bool shape = false;        // D is the depth of a pass
  bool scales = false;       // P is a factor
  bool other_words = false;  // a code that is not modelled gives the words a meaning of its own
};
BlockUse use_of(const ir::Program& program, const ir::Control& control, const ir::Block& block) {
  BlockUse use;
  for (const ir::Code& code : program.codes_of(block)) {
    use.arc |= code.function == Function::arc_cw || code.function == Function::arc_ccw;
    use.hole |= code.function == Function::drill;
    use.shape |= code.function == Function::repetitive_cycle;
    use.scales |= code.function == Function::scale;
    use.other_words |= code.function == Function::not_modelled || code.function == Function::measure_tool ||
                       code.function == Function::hole_pattern;
    // It may call a macro by parameter, and its words are arguments then.
    use.other_words |=
        code.function == Function::machine_function && !ir::is_known_machine_function(control, code.argument);
  }
  return use;
}

// Which offsets G10 sets, by L and the range of P.
struct DataRow {
  double first_l;
  double last_l;
  double first_p;
  double last_p;
};
constexpr DataRow kDataRows[] = {{2.0, 2.0, 0.0, 6.0}, {20.0, 20.0, 1.0, 300.0}, {10.0, 13.0, 1.0, 999.0}};

// L of G10: offsets, tool lives, coordinates, parameters, compensation of axes.
struct KindRow {
  double first;
  double last;
};
constexpr KindRow kKindsOfData[] = {{1.0, 3.0},   {10.0, 16.0}, {20.0, 23.0},  {30.0, 33.0},
                                    {50.0, 52.0}, {70.0, 71.0}, {100.0, 115.0}};

constexpr double kLastOffset = 999.0;  // the largest option of tool offsets

class WordCheck {
 public:
  WordCheck(const ir::Program& program, const ir::Control& control, Findings& findings)
      : program_(program),
        control_(control),
        findings_(findings),
        inch_(control.semantics.power_on_unit == Function::unit_inch) {}

  void block(const ir::Block& block) {
    const BlockUse use = use_of(program_, control_, block);
    take_unit(block);
    turns_of_arc(block, use);
    number_of_offset(block);
    groups(block);
    data_setting(block);
    code_with_function_in(block);
    offset_number(block);
    circle_cutting(block);
    std::array<bool, static_cast<std::size_t>(Address::count_)> seen{};
    for (const ir::Word& word : program_.words_of(block)) {
      bool& before = seen[static_cast<std::size_t>(word.address)];
      if (before && word.address != Address::other && !use.other_words) {
        findings_.add(duplicate_address, word.span, {address_name(program_, word)});
      }
      before = true;
      unknown(word, use);
      point_not_allowed(word, use);
      if (is_length(word.address, use)) point_missing(word.address, word.value, word.span);
      if (word.address == Address::f && inch_ && !use.other_words) point_missing(word.address, word.value, word.span);
    }
  }

  // Arguments of a macro take their places after the point by letter; those of the axes are lengths.
  void call(const ir::Call& call) {
    for (const ir::Argument& argument : program_.arguments_of(call)) {
      if (call.kind != ir::CallKind::macro || !std::string_view("XYZ").contains(argument.letter)) continue;
      if (argument.value != ir::ExpressionId::none)
        point_missing(Address::x, argument.value, program_.at(argument.value).span);
    }
  }

 private:
  void take_unit(const ir::Block& block) {
    for (const ir::Code& code : program_.codes_of(block))
      if (code.function == Function::unit_inch || code.function == Function::unit_mm)
        inch_ = code.function == Function::unit_inch;
  }

  // L of a helix counts turns on other controls.
  void turns_of_arc(const ir::Block& block, const BlockUse& use) {
    if (!use.arc || use.other_words) return;
    for (const ir::Word& word : program_.words_of(block))
      if (word.address == Address::l) findings_.add(word_ignored, word.span, {"L", "an arc"});
  }

  // G54 P3 is G54.1 P3 on some controls; on others, and in the block of G55, P has no effect.
  void number_of_offset(const ir::Block& block) {
    const auto codes = program_.codes_of(block);
    const auto offset = std::ranges::find(codes, Function::work_offset, &ir::Code::function);
    if (offset == codes.end() || std::ranges::any_of(codes, ir::takes_p, &ir::Code::function)) return;
    const bool takes_p = control_.semantics.g54_takes_p && offset->argument == ir::kFirstWorkOffset;
    const std::string_view written = text_of(program_, offset->span);
    if (takes_p || written.contains('.')) return;
    for (const ir::Word& word : program_.words_of(block))
      if (word.address == Address::p) findings_.add(word_ignored, word.span, {"P", std::string(written)});
  }

  void groups(const ir::Block& block) {
    const auto codes = program_.codes_of(block);
    for (std::size_t i = 0; i < codes.size(); ++i) {
      const ModalGroup group = codes[i].group;
      if (codes[i].letter != 'G' || group == ModalGroup::none || group == ModalGroup::non_modal ||
          group == ModalGroup::other || group == ModalGroup::frame) {
        continue;
      }
      for (std::size_t k = 0; k < i; ++k) {
        if (codes[k].group != group || codes[k].letter != 'G') continue;
        if (codes[k].function == codes[i].function && codes[k].argument == codes[i].argument) continue;
        text::Diagnostic* finding = findings_.add(
            codes_of_one_group, codes[i].span,
            {std::string(text_of(program_, codes[k].span)), std::string(text_of(program_, codes[i].span))});
        // These controls take the last one without an alarm.
        if (finding != nullptr) finding->severity = text::Severity::warning;
        break;
      }
    }
  }

  // G10 L2, L20 and L10 to L13 with the number of an offset that there is not.
  void data_setting(const ir::Block& block) {
    const auto codes = program_.codes_of(block);
    const auto g10 = std::ranges::find(codes, Function::data_input, &ir::Code::function);
    if (g10 == codes.end()) return;
    const auto number = [&](Address address) -> std::optional<double> {
      for (const ir::Word& word : program_.words_of(block))
        if (word.address == address && word.value != ir::ExpressionId::none &&
            program_.at(word.value).op == ir::Operator::constant)
          return program_.at(word.value).value;
      return std::nullopt;
    };
    const auto kind = number(Address::l);
    const auto place = number(Address::p);
    if (kind) kind_of_data(*kind, g10->span);
    if (!kind || !place) return;
    for (const DataRow& row : kDataRows) {
      if (*kind < row.first_l || *kind > row.last_l) continue;
      if (*place >= row.first_p && *place <= row.last_p) return;
      findings_.add(
          data_setting_invalid, g10->span,
          {text::format_shortest(*kind), text::format_shortest(row.first_p), text::format_shortest(row.last_p)});
      return;
    }
  }

  // L that none of these controls has.
  void kind_of_data(double l, text::Span span) {
    const bool known = std::ranges::any_of(
        kKindsOfData, [l](const KindRow& row) { return l >= row.first && l <= row.last && l == std::floor(l); });
    if (!known)
      findings_.add_own(syntax_error, span, {"G10 has no data L" + text::format_shortest(l)},
                        ir::AlarmDetail::kind_of_data);
  }

  // G27 or G29 with an M function, where the control has an alarm for it.
  void code_with_function_in(const ir::Block& block) {
    const auto codes = program_.codes_of(block);
    const auto reference = std::ranges::find_if(
        codes, [&](const ir::Code& c) { return c.function == Function::leave_reference || is_reference_check(c); });
    const auto m = std::ranges::find(codes, 'M', &ir::Code::letter);
    if (reference == codes.end() || m == codes.end() || ir::alarm_of(control_, code_with_function).empty()) return;
    findings_.add(code_with_function, m->span,
                  {std::string(text_of(program_, reference->span)), std::string(text_of(program_, m->span))},
                  is_reference_check(*reference) ? ir::AlarmDetail::reference_check : ir::AlarmDetail::none);
  }
  [[nodiscard]] bool is_reference_check(const ir::Code& code) const {
    return code.function == Function::approach && program_.strings.at(code.name) == "G27";
  }

  // D of a compensation and H of a tool length are numbers of the offset table.
  void offset_number(const ir::Block& block) {
    if (control_.kind != ir::MachineKind::mill) return;
    const auto codes = program_.codes_of(block);
    const bool comp = std::ranges::any_of(codes, [](const ir::Code& c) {
      return c.function == Function::comp_left || c.function == Function::comp_right;
    });
    const bool length = std::ranges::any_of(codes, [](const ir::Code& c) {
      return c.function == Function::length_offset_plus || c.function == Function::length_offset_minus;
    });
    for (const ir::Word& word : program_.words_of(block)) {
      const bool counts = (word.address == Address::d && comp) || (word.address == Address::h && length);
      if (!counts || word.value == ir::ExpressionId::none) continue;
      const ir::Expression& value = program_.at(word.value);
      if (value.op != ir::Operator::constant || (value.value >= 0.0 && value.value <= kLastOffset)) continue;
      findings_.add(value_out_of_range, word.span,
                    {address_name(program_, word), std::string(text_of(program_, value.span)), "0",
                     text::format_shortest(kLastOffset)});
    }
  }

  // G12 and G13 of a mill cut a circle, smaller by the offset that D names: without D an alarm (M700V/M70V programming
  // manual, 13.10 "Circle cutting").
  void circle_cutting(const ir::Block& block) {
    const auto words = program_.words_of(block);
    if (std::ranges::find(words, Address::d, &ir::Word::address) != words.end()) return;
    if (ir::alarm_of(control_, comp_without_number).empty()) return;  // on a Haas it is the tool's centre
    for (const ir::Code& code : program_.codes_of(block)) {
      if (code.function != Function::not_modelled) continue;
      const std::string_view name = program_.strings.at(code.name);
      if (name != "G12" && name != "G13") continue;
      text::Diagnostic* finding = findings_.add(comp_without_number, code.span, {std::string(name)});
      if (finding != nullptr) finding->severity = text::Severity::error;
    }
  }

  // In a hole's block ,R1 says that a tap is a synchronous one.
  [[nodiscard]] bool is_length(Address address, const BlockUse& use) const {
    const bool corner = address == Address::chamfer || address == Address::rounding;
    return is_axis(control_, address) || address == Address::direct_angle || (use.arc && holds("IJKR", address)) ||
           (use.hole && address == Address::r) || (corner && !use.hole);
  }

  // Without a named machine its axes are not known, and C is a chamfer on old lathes.
  void unknown(const ir::Word& word, const BlockUse& use) {
    if (!control_.from_profile || use.other_words || !holds("ABUVWXYZ", word.address)) return;
    if (!is_axis(control_, word.address))
      findings_.add(unknown_address, word.span, {address_name(program_, word)}, ir::AlarmDetail::axis_letter);
  }

  void point_not_allowed(const ir::Word& word, const BlockUse& use) {
    if (word.value == ir::ExpressionId::none || !holds(use.other_words ? "T" : "DHLPT", word.address)) return;
    if (word.address == Address::h && ir::incremented_axis(control_, 'H')) return;
    if (word.address == Address::p && use.scales) return;
    const ir::Expression& value = program_.at(word.value);
    if (word.address == Address::t && control_.semantics.tool_number_has_suffix) return;
    if (value.op == ir::Operator::constant && value.has_point && !text_of(program_, value.span).starts_with('[')) {
      text::Diagnostic* finding = findings_.add(decimal_point_not_allowed, word.span, {address_name(program_, word)});
      if (finding == nullptr) return;
      // Some controls of this family take the depth of a pass with a point.
      if (use.shape && word.address == Address::d) finding->severity = text::Severity::warning;
      // On a machine that has C and increments with letters it may be the increment of C.
      if (word.address == Address::h && control_.semantics.incremental_letters_uvw) {
        finding->severity = text::Severity::warning;
        finding->is_open = true;
      }
    }
  }

  void point_missing(Address address, ir::ExpressionId id, text::Span span) {
    const ir::Expression& value = program_.at(id);
    if (value.op != ir::Operator::constant || value.has_point || value.value == 0.0) return;
    constexpr double kInchPart = 0.1;  // 0.001 mm, or 0.0001 inch
    const double length = control_.semantics.least_increment_mm * (inch_ ? kInchPart : 1.0);
    // F100 of a program in inch is 100 or 1 inch a minute; on a lathe, where it is of a revolution, 100 or 0.01.
    const double feed = control_.kind == ir::MachineKind::mill ? 0.01 : 0.0001;
    const double increment = address == Address::f ? feed
                             : holds("ABC", address) || address == Address::direct_angle
                                 ? control_.semantics.least_increment_deg
                                 : length;
    std::string counted;
    text::append_word_number(counted, value.value * increment, 6, false);
    findings_.add_open(missing_decimal_point, span,
                       {std::string(text_of(program_, span)), text::format_shortest(value.value), counted},
                       control_.from_profile && control_.semantics.decimal_mode_confirmed);
  }

  const ir::Program& program_;
  const ir::Control& control_;
  Findings& findings_;
  bool inch_;
};

}  // namespace

void check_words(const ir::Program& program, const ir::Control& control, Findings& findings) {
  WordCheck check(program, control, findings);
  for (const ir::Statement& statement : program.statements) {
    if (statement.kind == ir::StatementKind::block) check.block(program.blocks[statement.payload]);
    if (statement.kind == ir::StatementKind::call) check.call(program.calls[statement.payload]);
  }
}

void check_variables(const ir::Program& program, const ir::Control& control, Findings& findings) {
  if (control.variables.empty()) return;
  for (const ir::Variable& variable : program.variables) {
    if (variable.bank != ir::Bank::hash || variable.index != ir::ExpressionId::none || variable.number == 0) continue;
    if (ir::find_variable(control, ir::Bank::hash, variable.number) == nullptr) {
      findings.add_variable(variable.number, variable.span);
    }
  }
  for (const ir::Expression& e : program.expressions) {
    if (e.op != ir::Operator::divide || e.b == ir::ExpressionId::none) continue;
    const ir::Expression& divisor = program.at(e.b);
    if (divisor.op == ir::Operator::constant && divisor.value == 0.0) findings.add(division_by_zero, e.span);
  }
  for (const ir::Statement& statement : program.statements) {
    if (statement.kind != ir::StatementKind::assign) continue;
    const ir::Variable& target = program.at(program.assigns[statement.payload].target);
    if (target.bank != ir::Bank::hash || target.index != ir::ExpressionId::none) continue;
    const ir::VariableRange* range = ir::find_variable(control, ir::Bank::hash, target.number);
    if (target.number == 0 || (range != nullptr && !range->writable)) {
      findings.add(variable_write_protected, target.span, {fmt::format("#{}", target.number)});
    }
  }
}

}  // namespace dripfeed::macro_b

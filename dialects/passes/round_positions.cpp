// In the order of the text. Where control-flow paths meet, nothing is taken over; where the unit may be either, the
// finer one counts.
#include "dialects/passes/round_positions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "dialects/ir/axis_letters.h"
#include "dialects/ir/motion.h"

namespace dripfeed::passes {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;

constexpr double kInch_mm = 25.4;
constexpr double kInchesPerMm = 0.1;  // of least increments

bool is_corner(Address a) {
  return a == Address::chamfer || a == Address::chamfer_length || a == Address::rounding ||
         a == Address::modal_rounding || a == Address::via_i || a == Address::via_j || a == Address::via_k;
}
bool is_of_arc(Address a) {
  return a == Address::i || a == Address::j || a == Address::k || a == Address::r || a == Address::arc_radius;
}

class Rounding {
 public:
  Rounding(ir::Program& program, const ir::Control& control)
      : program_(program),
        control_(control),
        inch_(control.semantics.power_on_unit == Function::unit_inch),
        incremental_(control.semantics.power_on_distance == Function::incremental) {
    for (const ir::CodeRow& row : control.caller_modes) take(row.function);
    const auto any = [&](Function f) {
      return std::ranges::find(program.codes, f, &ir::Code::function) != program.codes.end();
    };
    const bool jumps = program.sections.size() > 1 ||
                       std::ranges::any_of(program.statements, [](const ir::Statement& s) { return !goes_on(s.kind); });
    either_unit_ = jumps && any(Function::unit_inch) && any(Function::unit_mm);
    is_target_.assign(program.statements.size(), false);
    for (const ir::Label& label : program.labels)
      if (label.statement < is_target_.size()) is_target_[label.statement] = jumps;
  }

  void run() {
    for (std::size_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (is_target_[i] || s.skip_level != 0 || !goes_on(s.kind)) rest_ = {};
      if (s.kind == StatementKind::block) block(program_.blocks[s.payload]);
    }
  }

 private:
  static bool goes_on(StatementKind kind) {
    return kind == StatementKind::block || kind == StatementKind::empty || kind == StatementKind::message ||
           kind == StatementKind::assign || kind == StatementKind::program_end || kind == StatementKind::define ||
           kind == StatementKind::declaration;
  }

  void take(Function f) {
    if (f == Function::unit_inch || f == Function::unit_mm) inch_ = f == Function::unit_inch;
    if (f == Function::absolute || f == Function::incremental) incremental_ = f == Function::incremental;
  }

  void block(const ir::Block& block) {
    bool positions = true;  // its words are
    bool in_frame = false;
    for (const ir::Code& c : program_.codes_of(block)) {
      take(c.function);
      if (c.group == ir::ModalGroup::motion || c.group == ir::ModalGroup::cycle)
        bends_ = c.function == Function::arc_cw || c.function == Function::arc_ccw;
      positions = positions && c.function != Function::dwell && c.function != Function::not_modelled &&
                  c.function != Function::machine_function && c.number == ir::ExpressionId::none;
      in_frame |= c.group == ir::ModalGroup::frame;
      if (c.group == ir::ModalGroup::work_offset || c.group == ir::ModalGroup::unit || in_frame) rest_ = {};
    }
    if (!positions || in_frame) return;
    for (std::uint32_t i = 0; i < block.word_count; ++i) word(program_.words[block.first_word + i]);
  }

  void word(ir::Word& word) {
    const std::optional<std::size_t> axis = axis_of(word.address);
    if (!axis && !is_corner(word.address) && !(bends_ && is_of_arc(word.address))) return;
    const std::optional<double> value = value_of(word.value);
    if (!value) {
      if (axis) rest_[*axis] = 0.0;
      return;
    }
    const bool by_letter = axis && is_increment_letter(word.address);
    const bool increment = axis && (by_letter || word.mode == ir::WordMode::incremental ||
                                    (word.mode == ir::WordMode::as_modal && incremental_ && !letters_say_it()));
    const double wanted = increment ? *value + rest_[*axis] : *value;
    const double rounded = nearest(wanted, axis && is_rotary(*axis));
    if (axis) rest_[*axis] = wanted - rounded;
    if (rounded == *value) return;
    const ir::Expression old = program_.at(word.value);
    word.value = program_.add_constant(rounded, {}, old.op == ir::Operator::constant ? old.has_point : true);
  }

  static bool is_rotary(std::size_t axis) { return axis >= 3 && axis <= 5; }
  [[nodiscard]] bool letters_say_it() const { return control_.semantics.incremental_letters_uvw; }
  [[nodiscard]] bool is_increment_letter(Address a) const {
    return a <= Address::z && ir::incremented_axis(control_, static_cast<char>('A' + static_cast<int>(a))).has_value();
  }

  // Its place in rest_.
  [[nodiscard]] std::optional<std::size_t> axis_of(Address a) const {
    if (a > Address::z) return std::nullopt;
    char letter = static_cast<char>('A' + static_cast<int>(a));
    if (const auto incremented = ir::incremented_axis(control_, letter)) letter = *incremented;
    const std::size_t at = ir::kAxisLetters.find(letter);
    if (at == std::string_view::npos || !control_.axes.contains(letter)) return std::nullopt;
    return at;
  }

  // Without a point it may count increments, which are whole.
  [[nodiscard]] std::optional<double> value_of(ir::ExpressionId id) const {
    if (id == ir::ExpressionId::none) return std::nullopt;
    const ir::Expression& e = program_.at(id);
    const bool negative = e.op == ir::Operator::negate;
    const ir::Expression& number = negative ? program_.at(e.a) : e;
    if (number.op != ir::Operator::constant) return std::nullopt;
    if (!number.has_point && control_.semantics.decimal_mode == ir::DecimalMode::least_increment) return std::nullopt;
    return negative ? -number.value : number.value;
  }

  [[nodiscard]] double nearest(double value, bool rotary) const {
    return nearest_position(value, rotary, inch_ || either_unit_, control_);
  }

  ir::Program& program_;
  const ir::Control& control_;
  std::vector<bool> is_target_;
  std::array<double, ir::kAxisCount> rest_{};  // of the chain: the end that is wanted less the one that is written
  bool inch_;
  bool incremental_;
  bool either_unit_ = false;
  bool bends_ = false;
};

}  // namespace

void round_positions(ir::Program& program, const ir::Control& control) { Rounding(program, control).run(); }

double nearest_position(double value, bool rotary, bool inch, const ir::Control& control) {
  const double increment = rotary ? control.semantics.least_increment_deg
                                  : control.semantics.least_increment_mm * (inch ? kInchesPerMm : 1.0);
  if (!(increment > 0.0)) return value;
  const double per_unit = std::nearbyint(1.0 / increment);
  return std::nearbyint(value * per_unit) / per_unit + 0.0;
}

double least_increment_mm(const ir::Control& control, bool inch) {
  const double increment = control.semantics.least_increment_mm;
  return inch ? increment * kInchesPerMm * kInch_mm : increment;
}

}  // namespace dripfeed::passes

// G12.1 counts C from where the axis stands, TRANSMIT on the axis' own scale: they are the same where C stands at 0.
// G12.1 brings its plane along, after TRANSMIT it is G17; arcs on a circumference lie in the plane of Z and what
// stands for C: with G18 the opposite of G19.
#include "dialects/compile/translate/translate_faces.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "dialects/compile/translate/lathe_facts.h"
#include "dialects/facts/transformation.h"
#include "dialects/ir/transformation_use.h"
#include "dialects/passes/findings.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/text/number.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr std::uint32_t kNowhere = ir::kNoIndex;

bool by_rotary(std::int16_t argument) { return argument == ir::kFaceByRotary || argument == ir::kCylinderByRotary; }
bool is_face(std::int16_t argument) { return argument == ir::kFaceByRotary || argument == ir::kFaceByY; }

bool has_rotary_forms(const ir::Control& control) {
  return std::ranges::any_of(control.g_codes, [](const ir::CodeRow& row) {
    return row.function == Function::transformation && by_rotary(row.argument);
  });
}

class Faces {
 public:
  Faces(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program),
        from_(from),
        to_rotary_(has_rotary_forms(to)),
        facts_(program, from),
        out_(program),
        findings_(to) {}

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (index_ = 0; index_ < count; ++index_) {
      out_.at(index_);
      statement_ = program_.statements[index_];
      findings_.at(statement_.span);
      const bool is_block = statement_.kind == StatementKind::block;
      here_ = region_at(index_);
      const ir::Block block = is_block ? program_.blocks[statement_.payload] : ir::Block();
      if (const ir::Code* code = is_block ? code_of(block) : nullptr)
        facts::ends_transformation(program_, block, *code) ? end() : begin(*code, block);
      else if (!here_.is_reached || here_.is(kNowhere))
        out_.keep();
      else
        inside(block);
    }
    out_.finish();
    return findings_.take();
  }

 private:
  // --- where they are in effect

  [[nodiscard]] const ir::Code* code_of(const ir::Block& block) const {
    for (const ir::Code& c : program_.codes_of(block))
      if (c.function == Function::transformation) return &c;
    return nullptr;
  }

  // The block that began what is in effect before the statement; kNowhere: none is. Nothing where paths differ, or none
  // leads there.
  struct Region {
    bool is_reached = false;
    std::optional<std::uint32_t> begin;

    [[nodiscard]] bool is(std::uint32_t statement) const { return begin == statement; }
  };
  [[nodiscard]] Region region_at(std::uint32_t statement) const {
    const facts::Facts* facts = facts_.facts().before(statement);
    if (facts == nullptr) return {};
    const facts::Known<facts::Setting>& fact = (*facts)[facts::Mode::transformation];
    if (!fact.agrees()) return {.is_reached = true, .begin = {}};
    const bool off = fact.value.function == Function::none;
    return {.is_reached = true, .begin = off ? kNowhere : static_cast<std::uint32_t>(fact.value.argument)};
  }

  // --- their own blocks

  void begin(const ir::Code& written, const ir::Block& block) {
    const ir::Code code = written;
    if (program_.codes_of(block).size() != 1 || block.rest_level != 0)
      return findings_.cannot(passes::together("a code in the same block as polar or cylindrical interpolation"));
    if (!here_.is(kNowhere))
      return findings_.cannot(passes::together("polar or cylindrical interpolation inside of another"));
    if (is_face(code.argument)) {
      const std::optional<LatheState> state = facts_.before(index_);
      if (!state || state->c != 0.0)
        return findings_.cannot(passes::not_known("polar interpolation where C is not known to stand at 0"));
      if (state->x && *state->x < 0.0) return findings_.cannot("polar interpolation from a negative X");
      emit(to_rotary_ ? ir::kFaceByRotary : ir::kFaceByY, "TRANSMIT", {});
      if (!to_rotary_) plane(Function::plane_xy);
      return;
    }
    const double radius = radius_at(index_);
    if (radius <= 0.0) return findings_.cannot("cylindrical interpolation without C and its radius as a number");
    if (to_rotary_) return emit(ir::kCylinderByRotary, {}, {word(Address::c, constant(radius))});
    emit(ir::kCylinderByY, "TRACYL(" + text::format_shortest(radius * 2.0) + ")", {});
    plane(Function::plane_yz);
  }

  // Of the cylinder that the statement begins; 0 where it is not known.
  [[nodiscard]] double radius_at(std::uint32_t statement) const {
    const ir::Block& block = program_.blocks[program_.statements[statement].payload];
    const auto words = program_.words_of(block);
    const bool rotary = code_of(block)->argument == ir::kCylinderByRotary;
    const auto size = std::ranges::find(words, rotary ? Address::c : Address::r, &ir::Word::address);
    const double given = size == words.end() ? 0.0 : facts_.number(*size, statement).value_or(0.0);
    return rotary ? given : given / 2.0;
  }

  void end() {
    if (!here_.is_reached) return;
    if (!here_.begin) return findings_.cannot(passes::not_known("the end of what began on one control-flow path only"));
    if (here_.is(kNowhere)) return out_.keep();  // ends nothing
    const bool cylinder = is_cylinder_here();
    const std::optional<Function> here = facts_.mode(facts::Mode::plane, index_);
    const std::optional<Function> now = !to_rotary_ ? (cylinder ? Function::plane_yz : Function::plane_xy)
                                        : cylinder  ? here
                                                    : facts_.mode(facts::Mode::plane, *here_.begin);
    if (to_rotary_ && cylinder)
      emit(ir::kCylinderByRotary, {}, {word(Address::c, constant(0.0))});
    else
      emit(ir::kTransformationEnds, to_rotary_ ? "" : "TRAFOOF", {});
    // What the program has in effect after it.
    if (here && now != here) plane(*here);
    if (!here)
      findings_.cannot(passes::not_known("the plane after polar or cylindrical interpolation, not known here,"));
  }

  [[nodiscard]] bool is_cylinder_here() const {
    if (!here_.begin || here_.is(kNowhere)) return false;
    const ir::Statement& s = program_.statements[*here_.begin];
    const ir::Code* code = code_of(program_.blocks[s.payload]);
    return code != nullptr && !is_face(code->argument);
  }

  void emit(std::int16_t argument, std::string_view name, const std::vector<ir::Word>& words) {
    ir::Code code;
    code.function = Function::transformation;
    code.argument = argument;
    code.group = ir::ModalGroup::other;
    if (!name.empty()) code.name = program_.strings.add(name);
    out_.emit_block({code}, words);
  }
  void plane(Function function) {
    ir::Code code;
    code.function = function;
    code.group = ir::ModalGroup::plane;
    out_.emit_block({code}, {});
  }

  // --- blocks between

  void inside(const ir::Block& block) {
    if (statement_.kind == StatementKind::call || statement_.kind == StatementKind::modal_call ||
        statement_.kind == StatementKind::native)
      return findings_.cannot(passes::together("a call inside of polar or cylindrical interpolation"));
    if (statement_.kind != StatementKind::block) return out_.keep();
    if (!here_.begin)
      return findings_.cannot(
          passes::not_known("a block that stands in polar interpolation on one control-flow path only"));
    if (block.rest_level != 0) return findings_.cannot(passes::at_switch("block skip inside a block"));
    const bool cylinder = is_cylinder_here();
    const std::optional<Function> here = facts_.mode(facts::Mode::plane, index_);
    std::vector<ir::Code> codes;
    bool bends = false;
    const bool turned = cylinder && !to_rotary_ && here == Function::plane_zx;
    for (ir::Code c : program_.codes_of(block)) {
      if (c.group == ir::ModalGroup::plane && !(to_rotary_ && cylinder)) continue;
      bends |= takes_plane(c.function);
      if (turned) c.function = other_side(c.function);
      codes.push_back(c);
    }
    if (bends && !plane_fits(cylinder, here))
      return findings_.cannot("an arc or compensation in another plane than that of the face");
    std::vector<ir::Word> words;
    const std::vector<ir::Word> old(program_.words_of(block).begin(), program_.words_of(block).end());
    for (const ir::Word& w : old) {
      if (cylinder && is_center(w)) return findings_.cannot("an arc on a cylinder by its centre");
      words.push_back(across(w, cylinder));
    }
    out_.emit_block(codes, words);
  }

  static bool takes_plane(Function f) {
    return f == Function::arc_cw || f == Function::arc_ccw || f == Function::comp_left || f == Function::comp_right;
  }
  static Function other_side(Function f) {
    switch (f) {
      case Function::arc_cw: return Function::arc_ccw;
      case Function::arc_ccw: return Function::arc_cw;
      case Function::comp_left: return Function::comp_right;
      case Function::comp_right: return Function::comp_left;
      default: return f;
    }
  }
  [[nodiscard]] bool plane_fits(bool cylinder, std::optional<Function> here) const {
    if (!cylinder) return !to_rotary_ || here == Function::plane_xy;
    return here == Function::plane_yz || (!to_rotary_ && here == Function::plane_zx);
  }
  static bool is_center(const ir::Word& w) { return w.address >= Address::i && w.address <= Address::k; }

  ir::Word across(ir::Word w, bool cylinder) {
    const bool increment = facts_.is_increment_of_c(w);
    if (to_rotary_ ? w.address != Address::y : (w.address != Address::c && !increment)) return w;
    w.address = to_rotary_ ? Address::c : Address::y;
    if (increment) w.mode = ir::WordMode::incremental;
    if (!cylinder) return w;
    // Degrees and millimetres on the circumference.
    const double radius = radius_at(*here_.begin);
    const double factor = to_rotary_ ? kDegrees / radius : radius / kDegrees;
    const ir::Expression e = program_.at(w.value);
    if (e.op == Operator::constant) {
      const bool counts = !e.has_point && from_.semantics.decimal_mode == ir::DecimalMode::least_increment;
      w.value = constant(e.value * factor * (counts ? from_.semantics.least_increment_deg : 1.0));
    } else {
      w.value = program_.add_operator(Operator::multiply, w.value, constant(factor), e.span);
    }
    return w;
  }

  // --- small parts

  ExpressionId constant(double value) { return program_.add_constant(value, {}, true); }

  ir::Program& program_;
  const ir::Control& from_;
  bool to_rotary_;  // the target names the coordinate across by the axis that turns
  LatheFacts facts_;
  passes::Rewrite out_;
  Region here_;
  std::uint32_t index_ = 0;
  ir::Statement statement_;
  passes::Findings findings_;
};

}  // namespace

std::vector<text::Diagnostic> translate_faces(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  if (from.dialect == to.dialect) return {};
  const bool to_rotary = has_rotary_forms(to);
  const bool any = std::ranges::any_of(program.codes, [&](const ir::Code& c) {
    return c.function == Function::transformation && c.argument != ir::kTransformationEnds &&
           by_rotary(c.argument) != to_rotary;
  });
  return any ? Faces(program, from, to).run() : std::vector<text::Diagnostic>();
}

}  // namespace dripfeed::compile

// One function a step. Expressions are copied node by node, because passes rewrite a statement's expression in place;
// minimum and maximum, which not every control has, become an assignment and an IF before the statement.
#include "dialects/family/build.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/emitter.h"
#include "dialects/ir/motion.h"

namespace dripfeed::family {

namespace {

using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;

// Added to the quotient before it is cut to a whole number: up to the next one, but not for a millionth of a step.
constexpr double kTripRounding = 0.999999;
constexpr double kBackward = -0.000001;

std::string upper_name(const Family& family) {
  std::string out = family.program_name.empty() ? family.name : family.program_name;
  for (char& c : out) {
    if (c == '-') c = '_';
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return out;
}

class Builder {
 public:
  explicit Builder(const BoundFamily& bound) : bound_(bound), family_(*bound.family), emit_(program_) {}

  ir::Program build() {
    program_.name = upper_name(family_);
    program_.strings = family_.arena.strings;
    program_.symbols = family_.arena.symbols;
    safe_start();
    for (const Parameter& parameter : family_.parameters) {
      emit_.set_line(family_.source.position(parameter.span.begin).line);
      emit_.assign(parameter.symbol, emit_.constant(value_of(parameter.symbol)));
    }
    for (const Definition& definition : family_.definitions) {
      emit_.set_line(definition.line);
      emit_.assign(definition.symbol, copy(definition.value));
    }
    for (const Step& step : family_.steps) {
      emit_.set_line(step.line);
      build_step(step);
    }
    if (compensation_ != Function::none) emit_.block({compensation_}, {});
    emit_.program_end();
    ir::match_structures(program_);
    return std::move(program_);
  }

 private:
  struct Loop {
    ir::SymbolId index;
  };

  [[nodiscard]] double value_of(ir::SymbolId symbol) const { return bound_.values[static_cast<std::size_t>(symbol)]; }

  void safe_start() {
    emit_.set_line(family_.program_line);
    const bool mill = family_.machine == ir::MachineKind::mill;
    const auto first_feed = std::ranges::find(family_.steps, StepKind::feed, &Step::kind);
    const bool per_rev = first_feed != family_.steps.end() && first_feed->dimension == kFeedPerRev;
    const Function feed = per_rev ? Function::feed_per_rev : Function::feed_per_min;
    if (mill) {
      emit_.block({Function::unit_mm, Function::plane_xy, Function::absolute, feed, Function::comp_off}, {});
    } else {
      emit_.block({Function::unit_mm, Function::plane_zx, Function::absolute, feed, Function::comp_off,
                   family_.x_is_diameter ? Function::diameter_on : Function::diameter_off},
                  {});
    }
  }

  // A copy of a family's expression in the program. What must be computed before is emitted on the way.
  ExpressionId copy(ExpressionId id) {
    const ir::Expression& e = family_.arena.at(id);
    if (e.op == Operator::constant) return program_.add_constant(e.value, e.span);
    if (e.op == Operator::variable) return emit_.variable(family_.arena.at(e.variable).symbol);
    const ExpressionId a = copy(e.a);
    if (ir::operand_count(e.op) == 1) return program_.add_operator(e.op, a, ExpressionId::none, e.span);
    const ExpressionId b = copy(e.b);
    if (e.op == Operator::minimum || e.op == Operator::maximum) return choose(e.op, a, b);
    return program_.add_operator(e.op, a, b, e.span);
  }

  ExpressionId choose(Operator op, ExpressionId a, ExpressionId b) {
    const ir::SymbolId chosen = emit_.new_symbol("chosen");
    const ir::SymbolId other = emit_.new_symbol("other");
    emit_.assign(chosen, a);
    emit_.assign(other, b);
    emit_.open(StatementKind::if_begin, emit_.binary(op == Operator::minimum ? Operator::less : Operator::greater,
                                                     emit_.variable(other), emit_.variable(chosen)));
    emit_.assign(chosen, emit_.variable(other));
    emit_.close(StatementKind::if_end);
    return emit_.variable(chosen);
  }

  void build_step(const Step& step) {
    switch (step.kind) {
      case StepKind::work_offset: work_offset(step); break;
      case StepKind::tool: tool(step); break;
      case StepKind::spindle: spindle(step); break;
      case StepKind::spindle_off: emit_.block({Function::spindle_stop}, {}); break;
      case StepKind::coolant: coolant(step); break;
      case StepKind::compensate: compensation_ = kCompensation[step.number]; break;
      case StepKind::feed: feed(step); break;
      case StepKind::rapid: move(Function::rapid, step); break;
      case StepKind::cut: move(Function::linear, step); break;
      case StepKind::arc_cw: emit_.block({Function::arc_cw}, words(step)); break;
      case StepKind::arc_ccw: emit_.block({Function::arc_ccw}, words(step)); break;
      case StepKind::profile_begin:
      case StepKind::profile_end: break;  // lines only, see Family::profiles
      case StepKind::for_begin: for_begin(step); break;
      case StepKind::for_end: for_end(); break;
      case StepKind::if_begin: emit_.open(StatementKind::if_begin, copy(step.values[0])); break;
      case StepKind::if_else: emit_.close(StatementKind::else_begin); break;
      case StepKind::if_end: emit_.close(StatementKind::if_end); break;
      case StepKind::let: emit_.assign(step.target, copy(step.values[0])); break;
      case StepKind::message: emit_.message(step.text); break;
      case StepKind::dwell: dwell(step); break;
      case StepKind::stop: emit_.block({Function::program_stop}, {}); break;
      case StepKind::optional_stop: emit_.block({Function::optional_stop}, {}); break;
    }
  }

  std::vector<EmittedWord> words(const Step& step) {
    std::vector<EmittedWord> out;
    for (std::uint32_t i = 0; i < step.word_count; ++i) {
      const StepWord& word = family_.words[step.first_word + i];
      out.push_back({word.address, copy(word.value)});
    }
    return out;
  }

  // Compensation begins and ends with a straight move: its code goes into the next one's block.
  void move(Function motion, const Step& step) {
    std::vector<EmittedCode> codes;
    if (compensation_ != Function::none) codes.push_back({std::exchange(compensation_, Function::none)});
    codes.push_back({motion});
    emit_.block(codes, words(step));
  }

  void work_offset(const Step& step) {
    const EmittedCode code{Function::work_offset, static_cast<std::int16_t>(step.number)};
    emit_.block(std::span(&code, 1), {});
  }

  // The first edge of the tool, as controls with edges say it; others make their own offset number of it.
  void tool(const Step& step) {
    const std::vector<EmittedWord> which = {{ir::Address::t, emit_.constant(step.number)},
                                            {ir::Address::d, emit_.constant(1.0)}};
    if (family_.machine == ir::MachineKind::lathe) {
      emit_.block(std::span<const EmittedCode>(), which);
    } else {
      emit_.block({Function::tool_change}, which);
    }
  }

  void spindle(const Step& step) {
    std::vector<EmittedWord> out = {{ir::Address::s, copy(step.values[0])}};
    if (step.values[1] != ExpressionId::none) out.push_back({ir::Address::spindle_limit, copy(step.values[1])});
    std::vector<EmittedCode> codes;
    if (step.dimension == kSurfaceSpeed) {
      codes.push_back({Function::surface_speed_on});
    } else if (family_.machine != ir::MachineKind::mill) {
      codes.push_back({Function::surface_speed_off});
    }
    if (step.direction != Function::none) codes.push_back({step.direction});
    emit_.block(codes, out);
  }

  static constexpr Function kCompensation[] = {Function::comp_off, Function::comp_left, Function::comp_right};

  void coolant(const Step& step) {
    static constexpr Function kCoolant[] = {Function::coolant_off, Function::coolant_mist, Function::coolant_flood};
    emit_.block({kCoolant[step.number]}, {});
  }

  void feed(const Step& step) {
    const std::vector<EmittedWord> value = {{ir::Address::f, copy(step.values[0])}};
    emit_.block({step.dimension == kFeedPerRev ? Function::feed_per_rev : Function::feed_per_min}, value);
  }

  // Seconds, as controls say it that count a dwell in F.
  void dwell(const Step& step) {
    const std::vector<EmittedWord> value = {{ir::Address::f, copy(step.values[0])}};
    emit_.block({Function::dwell}, value);
  }

  // What a loop's bound is named by: itself when it is a number or a name, otherwise a variable that is computed once.
  struct Bound {
    ir::SymbolId symbol = ir::SymbolId::none;
    double value = 0.0;
  };
  Bound bound(ExpressionId id, std::string_view stem) {
    const ir::Expression& e = family_.arena.at(id);
    if (e.op == Operator::constant) return {.value = e.value};
    if (e.op == Operator::variable) return {family_.arena.at(e.variable).symbol};
    const ExpressionId value = copy(id);
    const Bound out{emit_.new_symbol(stem)};
    emit_.assign(out.symbol, value);
    return out;
  }
  ExpressionId say(const Bound& bound) {
    return bound.symbol == ir::SymbolId::none ? emit_.constant(bound.value) : emit_.variable(bound.symbol);
  }

  // last = trunc((to - from)/step + 0.999999); while index <= last: t = from + index*step, and exactly `to` at last.
  void for_begin(const Step& step) {
    const std::string name(program_.strings.at(program_.at(step.target).name));
    const Bound from = bound(step.values[0], fmt::format("{}_from", name));
    const Bound to = bound(step.values[1], fmt::format("{}_to", name));
    const Bound by = bound(step.values[2], fmt::format("{}_step", name));
    const ir::SymbolId last = emit_.new_symbol(fmt::format("{}_last", name));
    const ir::SymbolId index = emit_.new_symbol(fmt::format("{}_index", name));

    const ExpressionId way = step.down ? emit_.binary(Operator::subtract, say(from), say(to))
                                       : emit_.binary(Operator::subtract, say(to), say(from));
    emit_.assign(last, emit_.binary(Operator::divide, way, say(by)));
    // Cutting goes toward zero, so a way that leads back must not come to it.
    emit_.open(StatementKind::if_begin, emit_.binary(Operator::less, emit_.variable(last), emit_.constant(kBackward)));
    emit_.assign(last, emit_.constant(-2.0));
    emit_.close(StatementKind::if_end);
    const ExpressionId raised = emit_.binary(Operator::add, emit_.variable(last), emit_.constant(kTripRounding));
    emit_.assign(last, program_.add_operator(Operator::truncate, raised));
    emit_.assign(index, emit_.constant(0.0));
    emit_.open(StatementKind::while_begin,
               emit_.binary(Operator::less_equal, emit_.variable(index), emit_.variable(last)));
    const ExpressionId gone = emit_.binary(Operator::multiply, emit_.variable(index), say(by));
    emit_.assign(step.target, emit_.binary(step.down ? Operator::subtract : Operator::add, say(from), gone));
    emit_.open(StatementKind::if_begin,
               emit_.binary(Operator::greater_equal, emit_.variable(index), emit_.variable(last)));
    emit_.assign(step.target, say(to));
    emit_.close(StatementKind::if_end);
    loops_.push_back({index});
  }

  void for_end() {
    const ir::SymbolId index = loops_.back().index;
    loops_.pop_back();
    emit_.assign(index, emit_.binary(Operator::add, emit_.variable(index), emit_.constant(1.0)));
    emit_.close(StatementKind::while_end);
  }

  const BoundFamily& bound_;
  const Family& family_;
  ir::Program program_;
  Emitter emit_;
  std::vector<Loop> loops_;
  Function compensation_ = Function::none;  // waits for the next move
};

}  // namespace

ir::Program build(const BoundFamily& bound) { return Builder(bound).build(); }

}  // namespace dripfeed::family

// One function a step.
#include "dialects/family/build.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/build_names.h"
#include "dialects/family/emitter.h"
#include "dialects/family/evaluate.h"
#include "dialects/family/value_writer.h"
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
  explicit Builder(const BoundFamily& bound)
      : bound_(bound),
        family_(*bound.family),
        names_(bound),
        emit_(program_),
        values_(bound, names_, program_, emit_),
        has_one_feed_mode_(!sets(StepKind::feed, kFeedPerRev) || !sets(StepKind::feed, kFeedPerMin)),
        uses_surface_speed_(sets(StepKind::spindle, kSurfaceSpeed)) {}

  ir::Program build() {
    program_.name = upper_name(family_);
    program_.strings = family_.arena.strings;
    program_.symbols = family_.arena.symbols;
    safe_start();
    for (const List& list : family_.lists)
      program_.symbols[static_cast<std::size_t>(list.symbol)].dimension1 =
          static_cast<std::uint16_t>(list_in(bound_.values, list.symbol).size());
    for (const Parameter& parameter : family_.parameters) {
      if (!names_.is_needed(parameter.symbol) || names_.is_fixed(parameter.symbol) ||
          parameter.kind == ParameterKind::list)
        continue;
      emit_.set_line(family_.source.position(parameter.span.begin).line);
      emit_.assign(parameter.symbol, emit_.constant(names_.value_of(parameter.symbol)));
    }
    define();
    for (std::size_t i = 0; i < family_.steps.size(); ++i) {
      emit_.set_line(family_.steps[i].line);
      i = build_step(i);
    }
    write_feed();
    write_compensation();
    emit_.program_end();
    ir::match_structures(program_);
    return std::move(program_);
  }

 private:
  struct Loop {
    ir::SymbolId index;
    Operator next = Operator::add;  // by one
  };

  [[nodiscard]] bool sets(StepKind kind, Dimension dimension) const {
    return std::ranges::any_of(family_.steps,
                               [=](const Step& one) { return one.kind == kind && one.dimension == dimension; });
  }

  // Lets and lists in the order of the text.
  void define() {
    auto list = family_.lists.begin();
    for (const Definition& definition : family_.definitions) {
      for (; list != family_.lists.end() && list->line < definition.line; ++list) build_list(*list);
      if (!names_.is_needed(definition.symbol) || names_.is_fixed(definition.symbol)) continue;
      emit_.set_line(definition.line);
      values_.assign(definition.symbol, definition.value);
    }
    for (; list != family_.lists.end(); ++list) build_list(*list);
  }

  void build_list(const List& list) {
    if (!names_.is_needed(list.symbol) || list.size > 0) return;
    emit_.set_line(list.line);
    const std::span<const double> numbers = list_in(bound_.values, list.symbol);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const ExpressionId value = list.elements.empty() ? emit_.constant(numbers[i]) : values_.copy(list.elements[i]);
      emit_.assign(list.symbol, value, values_.whole(static_cast<double>(i)));
    }
  }

  void safe_start() {
    emit_.set_line(family_.program_line);
    const bool mill = family_.machine == ir::MachineKind::mill;
    const auto first_feed = std::ranges::find(family_.steps, StepKind::feed, &Step::kind);
    const bool per_rev = first_feed != family_.steps.end() && first_feed->dimension == kFeedPerRev;
    const Function feed = per_rev ? Function::feed_per_rev : Function::feed_per_min;
    if (mill) {
      emit_.block({Function::unit_mm, Function::plane_xy, Function::absolute, feed, Function::comp_off}, {});
    } else {
      emit_.block({Function::unit_mm, Function::plane_zx, Function::absolute, feed, Function::surface_speed_off,
                   Function::comp_off, family_.x_is_diameter ? Function::diameter_on : Function::diameter_off},
                  {});
    }
  }

  // Returns the last step that was built.
  std::size_t build_step(std::size_t at) {
    const Step& step = family_.steps[at];
    if (joins_paths(step.kind)) {
      write_compensation();
      write_feed();
      motion_ = Function::none;
    }
    // A feed that waits has the value that it had when it was set.
    const bool assigns = step.kind == StepKind::let || step.kind == StepKind::set;
    if (assigns && feed_ != nullptr && names(family_.arena, feed_->values[0], step.target)) write_feed();
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
      case StepKind::arc_cw: arc(Function::arc_cw, step); break;
      case StepKind::arc_ccw: arc(Function::arc_ccw, step); break;
      case StepKind::profile_begin:
      case StepKind::profile_end: break;  // lines only, see Family::profiles
      case StepKind::for_begin: for_begin(step); break;
      case StepKind::for_end: for_end(); break;
      case StepKind::for_in_begin: for_in_begin(step); break;
      case StepKind::for_in_end: for_end(); break;
      case StepKind::while_begin: while_begin(step); break;
      case StepKind::while_end: while_end(); break;
      case StepKind::if_begin: return if_begin(at);
      case StepKind::if_else: return if_else(at);
      case StepKind::if_end: if_end(); break;
      case StepKind::let: values_.assign(step.target, step.values[0]); break;
      case StepKind::set: set(step); break;
      case StepKind::message: emit_.message(step.text); break;
      case StepKind::dwell: dwell(step); break;
      case StepKind::stop: emit_.block({Function::program_stop}, {}); break;
      case StepKind::optional_stop: emit_.block({Function::optional_stop}, {}); break;
    }
    return at;
  }

  void set(const Step& step) {
    if (step.values[1] == ExpressionId::none) return values_.assign(step.target, step.values[0]);
    const ExpressionId index = values_.copy(step.values[1]);
    emit_.assign(step.target, values_.copy(step.values[0]), index);
  }

  // Of a condition that is decided now only one branch is built.
  std::size_t if_begin(std::size_t at) {
    const ExpressionId condition = family_.steps[at].values[0];
    decided_.push_back(names_.is_decided(condition));
    if (!decided_.back()) {
      emit_.open(StatementKind::if_begin, values_.copy(condition));
      return at;
    }
    return evaluate(family_.arena, condition, bound_.values).value != 0.0 ? at : skip_branch(at);
  }

  std::size_t if_else(std::size_t at) {
    if (decided_.back()) return skip_branch(at);
    emit_.close(StatementKind::else_begin);
    return at;
  }

  void if_end() {
    if (!decided_.back()) emit_.close(StatementKind::if_end);
    decided_.pop_back();
  }

  // From an `if` or `else` whose branch is not taken: to its `else`, or to the step before its `end`.
  [[nodiscard]] std::size_t skip_branch(std::size_t at) const {
    std::size_t depth = 0;
    for (++at;; ++at) {
      const StepKind kind = family_.steps[at].kind;
      if (depth == 0 && kind == StepKind::if_else) return at;
      if (depth == 0 && kind == StepKind::if_end) return at - 1;
      if (kind == StepKind::if_begin) ++depth;
      if (kind == StepKind::if_end) --depth;
    }
  }

  // A condition that takes statements is found in the loop:
  //   go_on = 1;  while go_on = 1;  statements;  if condition;  body;  else;  go_on = 0;  end;  end
  void while_begin(const Step& step) {
    if (!values_.needs_statements(step.values[0])) {
      emit_.open(StatementKind::while_begin, values_.copy(step.values[0]));
      return conditions_.push_back(ir::SymbolId::none);
    }
    const ir::SymbolId go_on = emit_.new_symbol("go_on");
    emit_.assign(go_on, emit_.constant(1.0));
    emit_.open(StatementKind::while_begin, emit_.binary(Operator::equal, emit_.variable(go_on), emit_.constant(1.0)));
    emit_.open(StatementKind::if_begin, values_.copy(step.values[0]));
    conditions_.push_back(go_on);
  }

  void while_end() {
    const ir::SymbolId go_on = conditions_.back();
    conditions_.pop_back();
    if (go_on != ir::SymbolId::none) {
      emit_.close(StatementKind::else_begin);
      emit_.assign(go_on, emit_.constant(0.0));
      emit_.close(StatementKind::if_end);
    }
    emit_.close(StatementKind::while_end);
  }

  // index = 0; while index < count: target = list[index]
  void for_in_begin(const Step& step) {
    const List& list = family_.lists[static_cast<std::size_t>(step.number)];
    const std::string name(program_.strings.at(program_.at(step.target).name));
    const ir::SymbolId index = emit_.new_symbol(fmt::format("{}_index", name));
    emit_.assign(index, emit_.constant(0.0));
    emit_.open(StatementKind::while_begin,
               emit_.binary(Operator::less, emit_.variable(index), emit_.constant(names_.value_of(list.count))));
    emit_.assign(step.target, emit_.variable(list.symbol, emit_.variable(index)));
    loops_.push_back({index, Operator::add});
  }

  std::vector<EmittedWord> words(const Step& step) {
    std::vector<EmittedWord> out;
    for (std::uint32_t i = 0; i < step.word_count; ++i) {
      const StepWord& word = family_.words[step.first_word + i];
      out.push_back({word.address, values_.copy(word.value)});
    }
    return out;
  }

  // Compensation begins and ends with a straight move: its code goes into the next one's block.
  void move(Function motion, const Step& step) {
    std::vector<EmittedWord> to = words(step);  // may make statements of its own
    if (motion != Function::rapid) take_feed(to);
    std::vector<EmittedCode> codes;
    if (compensation_ != Function::none) codes.push_back({std::exchange(compensation_, Function::none)});
    take_motion(motion, codes);
    emit_.block(codes, to);
  }

  void arc(Function motion, const Step& step) {
    std::vector<EmittedWord> to = words(step);
    take_feed(to);
    std::vector<EmittedCode> codes;
    take_motion(motion, codes);
    emit_.block(codes, to);
  }

  void take_feed(std::vector<EmittedWord>& words) {
    if (feed_ != nullptr) words.push_back({ir::Address::f, values_.copy(std::exchange(feed_, nullptr)->values[0])});
  }

  // The code, unless it is in effect.
  void take_motion(Function motion, std::vector<EmittedCode>& codes) {
    if (std::exchange(motion_, motion) != motion) codes.push_back({motion});
  }

  // After these another block may have come before: what is in effect there is not known.
  static bool joins_paths(StepKind kind) { return kind >= StepKind::for_begin && kind <= StepKind::if_end; }

  void work_offset(const Step& step) {
    const EmittedCode code{Function::work_offset, static_cast<std::int16_t>(step.number)};
    emit_.block(std::span(&code, 1), {});
  }

  // The first edge of the tool, as controls with edges say it; others make their own offset number of it.
  void tool(const Step& step) {
    const std::vector<EmittedWord> which = {{ir::Address::t, emit_.constant(tool_number(bound_, step))},
                                            {ir::Address::d, emit_.constant(1.0)}};
    if (family_.machine == ir::MachineKind::lathe) {
      emit_.block(std::span<const EmittedCode>(), which);
    } else {
      emit_.block({Function::tool_change}, which);
    }
  }

  void spindle(const Step& step) {
    std::vector<EmittedWord> out = {{ir::Address::s, values_.copy(step.values[0])}};
    if (step.values[1] != ExpressionId::none) out.push_back({ir::Address::spindle_limit, values_.copy(step.values[1])});
    std::vector<EmittedCode> codes;
    if (step.dimension == kSurfaceSpeed) {
      codes.push_back({Function::surface_speed_on});
    } else if (uses_surface_speed_) {
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

  // Into the block of the next cut, unless something comes between that is on one path only.
  void feed(const Step& step) {
    write_feed();
    feed_ = &step;
    if (!has_one_feed_mode_) write_feed();
  }

  // In a block of its own, from where it waits for a move on one path only.
  void write_compensation() {
    if (compensation_ != Function::none) emit_.block({std::exchange(compensation_, Function::none)}, {});
  }

  void write_feed() {
    if (feed_ == nullptr) return;
    const Step& step = *std::exchange(feed_, nullptr);
    const std::vector<EmittedWord> value = {{ir::Address::f, values_.copy(step.values[0])}};
    if (has_one_feed_mode_) return emit_.block(std::span<const EmittedCode>(), value);
    emit_.block({step.dimension == kFeedPerRev ? Function::feed_per_rev : Function::feed_per_min}, value);
  }

  // Seconds, as controls say it that count a dwell in F.
  void dwell(const Step& step) {
    const std::vector<EmittedWord> value = {{ir::Address::f, values_.copy(step.values[0])}};
    emit_.block({Function::dwell}, value);
  }

  // last = trunc((to - from)/step + 0.999999); while index <= last: t = from + index*step, and exactly `to` at last.
  void for_begin(const Step& step) {
    const std::string name(program_.strings.at(program_.at(step.target).name));
    const ValueWriter::Bound from = values_.bound(step.values[0], fmt::format("{}_from", name));
    const ValueWriter::Bound to = values_.bound(step.values[1], fmt::format("{}_to", name));
    if (names_.counts_whole(step)) return count_begin(step, from, to);
    const ValueWriter::Bound by = values_.bound(step.values[2], fmt::format("{}_step", name));
    const ExpressionId way = step.down ? values_.calculate(Operator::subtract, values_.say(from), values_.say(to))
                                       : values_.calculate(Operator::subtract, values_.say(to), values_.say(from));
    const ExpressionId trips = values_.calculate(Operator::divide, way, values_.say(by));
    const ValueWriter::Bound last = last_trip(trips, name);
    const ir::SymbolId index = emit_.new_symbol(fmt::format("{}_index", name));
    emit_.assign(index, emit_.constant(0.0));
    emit_.open(StatementKind::while_begin,
               emit_.binary(Operator::less_equal, emit_.variable(index), values_.say(last)));
    const ExpressionId gone = values_.calculate(Operator::multiply, emit_.variable(index), values_.say(by));
    emit_.assign(step.target,
                 values_.calculate(step.down ? Operator::subtract : Operator::add, values_.say(from), gone));
    emit_.open(StatementKind::if_begin,
               emit_.binary(Operator::greater_equal, emit_.variable(index), values_.say(last)));
    emit_.assign(step.target, values_.say(to));
    emit_.close(StatementKind::if_end);
    loops_.push_back({index, Operator::add});
  }

  // The number of the last trip, from 0; less than 0 where there is none.
  ValueWriter::Bound last_trip(ExpressionId trips, std::string_view name) {
    if (const std::optional<double> known = values_.number(trips))
      return {.value = *known < kBackward ? -2.0 : std::trunc(*known + kTripRounding)};
    const ValueWriter::Bound last{.symbol = emit_.new_symbol(fmt::format("{}_last", name))};
    emit_.assign(last.symbol, trips);
    // Cutting goes toward zero, so a path that leads back must not come to it.
    emit_.open(StatementKind::if_begin, emit_.binary(Operator::less, values_.say(last), emit_.constant(kBackward)));
    emit_.assign(last.symbol, emit_.constant(-2.0));
    emit_.close(StatementKind::if_end);
    const ExpressionId raised = emit_.binary(Operator::add, values_.say(last), emit_.constant(kTripRounding));
    emit_.assign(last.symbol, program_.add_operator(Operator::truncate, raised));
    return last;
  }

  // The name counts itself.
  void count_begin(const Step& step, const ValueWriter::Bound& from, const ValueWriter::Bound& to) {
    emit_.assign(step.target, values_.say(from));
    emit_.open(StatementKind::while_begin, emit_.binary(step.down ? Operator::greater_equal : Operator::less_equal,
                                                        emit_.variable(step.target), values_.say(to)));
    loops_.push_back({step.target, step.down ? Operator::subtract : Operator::add});
  }

  void for_end() {
    const Loop loop = loops_.back();
    loops_.pop_back();
    emit_.assign(loop.index, emit_.binary(loop.next, emit_.variable(loop.index), emit_.constant(1.0)));
    emit_.close(StatementKind::while_end);
  }

  const BoundFamily& bound_;
  const Family& family_;
  BuildNames names_;
  ir::Program program_;
  Emitter emit_;
  ValueWriter values_;
  bool has_one_feed_mode_;   // the start of the program states it for all
  bool uses_surface_speed_;  // otherwise the start of the program ends it
  std::vector<Loop> loops_;
  std::vector<bool> decided_;               // of open `if`s: only one branch is built
  std::vector<ir::SymbolId> conditions_;    // of open `while`s: go_on, or none
  Function compensation_ = Function::none;  // waits for the next move
  Function motion_ = Function::none;        // in effect, as far as that is known
  const Step* feed_ = nullptr;              // waits for the next cut
};

}  // namespace

ir::Program build(const BoundFamily& bound) { return Builder(bound).build(); }

}  // namespace dripfeed::family

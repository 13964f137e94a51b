// The order of the program: its start, the declarations, and one step after the other.
#include "dialects/family/build.h"

#include <algorithm>
#include <string>
#include <utility>

#include "dialects/family/builder.h"
#include "dialects/family/engraving.h"
#include "dialects/family/evaluate.h"
#include "dialects/family/message_text.h"
#include "dialects/ir/transformation_use.h"

namespace dripfeed::family {

using ir::ExpressionId;
using ir::Function;
using ir::StatementKind;

namespace {

std::string upper_name(const Family& family) {
  std::string out = family.program_name.empty() ? family.name : family.program_name;
  for (char& c : out) {
    if (c == '-') c = '_';
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return out;
}

}  // namespace

ir::Program Builder::build() {
  program_.name = upper_name(family_);
  program_.strings = family_.arena.strings;
  program_.symbols = family_.arena.symbols;
  if (keeps_feed()) feed_now_ = emit_.new_symbol("feed_now");
  safe_start();
  for (const List& list : family_.lists)
    program_.symbols[static_cast<std::size_t>(list.symbol)].dimension1 =
        static_cast<std::uint16_t>(list_in(bound_.values, list.symbol).size());
  for (const Parameter& parameter : family_.parameters) {
    if (!names_.is_needed(parameter.symbol) || names_.is_fixed(parameter.symbol) ||
        parameter.kind == ParameterKind::list || parameter.kind == ParameterKind::text)
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

void Builder::define() {
  auto list = family_.lists.begin();
  for (const Definition& definition : family_.definitions) {
    for (; list != family_.lists.end() && list->line < definition.line; ++list) build_list(*list);
    if (!names_.is_needed(definition.symbol) || names_.is_fixed(definition.symbol)) continue;
    emit_.set_line(definition.line);
    values_.assign(definition.symbol, definition.value);
  }
  for (; list != family_.lists.end(); ++list) build_list(*list);
}

void Builder::build_list(const List& list) {
  if (!names_.is_needed(list.symbol) || list.size > 0) return;
  emit_.set_line(list.line);
  const std::span<const double> numbers = list_in(bound_.values, list.symbol);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const ExpressionId value = list.elements.empty() ? emit_.constant(numbers[i]) : values_.copy(list.elements[i]);
    emit_.assign(list.symbol, value, values_.whole(static_cast<double>(i)));
  }
}

void Builder::safe_start() {
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

std::size_t Builder::build_step(std::size_t at) {
  const std::uint8_t level = family_.steps[at].skip_level;
  if (level == 0) return build_one(at);
  write_compensation();
  write_feed();
  motion_ = Function::none;
  const std::size_t first = program_.statements.size();
  build_one(at);
  for (std::size_t i = first; i < program_.statements.size(); ++i) {
    ir::Statement& made = program_.statements[i];
    if (made.kind == StatementKind::block || made.kind == StatementKind::message) made.skip_level = level;
  }
  motion_ = Function::none;
  return at;
}

std::size_t Builder::build_one(std::size_t at) {
  const Step& step = family_.steps[at];
  if (joins_paths(step.kind) && !is_decided(step)) {
    write_compensation();
    write_feed();
    motion_ = Function::none;
    if (drill_.is_open()) drill_.fork(step.kind);
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
    case StepKind::thread: thread(step); break;
    case StepKind::drill_begin: drill_begin(step); break;
    case StepKind::hole: hole(step); break;
    case StepKind::drill_end: drill_end(); break;
    case StepKind::engrave: break;  // strokes by now
    case StepKind::profile_begin:
    case StepKind::profile_end: break;  // lines only, see Family::profiles
    case StepKind::for_begin: loops_.for_begin(step); break;
    case StepKind::for_end: loops_.for_end(); break;
    case StepKind::for_in_begin: loops_.for_in_begin(step); break;
    case StepKind::for_in_end: loops_.for_end(); break;
    case StepKind::while_begin: loops_.while_begin(step); break;
    case StepKind::while_end: loops_.while_end(); break;
    case StepKind::if_begin: return if_begin(at);
    case StepKind::if_else: return if_else(at);
    case StepKind::if_end: if_end(); break;
    case StepKind::let: values_.assign(step.target, step.values[0]); break;
    case StepKind::set: set(step); break;
    case StepKind::message: emit_.message(message_text(bound_, step)); break;
    case StepKind::dwell: dwell(step); break;
    case StepKind::stop: emit_.block({Function::program_stop}, {}); break;
    case StepKind::optional_stop: emit_.block({Function::optional_stop}, {}); break;
    case StepKind::plane: emit_.block({kPlanes[step.number]}, {}); break;
    case StepKind::native: native(step); break;
    case StepKind::polar_begin: polar_begin(); break;
    case StepKind::polar_end: polar_end(); break;
    case StepKind::cylinder_begin: cylinder_begin(step); break;
    case StepKind::cylinder_end: transformation(ir::kTransformationEnds, {}); break;
    case StepKind::require:
    case StepKind::offset:
    case StepKind::contour: break;  // checked before
  }
  return at;
}

bool Builder::joins_paths(StepKind kind) { return kind >= StepKind::for_begin && kind <= StepKind::if_end; }

bool Builder::is_decided(const Step& step) const {
  if (step.kind == StepKind::if_begin) return names_.is_decided(step.values[0]);
  return (step.kind == StepKind::if_else || step.kind == StepKind::if_end) && decided_.back();
}

void Builder::set(const Step& step) {
  if (step.values[1] == ExpressionId::none) return values_.assign(step.target, step.values[0]);
  const ExpressionId index = values_.copy(step.values[1]);
  emit_.assign(step.target, values_.copy(step.values[0]), index);
}

std::size_t Builder::if_begin(std::size_t at) {
  const ExpressionId condition = family_.steps[at].values[0];
  decided_.push_back(names_.is_decided(condition));
  if (!decided_.back()) {
    emit_.open(StatementKind::if_begin, values_.copy(condition));
    return at;
  }
  return evaluate(family_.arena, condition, bound_.values).value != 0.0 ? at : skip_branch(family_.steps, at);
}

std::size_t Builder::if_else(std::size_t at) {
  if (decided_.back()) return skip_branch(family_.steps, at);
  emit_.close(StatementKind::else_begin);
  return at;
}

void Builder::if_end() {
  if (!decided_.back()) emit_.close(StatementKind::if_end);
  decided_.pop_back();
}

ir::Program build(const BoundFamily& bound) {
  const BoundFamily whole = with_strokes(bound);
  return Builder(whole).build();
}

}  // namespace dripfeed::family

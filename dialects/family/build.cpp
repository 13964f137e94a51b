// One function a step.
#include "dialects/family/build.h"

#include <algorithm>
#include <string>
#include <utility>

#include "dialects/family/build_names.h"
#include "dialects/family/drill_writer.h"
#include "dialects/family/emitter.h"
#include "dialects/family/engraving.h"
#include "dialects/family/evaluate.h"
#include "dialects/family/loop_writer.h"
#include "dialects/family/message_text.h"
#include "dialects/family/value_writer.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/transformation_use.h"

namespace dripfeed::family {

namespace {

using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;

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
        drill_(bound, values_, emit_),
        loops_(family_, names_, program_, values_, emit_),
        has_one_feed_mode_(!sets(StepKind::feed, kFeedPerRev) || !sets(StepKind::feed, kFeedPerMin)),
        uses_surface_speed_(sets(StepKind::spindle, kSurfaceSpeed)) {}

  ir::Program build() {
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

 private:
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

  // Returns the last step that was built. What a control may skip stands in blocks of its own: nothing that waits goes
  // into them, and the next block states again what they might have set. What is computed for them is computed always.
  std::size_t build_step(std::size_t at) {
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

  std::size_t build_one(std::size_t at) {
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
    return evaluate(family_.arena, condition, bound_.values).value != 0.0 ? at : skip_branch(family_.steps, at);
  }

  std::size_t if_else(std::size_t at) {
    if (decided_.back()) return skip_branch(family_.steps, at);
    emit_.close(StatementKind::else_begin);
    return at;
  }

  void if_end() {
    if (!decided_.back()) emit_.close(StatementKind::if_end);
    decided_.pop_back();
  }

  std::vector<EmittedWord> words(const Step& step) {
    std::vector<EmittedWord> out;
    for (std::uint32_t i = 0; i < step.word_count; ++i) {
      const StepWord& word = family_.words[step.first_word + i];
      out.push_back(
          {word.address, values_.copy(word.value), word.is_step ? ir::WordMode::incremental : ir::WordMode::as_modal});
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
    if (feed_ != nullptr) words.push_back({ir::Address::f, say_feed(*std::exchange(feed_, nullptr))});
  }

  // F of a tap or a thread is its pitch, and an entry has its own: the feed before is written again after them. Where
  // that may be one of several, or a value that has changed, a variable of its own keeps it.
  [[nodiscard]] bool keeps_feed() const {
    const auto passes = [](const Step& one) { return one.kind == StepKind::feed && one.number != 0; };
    if (std::ranges::none_of(family_.steps, takes_feed_away) && std::ranges::none_of(family_.steps, passes))
      return false;
    const auto is_feed = [](const Step& one) { return one.kind == StepKind::feed && one.number == 0; };
    const auto first = std::ranges::find_if(family_.steps, is_feed);
    return first != family_.steps.end() &&
           (std::ranges::count_if(family_.steps, is_feed) > 1 || !is_declared(first->values[0]));
  }
  // A number, or a name that no step gives a value.
  [[nodiscard]] bool is_declared(ExpressionId id) const {
    const ir::Expression& e = family_.arena.at(id);
    if (e.op == Operator::constant) return true;
    if (e.op != Operator::variable || family_.arena.at(e.variable).index != ExpressionId::none) return false;
    const ir::SymbolId symbol = family_.arena.at(e.variable).symbol;
    return std::ranges::find(family_.parameters, symbol, &Parameter::symbol) != family_.parameters.end() ||
           std::ranges::find(family_.definitions, symbol, &Definition::symbol) != family_.definitions.end();
  }

  ExpressionId say_feed(const Step& step) {
    const bool is_kept = feed_now_ != ir::SymbolId::none && step.number == 0;
    return is_kept ? emit_.variable(feed_now_) : values_.copy(step.values[0]);
  }

  // Each has its pitch: on controls that have it in F the next cut writes the feed again.
  void thread(const Step& step) {
    const std::vector<EmittedWord> to = words(step);
    std::vector<EmittedCode> codes;
    take_motion(Function::thread, codes);
    emit_.block(codes, to);
    feed_ = last_feed_;
  }

  void drill_begin(const Step& step) {
    drill_.begin(step);
    if (drill_.taps()) feed_ = nullptr;  // stated after the tap
    if (step.values[0] == ExpressionId::none) return;
    std::vector<EmittedCode> codes;
    take_motion(Function::rapid, codes);
    const std::vector<EmittedWord> to = {{ir::Address::z, values_.say(drill_.return_level())}};
    emit_.block(codes, to);
  }

  void hole(const Step& step) {
    std::vector<EmittedWord> to = words(step);
    std::vector<EmittedWord> feed;
    if (!drill_.taps()) take_feed(feed);
    drill_.hole(std::move(to), feed);
  }

  void drill_end() {
    const bool taps = drill_.taps();
    drill_.end();
    motion_ = Function::none;
    if (!taps) return;
    const bool per_rev = sets(StepKind::feed, kFeedPerRev);
    std::vector<EmittedWord> words;
    if (last_feed_ != nullptr) words.push_back({ir::Address::f, say_feed(*last_feed_)});
    feed_ = nullptr;
    if (!per_rev)
      emit_.block({Function::feed_per_min}, words);
    else if (!words.empty())
      emit_.block(std::span<const EmittedCode>(), words);
  }

  // An M function stands for it until it is printed. What it may have changed is stated again after it.
  void native(const Step& step) {
    const NativeVerb& verb = family_.natives[static_cast<std::size_t>(step.number)];
    const EmittedCode code{Function::machine_function, static_cast<std::int16_t>(kFirstNativeFunction + step.number)};
    emit_.block(std::span(&code, 1), {});
    if (verb.changes_motion) motion_ = Function::none;
    if (verb.changes_feed) feed_ = last_feed_;
  }

  // The code, unless it is in effect.
  void take_motion(Function motion, std::vector<EmittedCode>& codes) {
    if (std::exchange(motion_, motion) != motion) codes.push_back({motion});
  }

  // After these another block may have come before: what is in effect there is not known.
  static bool joins_paths(StepKind kind) { return kind >= StepKind::for_begin && kind <= StepKind::if_end; }

  // Of an `if`, its `else` and its end: whether there is one path alone, the branch that is built.
  [[nodiscard]] bool is_decided(const Step& step) const {
    if (step.kind == StepKind::if_begin) return names_.is_decided(step.values[0]);
    return (step.kind == StepKind::if_else || step.kind == StepKind::if_end) && decided_.back();
  }

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

  static constexpr Function kPlanes[] = {Function::plane_xy, Function::plane_zx, Function::plane_yz};
  static constexpr Function kCompensation[] = {Function::comp_off, Function::comp_left, Function::comp_right};

  void coolant(const Step& step) {
    static constexpr Function kCoolant[] = {Function::coolant_off, Function::coolant_mist, Function::coolant_flood};
    emit_.block({kCoolant[step.number]}, {});
  }

  // Into the block of the next cut, unless something comes between that is on one path only.
  void feed(const Step& step) {
    write_feed();
    if (step.number == kFeedBefore) {
      feed_ = last_feed_;
    } else {
      feed_ = &step;
      if (step.number == 0) {
        if (feed_now_ != ir::SymbolId::none) values_.assign(feed_now_, step.values[0]);
        last_feed_ = &step;
      }
    }
    if (!has_one_feed_mode_) write_feed();
  }

  // In a block of its own, from where it waits for a move on one path only.
  void write_compensation() {
    if (compensation_ != Function::none) emit_.block({std::exchange(compensation_, Function::none)}, {});
  }

  void write_feed() {
    if (feed_ == nullptr) return;
    const Step& step = *std::exchange(feed_, nullptr);
    const std::vector<EmittedWord> value = {{ir::Address::f, say_feed(step)}};
    if (has_one_feed_mode_) return emit_.block(std::span<const EmittedCode>(), value);
    emit_.block({step.dimension == kFeedPerRev ? Function::feed_per_rev : Function::feed_per_min}, value);
  }

  // The plane of the face counts inside of it.
  void polar_begin() {
    transformation(ir::kFaceByY, {});
    emit_.block({Function::plane_xy}, {});
  }
  void polar_end() {
    emit_.block({Function::plane_zx}, {});
    transformation(ir::kTransformationEnds, {});
  }
  void cylinder_begin(const Step& step) {
    const double diameter = evaluate(family_.arena, step.values[0], bound_.values).value;
    transformation(ir::kCylinderByY, {{{ir::Address::r, emit_.constant(diameter)}}});
  }
  void transformation(std::int16_t use, std::span<const EmittedWord> words) {
    const EmittedCode code{Function::transformation, use};
    emit_.block(std::span(&code, 1), words);
    motion_ = Function::none;
  }

  // Seconds, as controls say it that count a dwell in F.
  void dwell(const Step& step) {
    const std::vector<EmittedWord> value = {{ir::Address::f, values_.copy(step.values[0])}};
    emit_.block({Function::dwell}, value);
  }

  const BoundFamily& bound_;
  const Family& family_;
  BuildNames names_;
  ir::Program program_;
  Emitter emit_;
  ValueWriter values_;
  DrillWriter drill_;
  LoopWriter loops_;
  bool has_one_feed_mode_;                      // the start of the program states it for all
  bool uses_surface_speed_;                     // otherwise the start of the program ends it
  std::vector<bool> decided_;                   // of open `if`s: only one branch is built
  Function compensation_ = Function::none;      // waits for the next move
  Function motion_ = Function::none;            // in effect, as far as that is known
  const Step* feed_ = nullptr;                  // waits for the next cut
  const Step* last_feed_ = nullptr;             // in the order of the text
  ir::SymbolId feed_now_ = ir::SymbolId::none;  // keeps the feed while taps and threads are cut
};

}  // namespace

ir::Program build(const BoundFamily& bound) {
  const BoundFamily whole = with_strokes(bound);
  return Builder(whole).build();
}

}  // namespace dripfeed::family

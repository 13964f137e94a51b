// Motions come in batches and executed blocks one by one, so both are kept with their ordinals and joined at the end of
// each batch: a motion belongs to the last block with its ordinal.
#include "dialects/compile/plain/explicit_program.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/source_lines.h"
#include "dialects/compile/plain/block_writer.h"
#include "dialects/compile/plain/carried_words.h"
#include "dialects/compile/plain/lost_writes.h"
#include "dialects/ir/called_cycle.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rigid_taps.h"

namespace dripfeed::compile {

namespace {

// What the run knows and moves do not state, unless the refusal is of a kind of its own.
text::Diagnostic cannot_write(passes::Refusal what, text::Span span) {
  if (what.id == text::DiagnosticId::cannot_translate) what.id = text::DiagnosticId::translation_macro_only;
  return passes::diagnose(std::move(what), span, "plain blocks");
}

// The control that the explicit blocks are written for: neutral, but with the tool words of the source.
ir::Control explicit_control(const ir::Control& source) {
  const bool diameter =
      source.kind == ir::MachineKind::lathe ||
      (source.kind == ir::MachineKind::mill_turn && source.semantics.power_on_diameter != ir::DiameterMode::radius);
  ir::Control out = neutral_control(source.kind, diameter);
  out.axes = source.axes;
  out.semantics.tool_word = source.semantics.tool_word;
  out.semantics.d_selects_edge = source.semantics.d_selects_edge;
  return out;
}

// G70 of SINUMERIK leaves the feeds metric: such a program is written in mm.
bool is_in_inches(const ir::Program& program, const ir::Control& control) {
  bool inch = false;
  for (const ir::Code& c : program.codes) {
    if (c.function == ir::Function::unit_mm || (c.function == ir::Function::unit_inch && c.argument != 0)) return false;
    inch |= c.function == ir::Function::unit_inch;
  }
  const auto given = std::ranges::find(control.caller_modes, ir::ModalGroup::unit, &ir::CodeRow::group);
  if (inch || given == control.caller_modes.end())
    return inch || (control.semantics.power_on_known && control.semantics.power_on_unit == ir::Function::unit_inch);
  return given->function == ir::Function::unit_inch && given->argument == 0;
}

class Recorder final : public ir::MotionSink, public interpreter::BlockObserver {
 public:
  Recorder(const ir::Program& source, ExplicitProgram& out, CarriedBlocks& carried, const interpreter::RunNames& names,
           const ExplicitOptions& options, const ir::Control& control)
      : source_(source),
        out_(out),
        carried_(carried),
        writes_(control),
        names_(names),
        writer_(out.program, out.control, names, options.own_unit && is_in_inches(source, control)),
        want_changes_(options.want_changes),
        is_quick_(!options.want_changes && source.source.text().empty()),
        keeps_taps_(options.keep_taps && std::ranges::any_of(source.codes, passes::is_tap)) {
    for (const ir::Statement& s : source.statements)
      if (options.keep_skips && s.skip_level != 0) skips_.emplace(s.line, s.skip_level);
    const bool has_runs = options.runs != nullptr && options.runs->serves(out.control);
    if (has_runs && !keeps_taps_ && skips_.empty()) runs_ = options.runs;
  }

  void block(const ir::Place& place, std::span<const interpreter::VariableChange> changes) override {
    if (place.program == 0) {
      main_line_ = place.line;
      in_call_ = false;
      // Most blocks only compute, and of a family's program there is no text that could write anything.
      if (is_quick_ && carried_.at(0, names_.programs, place.line) == nullptr) return;
    }
    look_at(place, changes);
  }

  void consume(std::span<const ir::Motion> motions) override {
    for (const ir::Motion& motion : motions) {
      if (!keeps_taps_) {
        take(motion);
        continue;
      }
      if (!held_.empty() && held_.front().place.ordinal != motion.place.ordinal) release();
      held_.push_back(motion);
    }
  }

  // A cut right after another, with the spindle turned round between them: a tap. As a thread of a cycle, it is a
  // rigid one (G84 with ,R1).
  [[nodiscard]] bool turns_back() const { return turns_back_; }
  [[nodiscard]] bool turns_back_in_thread() const { return turns_back_in_thread_; }

  void finish(const interpreter::RunResult& run) {
    release();
    if (runs_ != nullptr) runs_->finish();
    if (!started_) start(nullptr);
    carry_until(~std::uint64_t{0});
    for (text::Diagnostic& lost : writes_.found()) out_.lost.push_back(std::move(lost));
    writer_.flush(out_.origins.empty() ? 0 : static_cast<std::uint32_t>(out_.origins.size()));
    if (run.ended == interpreter::Ended::end && !ended_ && returns_at(run.last))
      writer_.write_return(origin({run.last.line, run.last.ordinal}));
  }

 private:
  void look_at(const ir::Place& place, std::span<const interpreter::VariableChange> changes) {
    if (place.program != 0 && !std::exchange(in_call_, true)) calls_.push_back({main_line_, place.ordinal});
    if (const CarriedBlock* carried = carried_.at(place.program, names_.programs, place.line)) {
      for (const passes::Refusal& word : carried->lost) lose(word);
      pending_.push_back({place.ordinal, main_line_, carried});
    }
    if (!source_.source.text().empty())
      writes_.executed(place.program, program_of(place.program), place.line, span_of_line(out_.source, main_line_));
    if (!want_changes_) return;
    for (const interpreter::VariableChange& change : changes) out_.changes.push_back({place.ordinal, change});
  }

  void take(const ir::Motion& motion) {
    watch_spindle(motion);
    const bool cuts = ir::is_move(motion.kind) && motion.kind != ir::MotionKind::rapid;
    if (cuts && motion.feed == 0.0) lose(passes::not_known("a cut whose feed is not known"));
    const bool has_run = runs_ != nullptr && states_positions_alone(motion);
    if (has_run && runs_->add(motion)) return;
    if (runs_ != nullptr && !has_run) runs_->end();
    carry_until(motion.place.ordinal);
    if (!std::exchange(started_, true)) start(&motion);
    const std::uint32_t line = origin({line_of(motion.place), motion.place.ordinal});
    if (motion.kind == ir::MotionKind::end && returns_at(motion.place))
      writer_.write_return(line);
    else if (const auto skip = skips_.find(motion.place.line); skip != skips_.end() && motion.place.program == 0)
      write_skipped(motion, line, skip->second);
    else
      writer_.write(motion, line);
    if (has_run) runs_->sample(motion, line);
    ended_ = ended_ || motion.kind == ir::MotionKind::end;
  }

  [[nodiscard]] bool states_positions_alone(const ir::Motion& motion) const {
    const bool waits = next_pending_ < pending_.size() && pending_[next_pending_].ordinal <= motion.place.ordinal;
    return started_ && !waits && writer_.states_positions_alone(motion);
  }

  // What the block sets counts for it alone.
  void write_skipped(const ir::Motion& motion, std::uint32_t line, std::uint8_t level) {
    writer_.forget(line);
    const std::size_t first = out_.program.statements.size();
    writer_.write(motion, line);
    for (std::size_t i = first; i < out_.program.statements.size(); ++i) out_.program.statements[i].skip_level = level;
    writer_.forget(line);
  }

  // The motions of one block. Where it turns the spindle round between two cuts, it taps.
  void release() {
    const std::vector<ir::Motion> block = std::exchange(held_, {});
    const auto cuts_turning = [&](ir::SpindleState direction) {
      return std::ranges::any_of(block, [direction](const ir::Motion& m) {
        return m.kind == ir::MotionKind::linear && m.spindle == direction;
      });
    };
    if (cuts_turning(ir::SpindleState::clockwise) && cuts_turning(ir::SpindleState::counterclockwise)) {
      const ir::Place& place = block.front().place;
      carry_until(place.ordinal);
      if (!std::exchange(started_, true)) start(&block.front());
      return writer_.write_tap(block, origin({line_of(place), place.ordinal}));
    }
    for (const ir::Motion& motion : block) take(motion);
  }

  void watch_spindle(const ir::Motion& motion) {
    if (!ir::is_move(motion.kind)) return;
    const bool cuts = motion.kind == ir::MotionKind::linear || motion.kind == ir::MotionKind::thread;
    const bool turned = cut_by_ != ir::SpindleState::stopped && motion.spindle != ir::SpindleState::stopped &&
                        motion.spindle != cut_by_;
    turns_back_ |= cuts && turned;
    turns_back_in_thread_ |= motion.kind == ir::MotionKind::thread && turned;
    cut_by_ = cuts ? motion.spindle : ir::SpindleState::stopped;
  }

  void lose(passes::Refusal word) {
    if (lost_.insert(word.what).second)
      out_.lost.push_back(cannot_write(std::move(word), span_of_line(out_.source, main_line_)));
  }

  struct Pending {
    std::uint64_t ordinal;
    std::uint32_t line;
    const CarriedBlock* carried;
  };

  // With the plane and feed of the first motion, where that is what the program begins with; otherwise with the
  // machine's.
  void start(const ir::Motion* first) {
    const bool mill = out_.control.kind == ir::MachineKind::mill;
    const bool moves = first != nullptr && ir::is_move(first->kind);
    const ir::Plane plane = moves ? first->plane : mill ? ir::Plane::xy : ir::Plane::zx;
    const ir::FeedMode feed_mode = first != nullptr ? first->feed_mode
                                   : mill           ? ir::FeedMode::per_min
                                                    : ir::FeedMode::per_rev;
    writer_.safe_start(plane, feed_mode);
  }

  // A subprogram that is run by itself: what is written of it must go back to its caller, too.
  [[nodiscard]] bool returns_at(const ir::Place& place) const {
    return place.program == 0 && std::ranges::any_of(source_.statements, [&](const ir::Statement& s) {
             return s.line == place.line && s.kind == ir::StatementKind::subprogram_return;
           });
  }

  std::uint32_t origin(BlockOrigin origin) {
    out_.origins.push_back(origin);
    return static_cast<std::uint32_t>(out_.origins.size());
  }

  // What blocks before `ordinal` carry stands alone; what that block carries goes into its first one, but what has a
  // block of its own comes after its motion.
  void carry_until(std::uint64_t ordinal) {
    for (; next_pending_ < pending_.size() && pending_[next_pending_].ordinal <= ordinal; ++next_pending_) {
      const Pending& pending = pending_[next_pending_];
      const bool own = pending.ordinal == ordinal;
      if (!std::exchange(started_, true)) start(nullptr);
      if (!std::exchange(attached_, true)) writer_.carry(pending.carried->attached);
      if (own && !pending.carried->alone.empty()) return;
      if (!own) {
        const std::uint32_t line = origin({pending.line, pending.ordinal});
        writer_.flush(line);
        if (!pending.carried->alone.empty()) writer_.write_alone(pending.carried->alone, line);
      }
      attached_ = false;
    }
  }

  // Of the main program: in a called one, the line of the call.
  [[nodiscard]] std::uint32_t line_of(const ir::Place& place) const {
    if (place.program == 0) return place.line;
    const auto after = std::ranges::upper_bound(calls_, place.ordinal, {}, &BlockOrigin::ordinal);
    return after == calls_.begin() ? 0 : std::prev(after)->line;
  }

  // Asked of the finder once.
  const ir::Program* program_of(std::uint32_t index) {
    if (index >= sources_.size()) sources_.resize(index + 1);
    if (!sources_[index]) sources_[index] = carried_.source_of(index, names_.programs);
    return *sources_[index];
  }

  const ir::Program& source_;
  ExplicitProgram& out_;
  CarriedBlocks& carried_;
  LostWrites writes_;
  std::vector<std::optional<const ir::Program*>> sources_;  // by number of the run
  const interpreter::RunNames& names_;
  BlockWriter writer_;
  bool want_changes_;
  bool is_quick_;
  bool keeps_taps_;
  PositionRuns* runs_ = nullptr;
  std::map<std::uint32_t, std::uint8_t> skips_;  // by line of the main program
  std::vector<ir::Motion> held_;                 // of the block at hand, where taps are kept
  std::set<std::string, std::less<>> lost_;
  bool started_ = false;
  bool ended_ = false;
  ir::SpindleState cut_by_ = ir::SpindleState::stopped;  // of the cut before; stopped: there is none
  bool turns_back_ = false;
  bool turns_back_in_thread_ = false;
  bool in_call_ = false;
  std::uint32_t main_line_ = 0;
  std::vector<BlockOrigin> calls_;
  std::vector<Pending> pending_;
  std::size_t next_pending_ = 0;
  bool attached_ = false;  // of pending_[next_pending_]: its words are in a block already
};

// What the moves do not show, and plain blocks have no words for: orders to spindles, and how feeds count.
bool is_order(ir::Function function) {
  return function == ir::Function::spindle_orient || function == ir::Function::other_spindle ||
         function == ir::Function::main_spindle || function == ir::Function::feed_per_min;
}

}  // namespace

std::vector<text::Diagnostic> run_faults(const ExplicitProgram& made, const RunTexts& texts) {
  const interpreter::RunResult& run = made.run;
  std::vector<text::Diagnostic> out;
  out.reserve(run.diagnostics.size());
  for (const interpreter::RunDiagnostic& fault : run.diagnostics) out.push_back(texts.placed(fault, run));
  for (const interpreter::NotInterpreted& lost : run.not_interpreted) {
    if (is_carried(lost.function)) continue;
    using text::DiagnosticId;
    const DiagnosticId id =
        lost.effects_known ? DiagnosticId::translation_macro_only : DiagnosticId::translation_not_run;
    out.push_back(cannot_write({id, lost.name}, {}));
    texts.place(out.back(), run, lost.program, lost.first_line);
    if (lost.effects_known && !is_order(lost.function)) out.back().severity = text::Severity::warning;
    if (lost.is_model)
      out.back().notes = {{.span = out.back().span, .text = "its moves are written, in an order of dripfeed's own"}};
    // Its chords are written; whether the control bends as we do is for a person to look at.
    if (lost.function == ir::Function::spline) out.back().severity = text::Severity::warning;
  }
  // What is carried is taken from the text, where the number of such a code does not stand.
  for (const interpreter::ComputedCodeUse& code : run.computed_codes) {
    if (!is_carried(code.function)) continue;
    out.push_back(cannot_write(passes::computed("a calculated code, here " + code.name), {}));
    texts.place(out.back(), run, code.program, code.first_line);
  }
  for (const text::Diagnostic& lost : made.lost) {
    // What is not interpreted is reported already.
    const auto same = [&](const text::Diagnostic& d) {
      return d.id == lost.id && d.severity == lost.severity && d.span.begin == lost.span.begin;
    };
    if (lost.span.empty() || std::ranges::none_of(out, same)) out.push_back(lost);
  }
  const bool broke_off = run.ended == interpreter::Ended::alarm || run.ended == interpreter::Ended::limit;
  if (broke_off && !run.diagnostics.empty()) out[run.diagnostics.size() - 1].severity = text::Severity::error;
  return out;
}

namespace {

// What taps in a program's own words: with the spindle turned by its position, or in a compensating chuck.
struct Taps {
  bool cycles = false;
  bool rigid = false;
  bool floating = false;
  text::Span first;  // of them, in the main program
};

// G331 and G332 turn the spindle with the axis, one direction in and the other out, and so does G84 after M29, as G84.2
// or with ,R1. A thread of plain blocks follows a spindle that goes on turning: the tap would be torn out.
Taps taps_of(const ir::Program& program, const ir::Control& control) {
  Taps out;
  const auto any = [&](const auto& test) { return std::ranges::any_of(program.codes, test); };
  out.cycles = any(passes::is_tap);
  const bool announced = any([&](const ir::Code& c) { return passes::announces_rigid_tap(c, control); });
  const bool written = any([&](const ir::Code& c) {
    return passes::is_tap(c) && passes::is_written_rigid(c.span.in(program.source.text()));
  });
  out.rigid = (out.cycles && announced) || written || any([](const ir::Code& c) {
                return c.function == ir::Function::tap || c.function == ir::Function::tap_retract;
              });
  out.floating = out.cycles || any(passes::is_floating_tap);
  const auto taps = [](const ir::Code& c) {
    return passes::is_tap(c) || passes::is_floating_tap(c) || c.function == ir::Function::tap ||
           c.function == ir::Function::tap_retract;
  };
  if (const auto first = std::ranges::find_if(program.codes, taps); first != program.codes.end())
    out.first = first->span;
  return out;
}

// Where the main program calls it; empty where another one does.
text::Span call_of(const ir::Program& main, std::string_view name) {
  const auto calls = [&](const ir::Statement& s) {
    return (s.kind == ir::StatementKind::call || s.kind == ir::StatementKind::modal_call) &&
           main.strings.at(main.calls[s.payload].name) == name;
  };
  const auto call = std::ranges::find_if(main.statements, calls);
  return call == main.statements.end() ? text::Span{} : call->span;
}

// By a cycle of the control that the run came to.
bool calls_tap(const ir::Program& program, const std::vector<std::string>& called) {
  return std::ranges::any_of(program.calls, [&](const ir::Call& call) {
    return ir::is_called(call, ir::CalledSort::hole) && call.cycle->hole == ir::DrillCycle::tap_right &&
           std::ranges::find(called, program.strings.at(call.name)) != called.end();
  });
}

Taps taps_of_all(const ir::Program& main, const ir::Control& control, const std::vector<std::string>& called,
                 interpreter::ProgramFinder& finder) {
  Taps out = taps_of(main, control);
  out.cycles |= calls_tap(main, called);
  for (std::size_t i = 1; i < called.size(); ++i) {
    const ir::Program* program = finder.find(called[i]);
    if (program == nullptr) continue;
    const Taps more = taps_of(*program, control);
    out.cycles |= more.cycles || calls_tap(*program, called);
    out.rigid |= more.rigid;
    out.floating |= more.floating;
    if (out.first.empty() && (more.cycles || more.rigid || more.floating)) out.first = call_of(main, called[i]);
  }
  return out;
}

}  // namespace

ExplicitProgram explicit_program(const ir::Program& program, const ir::Control& control,
                                 interpreter::ProgramFinder& finder, const ExplicitOptions& options) {
  ExplicitProgram out;
  out.program.name = program.name;
  out.control = explicit_control(control);
  out.source = program.source;
  CarriedBlocks carried(program, control, finder);
  interpreter::RunNames names;
  Recorder recorder(program, out, carried, names, options, control);
  interpreter::RunOptions run;
  run.limits = options.limits;
  run.changes = options.want_changes ? interpreter::Changes::scalars : interpreter::Changes::none;
  run.initial_values = options.initial_values;
  run.observer = &recorder;
  run.names = &names;
  run.every_order = true;
  out.run = interpreter::run(program, control, finder, recorder, run);
  recorder.finish(out.run);
  const Taps taps = taps_of_all(program, control, out.run.programs, finder);
  if (taps.rigid || (taps.cycles && recorder.turns_back_in_thread())) {
    out.lost.push_back(cannot_write("a tap that the axis turns the spindle for (G331, G332, M29)", taps.first));
  } else if (taps.floating && recorder.turns_back()) {
    out.lost.push_back(cannot_write("a tap, on whose moves feed override and feed hold then act,", taps.first));
    out.lost.back().severity = text::Severity::warning;
  }
  out.variable_names = std::move(names.variables);
  return out;
}

}  // namespace dripfeed::compile

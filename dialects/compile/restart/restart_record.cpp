// Blocks are observed one by one and motions come in batches; both carry the ordinal of their block.
#include "dialects/compile/restart/restart_record.h"

#include <algorithm>
#include <array>
#include <utility>

#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/compile/translate/recorded_run.h"
#include "dialects/interpreter/arithmetic/arithmetic.h"

namespace dripfeed::compile {

namespace {

using interpreter::ModalState;
using Obstacle = RestartObstacle;

bool is_zero(const interpreter::AxisValues& values) {
  return std::ranges::all_of(values, [](double value) { return value == 0.0; });
}

struct ObstacleRow {
  Obstacle obstacle;
  std::string_view words;
  bool (*holds)(const ModalState&);  // nullptr: the state alone does not say so
};

constexpr auto kObstacles = std::to_array<ObstacleRow>({
    {Obstacle::none, "", nullptr},
    {Obstacle::not_modelled, "a cycle or curve that is not interpreted is",
     [](const ModalState& s) { return !s.modes.motion_modelled; }},
    {Obstacle::modal_call, "a modal call is", nullptr},
    {Obstacle::compensation, "cutter compensation is",
     [](const ModalState& s) { return s.modes.comp != ir::CompSide::off; }},
    {Obstacle::drilling, "a drilling cycle is", [](const ModalState& s) { return s.drilling.active; }},
    {Obstacle::turning, "a turning cycle is", [](const ModalState& s) { return s.turning.active; }},
    {Obstacle::transformation, "polar or cylindrical interpolation is",
     [](const ModalState& s) { return s.transformation.shape != interpreter::Transformation::Shape::none; }},
    {Obstacle::turned_frame, "a rotation, scale or mirror is",
     [](const ModalState& s) {
       return s.modes.has_matrix || std::ranges::any_of(s.modes.point_frames, &interpreter::PointFrame::active);
     }},
    {Obstacle::shift, "a shift of the coordinates is",
     [](const ModalState& s) {
       return !is_zero(s.modes.shift) || !is_zero(s.modes.fine_shift) || !is_zero(s.coordinate_shift);
     }},
    {Obstacle::polar_words, "programming in polar coordinates is",
     [](const ModalState& s) { return s.modes.polar_words; }},
    {Obstacle::curve, "a curve is", [](const ModalState& s) { return s.curve.open || s.spline.active; }},
    {Obstacle::corner, "a corner that waits for the next move is",
     [](const ModalState& s) {
       return s.corner.kind != 0 || s.plane_corner.kind != 0 || s.line.active || s.modal_rounding_mm != 0.0;
     }},
    {Obstacle::inverse_time, "inverse-time feed is",
     [](const ModalState& s) { return s.modes.feed_mode == ir::FeedMode::inverse_time; }},
    {Obstacle::contour_offset, "an offset of the contour is", [](const ModalState& s) { return s.offsets_contour; }},
    {Obstacle::written_offsets, "an offset that the program has written is",
     [](const ModalState& s) { return s.gaps != 0; }},
    {Obstacle::arc, "an arc is", nullptr},
    {Obstacle::thread, "a thread is", nullptr},
    {Obstacle::in_shape, "the shape of a cycle is", nullptr},
});
constexpr bool in_order() {
  for (std::size_t i = 0; i < kObstacles.size(); ++i)
    if (kObstacles[i].obstacle != static_cast<Obstacle>(i)) return false;
  return true;
}
static_assert(in_order());

Obstacle obstacle_of(ir::MotionKind kind) {
  if (is_arc(kind)) return Obstacle::arc;
  if (kind == ir::MotionKind::thread) return Obstacle::thread;
  return kind == ir::MotionKind::spline ? Obstacle::curve : Obstacle::none;
}

class Recorder final : public ir::MotionSink, public interpreter::BlockObserver, public interpreter::StateObserver {
 public:
  Recorder(RestartRun& run, const ir::Semantics& semantics, std::uint32_t line)
      : run_(run), semantics_(semantics), line_(line) {}

  bool begin(const interpreter::BlockBegin& block) override {
    in_main_ = block.in_main;
    if (block.place.program != 0) return false;
    // A cycle that is a program of the control's own has the place of its call; the blocks of a shape have their own.
    if (block.in_main) last_line_ = block.place.line;
    if (!block.in_main && block.place.line == last_line_) return false;
    LineSeen& seen = at(block.place.line);
    ++seen.visits;
    seen.guessed |= block.guessed;
    const Obstacle found = !block.in_main     ? Obstacle::in_shape
                           : block.modal_call ? Obstacle::modal_call
                                              : compile::obstacle_of(block.state);
    if (seen.obstacle == Obstacle::none) seen.obstacle = found;
    if (block.place.line != line_ || run_.point) return false;
    run_.point.emplace();
    run_.point->state = block.state;
    run_.point->ordinal = block.place.ordinal;
    return block.in_main;
  }
  void variables(std::vector<interpreter::VariableValue> values) override { run_.point->variables = std::move(values); }

  // Called for a block when the next one has begun.
  void block(const ir::Place& place, std::span<const interpreter::VariableChange> changes) override {
    if (run_.point && place.ordinal >= run_.point->ordinal) return;
    for (const interpreter::VariableChange& change : changes) {
      const std::string& name = run_.names.variables[change.variable];
      // Names of a called program are its own and gone with it.
      if ((place.program != 0 || !in_main_) && std::string_view("#R$").find(name.front()) == std::string_view::npos)
        continue;
      changed_.insert(name);
      if (interpreter::is_unknown(change.value, semantics_))
        unknown_.insert(name);
      else
        unknown_.erase(name);
    }
  }

  void consume(std::span<const ir::Motion> motions) override {
    for (const ir::Motion& motion : motions) {
      if (motion.place.program == 0) {
        LineSeen& seen = at(motion.place.line);
        if (seen.obstacle == Obstacle::none) seen.obstacle = obstacle_of(motion.kind);
      }
      if (motion.kind == ir::MotionKind::spindle || motion.kind == ir::MotionKind::coolant) continue;
      run_.is_whole = run_.motions.size() < kKeptMotions;
      if (!run_.is_whole) return;
      run_.motions.push_back(motion);
    }
  }

  void finish() {
    if (!run_.point) return;
    run_.point->changed = std::move(changed_);
    run_.point->unknown = std::move(unknown_);
  }

 private:
  LineSeen& at(std::uint32_t line) {
    if (line > run_.lines.size()) run_.lines.resize(line);
    return run_.lines[std::max(line, 1U) - 1];
  }

  RestartRun& run_;
  const ir::Semantics& semantics_;
  std::uint32_t line_;
  std::uint32_t last_line_ = 0;  // of the main program
  bool in_main_ = true;          // the block that began last
  std::set<std::string> changed_;
  std::set<std::string> unknown_;
};

}  // namespace

std::string_view words_of(RestartObstacle obstacle) { return kObstacles[static_cast<std::size_t>(obstacle)].words; }

RestartObstacle obstacle_of(const ModalState& state) {
  const auto row = std::ranges::find_if(
      kObstacles, [&](const ObstacleRow& one) { return one.holds != nullptr && one.holds(state); });
  return row == kObstacles.end() ? Obstacle::none : row->obstacle;
}

std::size_t RestartRun::first_motion(std::uint64_t ordinal) const {
  const auto first =
      std::ranges::lower_bound(motions, ordinal, {}, [](const ir::Motion& m) { return m.place.ordinal; });
  return static_cast<std::size_t>(first - motions.begin());
}

std::size_t RestartRun::moves_before(std::uint64_t ordinal) const {
  return static_cast<std::size_t>(std::count_if(motions.begin(),
                                                motions.begin() + static_cast<std::ptrdiff_t>(first_motion(ordinal)),
                                                [](const ir::Motion& m) { return ir::is_move(m.kind); }));
}

RestartRun run_for_restart(const ir::Program& program, const ir::Control& control, interpreter::ProgramFinder& finder,
                           const interpreter::RunOptions& options, std::uint32_t line) {
  RestartRun run;
  ir::Control asked = control;
  asked.semantics.unset_is_unknown = true;
  Recorder recorder(run, asked.semantics, line);
  interpreter::RunOptions own = options;
  own.observer = &recorder;
  own.states = &recorder;
  own.names = &run.names;
  run.result = interpreter::run(program, asked, finder, recorder, own);
  recorder.finish();
  return run;
}

}  // namespace dripfeed::compile

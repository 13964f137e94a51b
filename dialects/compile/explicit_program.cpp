// Motions come in batches and executed blocks one by one, so both are kept with their ordinals and joined at the end of
// each batch: a motion belongs to the last block with its ordinal.
#include "dialects/compile/explicit_program.h"

#include <algorithm>
#include <map>
#include <utility>

#include "dialects/compile/block_writer.h"
#include "dialects/compile/dialect.h"

namespace dripfeed::compile {

namespace {

// Functions that motions say nothing of, and the address that goes with each.
struct CarriedRow {
  ir::Function function;
  ir::Address address;
};
constexpr auto kCarried = std::to_array<CarriedRow>({
    {ir::Function::length_offset_plus, ir::Address::h},
    {ir::Function::length_offset_minus, ir::Address::h},
    {ir::Function::length_offset_off, ir::Address::h},
    {ir::Function::comp_left, ir::Address::d},
    {ir::Function::comp_right, ir::Address::d},
});
bool is_length_offset(ir::Function function) {
  return function >= ir::Function::length_offset_plus && function <= ir::Function::length_offset_off;
}

// The blocks of the main program that have something to carry, by line.
class CarriedBlocks {
 public:
  CarriedBlocks(const ir::Program& program, bool d_selects_edge) {
    for (const ir::Statement& statement : program.statements) {
      if (statement.kind == ir::StatementKind::block) {
        collect(program, program.blocks[statement.payload], d_selects_edge, by_line_[statement.line]);
      }
    }
    std::erase_if(by_line_, [](const auto& entry) { return entry.second.codes.empty() && entry.second.words.empty(); });
  }

  [[nodiscard]] const CarriedWords* at(std::uint32_t line) const {
    const auto found = by_line_.find(line);
    return found == by_line_.end() ? nullptr : &found->second;
  }

 private:
  static void collect(const ir::Program& program, const ir::Block& block, bool d_selects_edge, CarriedWords& out) {
    for (const ir::Code& code : program.codes_of(block)) {
      const auto row = std::ranges::find(kCarried, code.function, &CarriedRow::function);
      if (row == kCarried.end() || (row->address == ir::Address::d && d_selects_edge)) continue;
      if (is_length_offset(code.function)) out.codes.push_back({code.function, code.argument});
      for (const ir::Word& word : program.words_of(block)) {
        if (word.address != row->address || word.value == ir::ExpressionId::none) continue;
        const ir::Expression& value = program.at(word.value);
        if (value.op == ir::Operator::constant) out.words.emplace_back(word.address, value.value);
      }
    }
  }

  std::map<std::uint32_t, CarriedWords> by_line_;
};

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

class Recorder final : public ir::MotionSink, public interpreter::BlockObserver {
 public:
  Recorder(ExplicitProgram& out, const CarriedBlocks& carried, const interpreter::RunNames& names, bool want_changes)
      : out_(out), carried_(carried), writer_(out.program, out.control, names), want_changes_(want_changes) {}

  void block(const ir::Place& place, std::span<const interpreter::VariableChange> changes) override {
    if (place.program == 0) {
      main_line_ = place.line;
      if (const CarriedWords* words = carried_.at(place.line)) pending_.push_back({place.ordinal, place.line, words});
      in_call_ = false;
    } else if (!std::exchange(in_call_, true)) {
      calls_.push_back({main_line_, place.ordinal});
    }
    if (!want_changes_) return;
    for (const interpreter::VariableChange& change : changes) out_.changes.push_back({place.ordinal, change});
  }

  void consume(std::span<const ir::Motion> motions) override {
    for (const ir::Motion& motion : motions) {
      carry_until(motion.place.ordinal);
      if (!std::exchange(started_, true)) start(motion);
      writer_.write(motion, origin({line_of(motion.place), motion.place.ordinal}));
    }
  }

  void finish() {
    if (!started_) start({});
    carry_until(~std::uint64_t{0});
    writer_.flush(out_.origins.empty() ? 0 : static_cast<std::uint32_t>(out_.origins.size()));
  }

 private:
  struct Pending {
    std::uint64_t ordinal;
    std::uint32_t line;
    const CarriedWords* words;
  };

  void start(const ir::Motion& first) {
    const bool mill = out_.control.kind == ir::MachineKind::mill;
    writer_.safe_start(ir::is_move(first.kind) ? first.plane : mill ? ir::Plane::xy : ir::Plane::zx, first.feed_mode);
  }

  std::uint32_t origin(BlockOrigin origin) {
    out_.origins.push_back(origin);
    return static_cast<std::uint32_t>(out_.origins.size());
  }

  // Words of all blocks up to the motion's own. Those of an earlier block than that stand alone.
  void carry_until(std::uint64_t ordinal) {
    for (; next_pending_ < pending_.size() && pending_[next_pending_].ordinal <= ordinal; ++next_pending_) {
      const Pending& pending = pending_[next_pending_];
      if (!started_) {
        started_ = true;
        start({});
      }
      writer_.carry(*pending.words);
      if (pending.ordinal < ordinal) writer_.flush(origin({pending.line, pending.ordinal}));
    }
  }

  // Of the main program: in a called one, the line of the call.
  [[nodiscard]] std::uint32_t line_of(const ir::Place& place) const {
    if (place.program == 0) return place.line;
    const auto after = std::ranges::upper_bound(calls_, place.ordinal, {}, &BlockOrigin::ordinal);
    return after == calls_.begin() ? 0 : std::prev(after)->line;
  }

  ExplicitProgram& out_;
  const CarriedBlocks& carried_;
  BlockWriter writer_;
  bool want_changes_;
  bool started_ = false;
  bool in_call_ = false;
  std::uint32_t main_line_ = 0;
  std::vector<BlockOrigin> calls_;
  std::vector<Pending> pending_;
  std::size_t next_pending_ = 0;
};

}  // namespace

std::vector<text::Diagnostic> run_faults(const interpreter::RunResult& run) {
  std::vector<text::Diagnostic> out;
  out.reserve(run.diagnostics.size());
  for (const interpreter::RunDiagnostic& fault : run.diagnostics) out.push_back(fault.diagnostic);
  const bool broke_off = run.ended == interpreter::Ended::alarm || run.ended == interpreter::Ended::limit;
  if (broke_off && !out.empty()) out.back().severity = text::Severity::error;
  return out;
}

ExplicitProgram explicit_program(const ir::Program& program, const ir::Control& control,
                                 interpreter::ProgramFinder& finder, const ExplicitOptions& options) {
  ExplicitProgram out;
  out.program.name = program.name;
  out.control = explicit_control(control);
  const CarriedBlocks carried(program, control.semantics.d_selects_edge);
  interpreter::RunNames names;
  Recorder recorder(out, carried, names, options.want_changes);
  interpreter::RunOptions run;
  run.limits = options.limits;
  run.initial_values = options.initial_values;
  run.observer = &recorder;
  run.names = &names;
  out.run = interpreter::run(program, control, finder, recorder, run);
  recorder.finish();
  out.variable_names = std::move(names.variables);
  return out;
}

}  // namespace dripfeed::compile

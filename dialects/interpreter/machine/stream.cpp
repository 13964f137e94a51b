// Running what is scanned. The machine's state is the same wherever a block comes from, so a run that began on a stream
// goes on in the whole program from any block. Only what the whole program would have had by then must not be missing:
// plain blocks compute nothing and call nothing, so that is the modal state and the counts.
#include <algorithm>
#include <stdexcept>

#include "dialects/interpreter/machine/machine.h"
#include "dialects/interpreter/motion/events.h"

namespace dripfeed::interpreter {

namespace {

// The instruction that begins the block at `offset` of the text; instructions stand in the order of the text.
std::uint32_t instruction_at(const CompiledProgram& program, std::uint32_t offset) {
  if (offset == 0) return 0;
  for (std::uint32_t i = 0; i < program.code.size(); ++i)
    if (program.code[i].op == Opcode::block && program.spans[i].begin >= offset) return i;
  return static_cast<std::uint32_t>(program.code.size() - 1);  // text_end
}

}  // namespace

RunResult Machine::run(PlainStream& stream) {
  // One instruction, from which the report takes its places.
  CompiledProgram plain;
  plain.code.emplace_back();
  plain.spans.emplace_back();
  report_.enter(plain);
  bool goes_on = false;
  try {
    goes_on = run_plain_blocks(stream, plain.code.front(), &plain.spans.front());
  } catch (const BudgetUsedUp& used) {
    out_.let_go();
    state_.spline.active = false;
    report_.fail_limit(plain.code.front(), used.what);
  }
  const PlainStream::Rest rest = goes_on ? stream.rest() : PlainStream::Rest{};
  if (rest.program != nullptr) {
    define_shared_data();
    CompiledProgram& main = programs_.add(*rest.program, rest.program->name);
    stack_.start(main);
    if (control_.semantics.unset_is_unknown && executed_ == 0) set_inputs(main);
    set_initial_values(main);
    run_from(instruction_at(main, rest.offset));
    return finish(main);
  }
  if (rest.broken)
    report_.end(Ended::alarm);
  else if (goes_on)
    end_text(plain.code.front());
  names_.programs.emplace_back(stream.name());
  stack_.start(plain);  // its variables are listed as those of any program
  set_initial_values(plain);
  return finish(plain);
}

namespace {

Report report_of(const ir::PlainReport& report, const ir::Control& control) {
  if (report.function == ir::Function::machine_function)
    return {ir::name_of_machine_function(report.argument), report.function,
            ir::is_known_machine_function(control, report.argument)};
  return {std::string(report.name), report.function, report.function == ir::Function::no_effect};
}

// One stretch from its front.
class StretchStream final : public PlainStream {
 public:
  StretchStream(const ir::PlainStretches& stretches, std::uint32_t number)
      : scanner_(stretches.make_scanner()),
        stretch_(stretches.all[number]),
        text_(stretches.text),
        at_(stretch_.begin) {}
  const ir::PlainBatch* next() override {
    batch_.clear();
    if (at_ >= stretch_.end) return nullptr;
    const std::size_t taken = scanner_->scan(text_.substr(at_, stretch_.end - at_), batch_).taken;
    if (taken == 0) throw std::logic_error("a stretch that was plain when it was read is not");
    at_ += taken;
    for (ir::PlainBlockRow& row : batch_.blocks) row.line += stretch_.line - 1;
    return batch_.blocks.empty() ? nullptr : &batch_;
  }
  Rest rest() override { return {}; }
  [[nodiscard]] std::string_view name() const override { return {}; }

 private:
  std::unique_ptr<ir::PlainScanner> scanner_;
  const ir::PlainStretch& stretch_;
  std::string_view text_;
  std::uint64_t at_;
  ir::PlainBatch batch_;
};

}  // namespace

bool Machine::run_stretch(const Instruction& i) {
  StretchStream stream(*options_.stretches, i.a);
  return run_plain_blocks(stream, i, nullptr);
}

bool Machine::run_plain_blocks(PlainStream& stream, const Instruction& here, text::Span* place) {
  while (const ir::PlainBatch* batch = stream.next()) {
    auto report = batch->reports.begin();
    for (std::uint32_t n = 0; n < batch->blocks.size(); ++n) {
      const ir::PlainBlockRow& row = batch->blocks[n];
      const auto offset = static_cast<std::uint32_t>(row.offset);
      if (place != nullptr) *place = {offset, offset + row.length};
      if (executed_ == options_.limits.blocks) return report_.fail_limit(here, "blocks");
      if (options_.observer != nullptr && executed_ > 0) [[unlikely]]
        report_block();
      budget_.take_step();
      begin_place(row.line);
      ++out_.work.blocks;
      state_.clock_ms += control_.cost.block_ms;
      for (; report != batch->reports.end() && report->block == n; ++report)
        report_.count(report_of(*report, control_));
      if (row.word_count + row.code_count > 0 && !blocks_.run_plain(here, *batch, row).has_value()) return false;
      if (!row.ends_program) continue;
      emit_event(ir::MotionKind::end, state_, out_);
      return report_.end(Ended::end);
    }
  }
  return true;
}

}  // namespace dripfeed::interpreter

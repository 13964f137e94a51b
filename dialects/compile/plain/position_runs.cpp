// The kind of a block is which axes it names: all else of it is the same along the run.
#include "dialects/compile/plain/position_runs.h"

#include <bit>
#include <utility>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/compile/dialect/printed_lines.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/passes/round_positions.h"

namespace dripfeed::compile {

namespace {

constexpr std::uint32_t kSampleEvery = 16384;          // blocks
constexpr std::size_t kChunk = std::size_t{1} << 16U;  // bytes
constexpr std::uint16_t kNotTaken = 0b111000000;       // U V W: on some controls increments

}  // namespace

bool PositionRuns::serves(const ir::Control& written_for) const {
  return dialect_.append_position != nullptr && (written_for.kind == ir::MachineKind::mill ||
                                                 written_for.semantics.power_on_diameter == ir::DiameterMode::diameter);
}

bool PositionRuns::add(const ir::Motion& move) {
  const std::uint16_t axes = axes_to_name(move);
  if (!known_.test(axes) || ++since_sample_ >= kSampleEvery) return false;
  append(move, axes);
  ++blocks_;
  if (text_.size() < kChunk) return true;
  sink_.write(text_);
  written_ += text_.size();
  text_.clear();
  return true;
}

void PositionRuns::sample(const ir::Motion& move, std::uint32_t block) {
  drop_empty();
  const std::uint16_t axes = axes_to_name(move);
  if (axes == 0 || (axes & kNotTaken) != 0) return end();
  known_.set(axes);
  since_sample_ = 0;
  const std::string before = std::exchange(text_, {});
  append(move, axes);
  text_.pop_back();
  runs_.push_back({.block = block, .line = std::exchange(text_, before), .begin = bytes(), .end = bytes()});
}

void PositionRuns::append(const ir::Motion& move, std::uint16_t axes) {
  for (std::uint16_t left = axes; left != 0; left &= static_cast<std::uint16_t>(left - 1U)) {
    const auto axis = static_cast<std::size_t>(std::countr_zero(left));
    const ir::Address address = kAxisAddresses[axis];
    const bool rounds = target_.from_profile && target_.axes.contains(ir::letter_of(address));
    const double end = move.end[axis];
    dialect_.append_position(text_, address,
                             rounds ? passes::nearest_position(end, ir::is_rotary_axis(address), false, target_) : end,
                             target_);
    text_ += ' ';
  }
  text_.back() = '\n';
}

void PositionRuns::drop_empty() {
  if (runs_.empty()) return;
  Run& last = runs_.back();
  if (known_.any()) last.end = bytes();
  if (last.begin == last.end) runs_.pop_back();
}

void PositionRuns::end() {
  drop_empty();
  known_.reset();
}

void PositionRuns::finish() {
  end();
  sink_.write(text_);
  written_ += text_.size();
  text_.clear();
}

std::optional<std::vector<Splice>> PositionRuns::splices(const ir::PrintResult& printed) const {
  std::vector<Splice> out;
  out.reserve(runs_.size());
  std::size_t next = 0;
  bool are_alike = true;
  for_each_line(printed.text, [&](const PrintedLine& line) {
    const bool comes = next < runs_.size() && line.number <= printed.origin_lines.size() &&
                       printed.origin_lines[line.number - 1] == runs_[next].block;
    if (!comes) return;
    const Run& run = runs_[next++];
    are_alike = are_alike && line.text == run.line;
    out.push_back({.at = line.offset + line.text.size() + 1, .begin = run.begin, .end = run.end});
  });
  return are_alike && next == runs_.size() ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace dripfeed::compile

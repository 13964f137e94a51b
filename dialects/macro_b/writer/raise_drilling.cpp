// A modal call is in effect from its block to the next MCALL of the text:
//
//   MCALL CYCLE81(10,2,1,-8)     G98 G81 Z-8. R3. K0       where all numbers are known and the tool stands at RTP,
//   X10 Y10                      X10. Y10.                 or RTP is the level RFP+SDIS itself (G99)
//   MCALL                        G80
//
// Otherwise each position is followed by its moves: rapid to RFP+SDIS, feed to DP, dwell, back. Pecks are left to G83
// and G73, after a rapid to RTP, which is then their initial level: from above it lies on the path, and from below the
// tool leaves the hole to there anyway. Boring that only a modal cycle has, and levels whose side is not known, are
// reported as errors.
#include "dialects/macro_b/writer/raise_drilling.h"

#include <algorithm>
#include <expected>
#include <optional>
#include <string>
#include <utility>

#include "dialects/facts/axis_words.h"
#include "dialects/ir/called_cycle.h"
#include "dialects/ir/called_pattern.h"
#include "dialects/macro_b/writer/called_hole.h"
#include "dialects/macro_b/writer/drill_place.h"
#include "dialects/macro_b/writer/drill_region.h"
#include "dialects/macro_b/writer/hole_writer.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::CalledSort;
using ir::Function;
using ir::StatementKind;

constexpr double kMostHoles = 200.0;

class Drilling {
 public:
  Drilling(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program), out_(program), place_(program, from, to), holes_(program, to, place_, out_) {
    for (std::uint32_t i = 0; i < program.statements.size(); ++i)
      if (program.statements[i].kind == StatementKind::go_to) jumps_.push_back(i);
  }

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      place_.move_to(i);
      statement();
    }
    out_.finish();
    return place_.take_diagnostics();
  }

 private:
  void statement() {
    switch (place_.statement().kind) {
      case StatementKind::modal_call: return begin();
      case StatementKind::modal_call_end: return end();
      case StatementKind::call: return call();
      case StatementKind::block: return block();
      default: return out_.keep();
    }
  }
  // --- calls

  void begin() {
    close();
    const ir::Call& call = program_.calls[place_.statement().payload];
    if (!is_drilling_cycle(call)) return out_.keep();
    const std::optional<Hole> hole = hole_of(call);
    if (!hole) return;  // reported
    if (calls_in_region(program_, place_.index()))
      return place_.cannot(passes::of_call("a call of another program after MCALL"));
    if (jumps_across_region(program_, place_.index(), jumps_))
      return place_.cannot(passes::not_known("a modal call that jumps lead into or out of"));
    const bool taps = hole->lead != 0.0 || hole->floats;
    is_cycle_ = holes_.fits_modal_cycle(*hole) && place_.motion() == Function::rapid &&
                region_positions(program_, place_.index(), taps);
    if (is_cycle_) holes_.begin_modal(*hole);
    if (is_cycle_ || holes_.has_moves(*hole)) modal_ = hole;
  }

  // A call of a program of the user's own is another matter.
  void end() { modal_ ? close() : out_.keep(); }

  void close() {
    if (is_cycle_) holes_.end_modal(*modal_);
    modal_.reset();
    is_cycle_ = false;
  }

  void call() {
    const ir::Call& call = program_.calls[place_.statement().payload];
    if (ir::is_called(call, CalledSort::holes_in_row) || ir::is_called(call, CalledSort::holes_on_circle))
      return pattern(call);
    if (!is_drilling_cycle(call)) return out_.keep();
    const std::optional<Hole> hole = hole_of(call);
    if (!hole) return;  // reported
    if (holes_.fits_modal_cycle(*hole)) return holes_.write_hole(*hole);
    if (holes_.has_moves(*hole)) holes_.write_moves(*hole);
  }

  // Nothing when it cannot be stated here, which is reported.
  std::optional<Hole> hole_of(const ir::Call& call) {
    place_.state_plane();
    std::expected<Hole, std::string> hole = called_hole(program_, call);
    if (hole) return *hole;
    place_.cannot(std::move(hole.error()));
    return std::nullopt;
  }

  // --- positions

  void block() {
    place_.take_block();
    const ir::Block& block = program_.blocks[place_.statement().payload];
    const auto codes = program_.codes_of(block);
    const auto words = program_.words_of(block);
    if (is_cycle_) {  // G0 would end it
      std::vector<ir::Code> others;
      std::ranges::remove_copy(codes, std::back_inserter(others), Function::rapid, &ir::Code::function);
      return out_.emit_block(others, {words.begin(), words.end()});
    }
    const bool positions =
        !facts::has_own_words(program_, block) && std::ranges::any_of(words, ir::is_axis, &ir::Word::address);
    out_.keep();
    if (modal_ && positions) holes_.write_moves(*modal_);
  }

  // A row or a circle of holes: positions in rapid.
  void pattern(const ir::Call& call) {
    const std::string name(program_.strings.at(call.name));
    place_.state_plane();
    if (place_.plane() != Function::plane_xy) return place_.cannot(name + " in another plane than G17");
    holes_.state_distance();
    const std::optional<ir::CalledPattern> pattern = ir::called_pattern(program_, call);
    if (!pattern) return place_.cannot(passes::computed(name + " with computed arguments"));
    if (pattern->count < 1.0 || pattern->count > kMostHoles) return place_.cannot(name + " with that number of holes");
    const auto points = ir::holes_of(*pattern, place_.in_plane());
    if (!points) return place_.cannot(passes::not_known(name + " from a position that is not known here"));
    for (const ir::PlanePoint& point : *points) position(point);
    if (!is_cycle_) holes_.motion_again(false);
  }

  void position(const ir::PlanePoint& point) {
    const std::vector<ir::Word> words = {holes_.absolute(Address::x, point.first),
                                         holes_.absolute(Address::y, point.second)};
    if (is_cycle_) return out_.emit_block({}, words);
    ir::Code rapid;
    rapid.function = Function::rapid;
    out_.emit_block({rapid}, words);
    if (modal_) holes_.write_moves(*modal_);
  }

  ir::Program& program_;
  passes::Rewrite out_;
  DrillPlace place_;
  HoleWriter holes_;
  std::vector<std::uint32_t> jumps_;
  std::optional<Hole> modal_;  // in effect …
  bool is_cycle_ = false;      // … and said by a modal cycle of these controls
};

}  // namespace

std::vector<text::Diagnostic> raise_drilling(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  const bool any = std::ranges::any_of(program.calls, [](const ir::Call& call) { return call.cycle != nullptr; });
  return any ? Drilling(program, from, to).run() : std::vector<text::Diagnostic>();
}

}  // namespace dripfeed::macro_b

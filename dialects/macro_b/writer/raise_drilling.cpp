// A modal call is in effect from its block to the next MCALL of the text:
//
//   MCALL CYCLE81(10,2,1,-8)     G98 G81 Z-8. R3. K0       where all numbers are known and the tool stands at RTP,
//   X10 Y10                      X10. Y10.                 or RTP is the level RFP+SDIS itself (G99)
//   MCALL                        G80
//
// Otherwise each position is followed by its moves: rapid to RFP+SDIS, feed to DP, dwell, back. Pecks are left to G83
// and G73, behind a rapid to RTP, which is then their initial level: from above it lies on the way, and from below the
// tool leaves the hole to there anyway. Boring that only a modal cycle has, and levels whose side is not known, are
// told as errors.
#include "dialects/macro_b/writer/raise_drilling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <expected>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "dialects/facts/axis_words.h"
#include "dialects/macro_b/writer/called_hole.h"
#include "dialects/macro_b/writer/drill_place.h"
#include "dialects/macro_b/writer/drill_region.h"
#include "dialects/macro_b/writer/hole_writer.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;

constexpr double kMostHoles = 200.0;
constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

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
      case StatementKind::native: return keep_unknown();
      default: return out_.keep();
    }
  }
  void keep_unknown() {
    place_.forget();
    out_.keep();
  }

  // --- calls

  void begin() {
    close();
    const ir::Call& call = program_.calls[place_.statement().payload];
    if (!is_drilling_cycle(program_.strings.at(call.name))) return keep_unknown();
    const std::optional<Hole> hole = hole_of(call);
    if (!hole) return;  // told
    if (calls_in_region(program_, place_.index())) return place_.cannot("a call of another program after MCALL");
    if (jumps_across_region(program_, place_.index(), jumps_))
      return place_.cannot("a modal call that jumps lead into or out of");
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
    const std::string_view name = program_.strings.at(call.name);
    if (name == "HOLES1" || name == "HOLES2") return pattern(std::string(name), call);
    if (!is_drilling_cycle(name)) return keep_unknown();
    const std::optional<Hole> hole = hole_of(call);
    if (!hole) return;  // told
    if (holes_.fits_modal_cycle(*hole)) return holes_.write_hole(*hole);
    if (holes_.has_moves(*hole)) holes_.write_moves(*hole);
  }

  // Nothing when it cannot be said here, which is told.
  std::optional<Hole> hole_of(const ir::Call& call) {
    place_.settle_plane();
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

  // HOLES1(SPCA, SPCO, STA1, FDIS, DBH, NUM), HOLES2(CPA, CPO, RAD, STA1, INDA, NUM): positions in rapid.
  void pattern(const std::string& name, const ir::Call& call) {
    place_.settle_plane();
    if (place_.plane() != Function::plane_xy) return place_.cannot(name + " in another plane than G17");
    holes_.settle_distance();
    std::array<double, 6> v{};
    const std::span<const ir::Argument> arguments = program_.arguments_of(call);
    for (std::size_t i = 0; i < std::min(v.size(), arguments.size()); ++i) {
      if (arguments[i].value == ir::ExpressionId::none) continue;  // left out: 0
      const std::optional<double> value = constant_value(program_, arguments[i].value);
      if (!value) return place_.cannot(name + " with computed arguments");
      v[i] = *value;
    }
    if (v[5] < 1.0 || v[5] > kMostHoles) return place_.cannot(name + " with that number of holes");
    const bool on_circle = name == "HOLES2";
    if (!on_circle && v[5] > 1.0 && !begin_nearer(v))
      return place_.cannot(name + " from a place that is not known here");
    const double step = v[4] == 0.0 ? 360.0 / v[5] : v[4];
    for (int n = 0; n < v[5]; ++n) {
      const double angle = (on_circle ? v[3] + n * step : v[2]) * kRadiansPerDegree;
      const double radius = on_circle ? v[2] : v[3] + n * v[4];
      position(v[0] + radius * std::cos(angle), v[1] + radius * std::sin(angle));
    }
    if (!is_cycle_) holes_.motion_again(false);
  }

  // A row begins with its last hole where that one is nearer. False where the tool stands nobody knows.
  bool begin_nearer(std::array<double, 6>& row) {
    const auto [x, y] = place_.state.in_plane;
    if (!x || !y) return false;
    const double angle = row[2] * kRadiansPerDegree;
    const double last = row[3] + (row[5] - 1.0) * row[4];
    const auto distance = [&](double along) {
      return std::hypot(*x - row[0] - along * std::cos(angle), *y - row[1] - along * std::sin(angle));
    };
    if (distance(last) >= distance(row[3])) return true;
    row[3] = last;
    row[4] = -row[4];
    return true;
  }

  void position(double x, double y) {
    place_.state.in_plane = {x, y};
    const std::vector<ir::Word> words = {holes_.absolute(Address::x, x), holes_.absolute(Address::y, y)};
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
  const bool any = std::ranges::any_of(program.calls, [&](const ir::Call& call) {
    const std::string_view name = program.strings.at(call.name);
    return name.starts_with("CYCLE8") || name.starts_with("HOLES");
  });
  return any ? Drilling(program, from, to).run() : std::vector<text::Diagnostic>();
}

}  // namespace dripfeed::macro_b

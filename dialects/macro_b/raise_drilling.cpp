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
#include "dialects/macro_b/raise_drilling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <expected>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/ir/cycle.h"
#include "dialects/macro_b/called_hole.h"
#include "dialects/passes/flow_graph.h"
#include "dialects/passes/mode_flow.h"
#include "dialects/passes/motion_flow.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/rigid_taps.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::DrillCycle;
using ir::ExpressionId;
using ir::Function;
using ir::StatementKind;

constexpr double kMostHoles = 200.0;

bool is_axis(Address a) { return a <= Address::c || (a >= Address::u && a <= Address::z); }

class Drilling {
 public:
  Drilling(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program),
        to_(to),
        out_(program),
        is_target_(passes::jump_targets(program)),
        modes_(program, from),
        motions_(passes::motions_before(program)),
        plane_(from.semantics.power_on_plane) {
    incremental_ = from.semantics.power_on_distance == Function::incremental;
    for (std::uint32_t i = 0; i < program.statements.size(); ++i)
      if (program.statements[i].kind == StatementKind::go_to) jumps_.push_back(i);
    turning_.feed_mode = from.semantics.power_on_feed;
  }

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      index_ = i;
      statement_ = program_.statements[i];
      motion_ = motions_[i];
      if (is_target_[i] || (statement_.kind >= StatementKind::if_begin && statement_.kind <= StatementKind::loop_end))
        forget();
      statement();
    }
    out_.finish();
    return std::move(diagnostics_);
  }

 private:
  void statement() {
    if (statement_.kind == StatementKind::modal_call) return begin();
    if (statement_.kind == StatementKind::modal_call_end) return end();
    if (statement_.kind == StatementKind::call) return call();
    if (statement_.kind == StatementKind::block) return block();
    if (statement_.kind == StatementKind::native) forget();
    out_.keep();
  }

  // What is not known where ways meet.
  void forget() {
    height_.reset();
    turning_ = {};
  }

  // --- calls

  void begin() {
    if (modal_ || native_) close();
    const ir::Call& call = program_.calls[statement_.payload];
    if (!is_drilling_cycle(std::string(program_.strings.at(call.name)))) {
      forget();
      return out_.keep();
    }
    const std::optional<Hole> hole = hole_of(call);
    if (!hole) return;  // told
    if (calls_in_region()) return cannot("a call of another program behind MCALL");
    if (jumps_across_region()) return cannot("a modal call that jumps lead into or out of");
    modal_ = hole;
    native_ = fits_modal_cycle(*hole) && region_fits(hole->lead != 0.0 || hole->floats);
    if (native_) return define(*hole, true);
    if (!has_moves(*hole)) return modal_.reset();  // told
  }

  void end() {
    if (!modal_) {
      // A call of a program of the user's own is another matter.
      return out_.keep();
    }
    close();
  }

  void close() {
    if (native_) {
      out_.emit_block({code(Function::cycle_off)}, {});
      out_.emit_block({code(Function::rapid)}, {});
      turn_again(*modal_);
      if (height_ != number(modal_->back)) height_.reset();  // as a hole was drilled or not
    }
    modal_.reset();
    native_ = false;
  }

  void call() {
    const ir::Call& call = program_.calls[statement_.payload];
    const std::string name(program_.strings.at(call.name));
    if (name == "HOLES1" || name == "HOLES2") return holes(name, call);
    if (!is_drilling_cycle(name)) {
      forget();
      return out_.keep();
    }
    const std::optional<Hole> hole = hole_of(call);
    if (!hole) return;
    if (fits_modal_cycle(*hole)) {
      define(*hole, false);
      out_.emit_block({code(Function::cycle_off)}, {});
      turn_again(*hole);
      motion_again(true);
      height_ = number(hole->back);
    } else if (has_moves(*hole)) {
      moves(*hole);
    }
  }

  // Nothing when it cannot be said here, which is told.
  std::optional<Hole> hole_of(const ir::Call& call) {
    settle_plane();
    std::expected<Hole, std::string> hole = called_hole(program_, call);
    if (hole) return *hole;
    cannot(std::move(hole.error()));
    return std::nullopt;
  }

  // --- modal cycles

  [[nodiscard]] bool fits_modal_cycle(const Hole& hole) const {
    if (!hole.constant || to_.kind != ir::MachineKind::mill || plane_ != Function::plane_xy) return false;
    if (hole.lead != 0.0 && !turning_known()) return false;
    if (hole.floats && !cutting_way(hole)) return false;
    if (hole.feed_in != 0.0 || hole.feed_out != 0.0 || hole.spindle != 0) return false;
    const double back = *number(hole.back);
    const double level = *number(hole.level);
    if (*number(hole.depth) >= level) return false;
    return back == level || (height_ && *height_ == back);
  }

  // All blocks up to the next MCALL only position, in rapid.
  [[nodiscard]] bool region_fits(bool taps) const {
    if (motion_ != Function::rapid) return false;
    for (std::uint32_t i = index_ + 1; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind == StatementKind::modal_call || s.kind == StatementKind::modal_call_end) return true;
      if (s.kind != StatementKind::block) continue;
      const ir::Block& block = program_.blocks[s.payload];
      for (const ir::Code& c : program_.codes_of(block)) {
        if (c.group == ir::ModalGroup::motion && c.function != Function::rapid) return false;
        if (c.group == ir::ModalGroup::plane || c.group == ir::ModalGroup::frame ||
            c.group == ir::ModalGroup::work_offset || c.group == ir::ModalGroup::unit ||
            c.group == ir::ModalGroup::length_offset || c.function == Function::tool_change ||
            c.function == Function::machine_coordinates || c.function == Function::reference_return)
          return false;
        if (taps && (c.group == ir::ModalGroup::feed || c.group == ir::ModalGroup::spindle)) return false;
      }
      for (const ir::Word& w : program_.words_of(block)) {
        if (w.address == Address::z || w.address == Address::r || w.address == Address::q || w.address == Address::l ||
            w.address == Address::d || w.address == Address::t)
          return false;
        if (taps && (w.address == Address::f || w.address == Address::s)) return false;
      }
    }
    return true;
  }
  // Its moves would be followed by holes, too.
  [[nodiscard]] bool calls_in_region() const {
    for (std::uint32_t i = index_ + 1; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind == StatementKind::modal_call || s.kind == StatementKind::modal_call_end) return false;
      if (s.kind == StatementKind::call && !passes::is_standard_cycle(program_, s)) return true;
    }
    return false;
  }
  [[nodiscard]] bool jumps_across_region() const {
    std::uint32_t end = index_ + 1;
    const auto& statements = program_.statements;
    while (end < statements.size() && statements[end].kind != StatementKind::modal_call &&
           statements[end].kind != StatementKind::modal_call_end)
      ++end;
    const auto is_inside = [&](std::uint32_t i) { return i > index_ && i <= end; };
    for (const std::uint32_t i : jumps_) {
      const std::uint32_t target = passes::target_of(program_, i);
      if (target == ir::kNoIndex ? is_inside(i) : is_inside(i) != is_inside(target)) return true;
    }
    return false;
  }

  // Which axis stands on the plane.
  void settle_plane() {
    const passes::ModeFacts* facts = modes_.before(index_);
    if (facts == nullptr) return;
    const passes::ModeFact& fact = (*facts)[passes::index_of(passes::Mode::plane)];
    if (is_known("the plane", fact)) plane_ = fact.function;
  }
  // What a caller or a called program may have set is taken as it is here, and told.
  bool is_known(std::string_view what, const passes::ModeFact& fact) {
    const bool differs = fact.other != Function::none || (fact.function == Function::none && !fact.inherited);
    const bool is_certain = fact.agrees() && fact.changer == ir::kNoIndex;
    if (!is_certain && told_.insert({std::string(what), differs}).second) {
      std::string ways = fmt::format("{}", fmt::join(modes_.ways(fact), ", or "));
      if (fact.changer != ir::kNoIndex)
        ways +=
            fmt::format(", which what line {} calls or does may have changed", program_.statements[fact.changer].line);
      diagnostics_.push_back(text::make_diagnostic(text::DiagnosticId::unknown_modal_state, statement_.span,
                                                   {std::string(what), std::move(ways)}));
      if (!differs) diagnostics_.back().severity = text::Severity::warning;
    }
    return !differs && fact.function != Function::none;
  }

  // The words of a hole are absolute, and behind them is again what was: G90 or G91. Where the order of the text says
  // another than the ways here do, theirs is said; where they differ, nothing can be.
  void settle_distance() {
    const passes::ModeFacts* facts = modes_.before(index_);
    if (facts == nullptr) return;
    const passes::ModeFact& fact = (*facts)[passes::index_of(passes::Mode::distance)];
    if (statement_.kind == StatementKind::block) {
      for (const ir::Code& c : program_.codes_of(program_.blocks[statement_.payload]))
        if (passes::mode_of(c) == passes::Mode::distance) return;
    }
    if (!is_known("absolute or incremental", fact) || (fact.function == Function::incremental) == incremental_) return;
    incremental_ = !incremental_;
    out_.emit_block({code(fact.function)}, {});
  }

  // `modal`: the holes follow (K0); otherwise one is drilled here.
  void define(const Hole& hole, bool modal) {
    settle_distance();
    DrillCycle cycle = hole.cycle;
    if (hole.floats && cutting_way(hole) == Function::spindle_ccw) cycle = DrillCycle::tap_left;
    if (hole.breaks_chips) cycle = DrillCycle::chip_break;
    if (hole.breaks_chips) tell("the way back between the pecks at the feed, which G73 goes at rapid,");
    ir::Code drill = code(Function::drill);
    drill.argument = ir::drill_argument(cycle);
    const std::optional<double> back = number(hole.back);
    const bool to_level = back && back == number(hole.level);
    std::vector<ir::Word> words = {absolute(Address::z, hole.depth), absolute(Address::r, hole.level)};
    if (hole.peck > 0.0) words.push_back(word(Address::q, constant(hole.peck)));
    if (hole.dwell_s > 0.0) words.push_back(word(Address::p, program_.add_constant(hole.dwell_s * 1000.0, {}, false)));
    if (modal) words.push_back(word(Address::k, program_.add_constant(0.0, {}, false)));
    if (hole.floats && hole.lead != 0.0) words.push_back(word(Address::f, constant(hole.lead * *turning_.speed)));
    if (hole.lead != 0.0 && !hole.floats) {
      out_.emit_block({}, {word(Address::s, program_.add_constant(hole.speed, {}, false))});
      const double feed = passes::feeds_taps_by_lead(to_) ? hole.lead : hole.lead * hole.speed;
      words.push_back(word(Address::f, constant(feed)));
      passes::add_rigid(program_, to_, drill, words, out_);
    }
    out_.emit_block({code(to_level ? Function::return_to_r : Function::return_to_initial), drill}, words);
  }

  [[nodiscard]] bool turning_known() const {
    return turning_.feed_mode == Function::feed_per_min && turning_.feed && turning_.speed;
  }
  // As the number of its M function.
  static Function way_of(int number) {
    return number == 3 ? Function::spindle_cw : number == 4 ? Function::spindle_ccw : Function::spindle_stop;
  }
  // How the spindle turns on the way in: nothing where that is not known.
  [[nodiscard]] std::optional<Function> cutting_way(const Hole& hole) const {
    if (hole.reversed != 0) return hole.reversed == 4 ? Function::spindle_cw : Function::spindle_ccw;
    return turning_.spindle;
  }
  // Speed and feed were the tap's own there; they are modal here.
  void turn_again(const Hole& hole) {
    if (hole.lead != 0.0 || hole.floats) {
      turning_.spindle = way_of(hole.after);
      if (hole.after == 5) turning_.spindle.reset();
    }
    if (hole.floats && hole.lead == 0.0) {
      out_.emit_block({code(way_of(hole.after))}, {});
      return;
    }
    if (hole.lead == 0.0) return;
    out_.emit_block({code(way_of(hole.after))}, {word(Address::s, program_.add_constant(*turning_.speed, {}, false)),
                                                 word(Address::f, constant(*turning_.feed))});
  }

  // --- moves

  // Whether a hole is what these few moves make.
  bool has_moves(const Hole& hole) {
    const bool by_cycle = hole.cycle == DrillCycle::deep_hole || hole.lead != 0.0 || hole.floats;
    if (hole.floats && !cutting_way(hole)) {
      cannot(hole.name + " where it is not known how the spindle turns");
      return false;
    }
    if (hole.lead != 0.0 && !turning_known()) {
      cannot(hole.name + " behind a feed or speed that is not known");
      return false;
    }
    if (by_cycle && (to_.kind != ir::MachineKind::mill || plane_ != Function::plane_xy)) {
      cannot(hole.name + " on a lathe or in another plane than G17");
      return false;
    }
    return true;
  }

  void pecks(const Hole& hole) {
    settle_distance();
    out_.emit_block({code(Function::rapid)}, {absolute(Address::z, hole.back)});
    define(hole, false);
    out_.emit_block({code(Function::cycle_off)}, {});
    turn_again(hole);
    motion_again(true);
    height_ = number(hole.back);
  }

  void moves(const Hole& hole) {
    if (hole.cycle == DrillCycle::deep_hole || hole.lead != 0.0 || hole.floats) return pecks(hole);
    settle_distance();
    const Address axis = plane_ == Function::plane_zx   ? Address::y
                         : plane_ == Function::plane_yz ? Address::x
                                                        : Address::z;
    if (hole.spindle != 0) {
      turning_.spindle.reset();  // it ends stopped
      out_.emit_block({code(way_of(hole.spindle))}, {});
    }
    out_.emit_block({code(Function::rapid)}, {absolute(axis, hole.level)});
    std::vector<ir::Word> in = {absolute(axis, hole.depth)};
    if (hole.feed_in > 0.0) in.push_back(word(Address::f, constant(hole.feed_in)));
    out_.emit_block({code(Function::linear)}, in);
    if (hole.dwell_s > 0.0) out_.emit_block({code(Function::dwell)}, {word(Address::f, constant(hole.dwell_s))});
    if (hole.spindle != 0)
      out_.emit_block({code(hole.orients ? Function::spindle_orient : Function::spindle_stop)}, {});
    if (hole.holds) out_.emit_block({code(Function::program_stop)}, {});
    shift_aside(hole, axis);
    const bool by_feed = hole.cycle == DrillCycle::feed_out || hole.cycle == DrillCycle::feed_out_dwell;
    if (by_feed) {
      std::vector<ir::Word> out = {absolute(axis, hole.level)};
      if (hole.feed_out > 0.0) out.push_back(word(Address::f, constant(hole.feed_out)));
      out_.emit_block({code(Function::linear)}, out);
    }
    out_.emit_block({code(Function::rapid)}, {absolute(axis, hole.back)});
    shift_back(hole, axis);
    motion_again(false);
    height_ = number(hole.back);
  }

  // Away from the wall at the bottom, and over the hole again.
  void shift_aside(const Hole& hole, Address axis) {
    std::vector<ir::Word> words = aside(hole, axis, 1.0);
    if (hole.lift != 0.0) words.push_back(by(axis, hole.lift));
    if (!words.empty()) out_.emit_block({code(Function::rapid)}, words);
  }
  void shift_back(const Hole& hole, Address axis) {
    const std::vector<ir::Word> words = aside(hole, axis, -1.0);
    if (!words.empty()) out_.emit_block({code(Function::rapid)}, words);
  }
  std::vector<ir::Word> aside(const Hole& hole, Address axis, double way) {
    const Address first = axis == Address::z ? Address::x : axis == Address::y ? Address::z : Address::y;
    const Address second = axis == Address::z ? Address::y : axis == Address::y ? Address::x : Address::z;
    std::vector<ir::Word> words;
    if (hole.shift_first != 0.0) words.push_back(by(first, way * hole.shift_first));
    if (hole.shift_second != 0.0) words.push_back(by(second, way * hole.shift_second));
    return words;
  }
  ir::Word by(Address axis, double way) {
    ir::Word w = word(axis, constant(way));
    w.mode = ir::WordMode::incremental;
    return w;
  }

  // HOLES1(SPCA, SPCO, STA1, FDIS, DBH, NUM), HOLES2(CPA, CPO, RAD, STA1, INDA, NUM): positions in rapid.
  void holes(const std::string& name, const ir::Call& call) {
    settle_plane();
    if (plane_ != Function::plane_xy) return cannot(name + " in another plane than G17");
    settle_distance();
    arguments_.assign(program_.arguments_of(call).begin(), program_.arguments_of(call).end());
    std::array<double, 6> v{};
    for (std::size_t i = 0; i < v.size(); ++i) {
      const std::optional<double> value = number_at(i);
      if (!value) return cannot(name + " with computed arguments");
      v[i] = *value;
    }
    if (v[5] < 1.0 || v[5] > kMostHoles) return cannot(name + " with that number of holes");
    constexpr double kDegree = 3.14159265358979323846 / 180.0;
    for (int n = 0; n < v[5]; ++n) {
      const double step = v[4] == 0.0 && name == "HOLES2" ? 360.0 / v[5] : v[4];
      const double angle = (name == "HOLES2" ? v[3] + n * step : v[2]) * kDegree;
      const double radius = name == "HOLES2" ? v[2] : v[3] + n * v[4];
      const ir::Word x = absolute(Address::x, constant(v[0] + radius * std::cos(angle)));
      const ir::Word y = absolute(Address::y, constant(v[1] + radius * std::sin(angle)));
      native_ ? out_.emit_block({}, {x, y}) : out_.emit_block({code(Function::rapid)}, {x, y});
      if (modal_ && !native_) moves(*modal_);
    }
    if (!native_) motion_again(false);
  }

  // The motion code that was in effect; `always`: behind G80, where another than G00 is not certain either.
  void motion_again(bool always) {
    if (motion_ && (always || *motion_ != Function::rapid)) out_.emit_block({code(*motion_)}, {});
    if (!motion_ && passes::needs_motion(program_, index_))
      cannot("the motion code in effect behind a cycle, which is not known here,");
  }
  // --- blocks

  void block() {
    const ir::Block& old = program_.blocks[statement_.payload];
    const auto codes = program_.codes_of(old);
    const auto words = program_.words_of(old);
    bool own_words = false;
    for (const ir::Code& c : codes) {
      if (c.group == ir::ModalGroup::motion) motion_ = c.function;
      // A cycle by its code, of a program's other language: where it leaves the tool is not followed.
      if (c.group == ir::ModalGroup::motion || c.group == ir::ModalGroup::cycle)
        in_cycle_ = c.group == ir::ModalGroup::cycle;
      if (c.function == Function::cycle_off) in_cycle_ = false;
      if (c.group == ir::ModalGroup::plane) plane_ = c.function;
      if (c.function == Function::absolute || c.function == Function::incremental)
        incremental_ = c.function == Function::incremental;
      own_words |= c.group == ir::ModalGroup::non_modal || c.group == ir::ModalGroup::frame;
      const bool stays = c.function == Function::dwell || c.function == Function::exact_stop_once;
      const bool other_height = (c.group == ir::ModalGroup::non_modal && !stays) || c.group == ir::ModalGroup::frame ||
                                c.group == ir::ModalGroup::work_offset || c.group == ir::ModalGroup::unit ||
                                c.group == ir::ModalGroup::plane || c.group == ir::ModalGroup::length_offset ||
                                c.function == Function::cycle_off;
      if (other_height) height_.reset();
    }
    const bool moves_axes =
        !own_words && std::ranges::any_of(words, [](const ir::Word& w) { return is_axis(w.address); });
    if (in_cycle_ || statement_.skip_level != 0 || old.rest_level != 0)
      height_.reset();
    else if (!own_words)
      take_height(words, incremental_here(codes));
    take_turning(codes, words);
    if (native_) {
      std::vector<ir::Code> others;
      std::ranges::copy_if(codes, std::back_inserter(others),
                           [](const ir::Code& c) { return c.function != Function::rapid; });
      return out_.emit_block(others, {words.begin(), words.end()});
    }
    out_.keep();
    if (modal_ && moves_axes) moves(*modal_);
  }

  void take_turning(std::span<const ir::Code> codes, std::span<const ir::Word> words) {
    for (const ir::Code& c : codes) {
      if (c.function == Function::dwell) return;
      if (c.group == ir::ModalGroup::feed) turning_.feed_mode = c.function;
      if (c.group == ir::ModalGroup::surface_speed) turning_ = {};
      if (c.function == Function::spindle_cw || c.function == Function::spindle_ccw) turning_.spindle = c.function;
      if (c.function == Function::spindle_stop || c.function == Function::spindle_orient) turning_.spindle.reset();
    }
    for (const ir::Word& w : words) {
      if (w.address == Address::f) turning_.feed = number(w.value);
      if (w.address == Address::s) turning_.speed = w.extension > 1 ? std::nullopt : number(w.value);
    }
  }

  // On all ways; nothing where they differ.
  [[nodiscard]] std::optional<bool> incremental_here(std::span<const ir::Code> codes) const {
    for (const ir::Code& c : codes)
      if (passes::mode_of(c) == passes::Mode::distance) return c.function == Function::incremental;
    const passes::ModeFacts* facts = modes_.before(index_);
    if (facts == nullptr) return std::nullopt;
    const passes::ModeFact& fact = (*facts)[passes::index_of(passes::Mode::distance)];
    if (fact.other != Function::none) return std::nullopt;
    return fact.function == Function::none ? incremental_ : fact.function == Function::incremental;
  }

  void take_height(std::span<const ir::Word> words, std::optional<bool> incremental) {
    for (const ir::Word& w : words) {
      if (w.address == Address::d || w.address == Address::t) height_.reset();
      if (w.address != Address::z) continue;
      const bool absolute_word =
          w.mode == ir::WordMode::absolute || (w.mode == ir::WordMode::as_modal && incremental == false);
      height_ = absolute_word ? number(w.value) : std::nullopt;
    }
  }

  // --- small parts

  [[nodiscard]] std::optional<double> number(ExpressionId id) const { return constant_value(program_, id); }
  // Of an argument that is left out: 0.
  [[nodiscard]] std::optional<double> number_at(std::size_t place) const {
    const bool given = place < arguments_.size() && arguments_[place].value != ExpressionId::none;
    return given ? number(arguments_[place].value) : 0.0;
  }

  ExpressionId constant(double value) { return program_.add_constant(value, {}, true); }
  static ir::Code code(Function function) {
    ir::Code c;
    c.function = function;
    return c;
  }
  static ir::Word absolute(Address address, ExpressionId value) {
    ir::Word w = word(address, value);
    w.mode = ir::WordMode::absolute;
    return w;
  }

  // What is said so all the same.
  void tell(std::string what) {
    cannot(std::move(what));
    diagnostics_.back().severity = text::Severity::warning;
  }
  void cannot(std::string what) {
    diagnostics_.push_back(
        text::make_diagnostic(text::DiagnosticId::cannot_translate, statement_.span, {std::move(what), to_.title}));
  }
  ir::Program& program_;
  const ir::Control& to_;
  passes::Rewrite out_;
  std::vector<bool> is_target_;  // of a jump
  std::vector<std::uint32_t> jumps_;
  passes::ModeFlow modes_;
  std::vector<std::optional<Function>> motions_;
  std::set<std::pair<std::string, bool>> told_;  // and whether it was an error
  std::vector<text::Diagnostic> diagnostics_;
  ir::Statement statement_;
  std::uint32_t index_ = 0;
  std::vector<ir::Argument> arguments_;
  std::optional<Hole> modal_;
  bool native_ = false;  // … said by a modal cycle of these controls
  // In the order of the text.
  std::optional<Function> motion_;
  bool in_cycle_ = false;
  Function plane_;
  bool incremental_ = false;
  std::optional<double> height_;
  struct Turning {
    std::optional<Function> feed_mode;
    std::optional<double> feed;
    std::optional<double> speed;
    std::optional<Function> spindle;
  };
  Turning turning_;
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

// What is known of pole, radius, angle and motion is followed in the order of the text and forgotten where paths meet.
// (SINUMERIK PG, "Travel commands with polar coordinates"; Fanuc 0i-F B-64604EN-2, "Polar coordinate command".)
#include "dialects/passes/polar_positions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/facts/resolved.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::passes {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::ModalGroup;
using ir::Operator;
using ir::StatementKind;

bool is_polar(const ir::Word& w) { return w.address == Address::polar_angle || w.address == Address::polar_radius; }
bool sets_pole(const ir::Code& c) {
  return c.function >= Function::pole_from_last && c.function <= Function::pole_from_pole;
}
bool switches_letters(const ir::Code& c) {
  return c.function == Function::polar_words_on || c.function == Function::polar_words_off;
}
bool counts_holes(const ir::Word& w) { return w.address == Address::k || w.address == Address::l; }
bool is_arc(Function f) { return f == Function::arc_cw || f == Function::arc_ccw; }

struct Plane {
  Address p;  // first letter: a radius under G16
  Address q;  // an angle
  Address center_p;
  Address center_q;
};
std::optional<Plane> plane_of(Function f) {
  if (f == Function::plane_xy) return Plane{Address::x, Address::y, Address::i, Address::j};
  if (f == Function::plane_zx) return Plane{Address::z, Address::x, Address::k, Address::i};
  if (f == Function::plane_yz) return Plane{Address::y, Address::z, Address::j, Address::k};
  return std::nullopt;
}

// A copy: arenas move while a block is rewritten.
template <class T>
std::vector<T> list(std::span<const T> range) {
  return {range.begin(), range.end()};
}

class PolarPositions {
 public:
  PolarPositions(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program),
        to_(to),
        modes_(source_, from),
        is_target_(facts::jump_targets(program)),
        out_(program),
        has_arcs_(std::ranges::any_of(program.codes, [](const ir::Code& c) { return is_arc(c.function); })),
        motion_(from.semantics.power_on_motion) {}

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      index_ = i;
      statement(program_.statements[i]);
    }
    out_.finish();
    return std::move(diagnostics_);
  }

 private:
  using Value = std::optional<ExpressionId>;
  using Pole = std::array<Value, 2>;

  // By value: the list grows while it is read.
  void statement(const ir::Statement s) {
    const bool meets = is_target_[index_] || ir::is_structure(s.kind);
    const bool leaves = s.kind == StatementKind::go_to || s.kind == StatementKind::native ||
                        (facts::is_call(s.kind) && !facts::is_standard_cycle(program_, s));
    if (meets || leaves) forget();
    if (letters_ && (meets || leaves)) cannot(passes::not_known("G16 over a jump, a loop or a call"));
    if (s.kind == StatementKind::block) return block(s);
    out_.keep();
  }

  void forget() {
    radius_.reset();
    angle_.reset();
    motion_ = Function::none;
  }

  void block(const ir::Statement& s) {
    const ir::Block block = program_.blocks[s.payload];
    const std::vector<ir::Code> codes = list(program_.codes_of(block));
    for (const ir::Code& c : codes) {
      if (c.group == ModalGroup::motion) motion_ = c.function;
      if (c.function == Function::drill) drills_ = true;
      if (c.group == ModalGroup::motion || c.function == Function::cycle_off) drills_ = false;
    }
    const bool pole = std::ranges::any_of(codes, sets_pole);
    const bool words = std::ranges::any_of(program_.words_of(block), is_polar);
    const bool switches = std::ranges::any_of(codes, switches_letters);
    for (const ir::Code& c : codes)
      if (switches_letters(c)) letters_ = c.function == Function::polar_words_on;
    if (!pole && !words && !switches && !letters_) return out_.keep();
    if (block.rest_level != 0 || s.skip_level != 0)
      return refuse(passes::at_switch("a polar position in a block that may be skipped"));
    const std::optional<Plane> plane = plane_here(codes);
    if (!plane) return refuse(passes::not_known("a polar position in a plane that is not known"));
    if (pole) return set_pole(codes, list(program_.words_of(block)), *plane);
    position(codes, list(program_.words_of(block)), *plane);
  }

  [[nodiscard]] std::optional<Plane> plane_here(const std::vector<ir::Code>& codes) const {
    for (const ir::Code& c : codes)
      if (c.group == ModalGroup::plane) return plane_of(c.function);
    const facts::Facts* facts = modes_.before(index_);
    if (facts == nullptr) return std::nullopt;
    const facts::Known<facts::Setting>& fact = (*facts)[facts::Mode::plane];
    return fact.agrees() ? plane_of(fact.value.function) : std::nullopt;
  }
  [[nodiscard]] bool counts_from_zero(const std::vector<ir::Code>& codes) const {
    for (const ir::Code& c : codes)
      if (c.group == ModalGroup::distance) return c.function == Function::absolute;
    const facts::Facts* facts = modes_.before(index_);
    return facts != nullptr && (*facts)[facts::Mode::distance].agrees() &&
           (*facts)[facts::Mode::distance].value.function == Function::absolute;
  }

  // --- the pole

  void set_pole(const std::vector<ir::Code>& codes, const std::vector<ir::Word>& words, const Plane& plane) {
    const Function from = std::ranges::find_if(codes, sets_pole)->function;
    if (codes.size() > 1) return refuse(passes::together("a pole in the same block as another code"));
    if (from == Function::pole_from_last) return refuse(passes::not_known("a pole that counts from the last position"));
    const std::array<Address, 2> letters = {plane.p, plane.q};
    Pole base = zero();
    if (from == Function::pole_from_pole) base = pole_here();
    for (const ir::Word& w : words) {
      const auto* const at = std::ranges::find(letters, w.address);
      if (at == letters.end()) return refuse("a pole by radius and angle");
      Value& value = base[static_cast<std::size_t>(at - letters.begin())];
      if (!value) return refuse(passes::not_known("a pole that counts from one that is not known here"));
      value = held(sum(*value, w.value));
    }
    set_[index_] = base;
  }

  Pole zero() { return {program_.add_constant(0.0), program_.add_constant(0.0)}; }
  [[nodiscard]] Pole pole_here() const {
    // The block that set it, where it is the same on all paths.
    const std::optional<facts::Setting> pole = modes_.certain(facts::Mode::pole, index_);
    const auto set = pole ? set_.find(static_cast<std::uint32_t>(pole->argument)) : set_.end();
    return set == set_.end() ? Pole{} : set->second;
  }

  // --- positions

  void position(const std::vector<ir::Code>& codes, const std::vector<ir::Word>& words, const Plane& plane) {
    bool moves = false;
    std::vector<ir::Word> angles;  // that add to the one before
    for (const ir::Word& w : words) {
      const bool radius = w.address == (letters_ ? plane.p : Address::polar_radius);
      const bool angle = w.address == (letters_ ? plane.q : Address::polar_angle);
      if (!radius && !angle) continue;
      moves = true;
      if (angle && adds(w, codes)) angles.push_back(w);
      if (!take(radius ? radius_ : angle_, w, radius, codes)) return;
    }
    std::vector<ir::Code> kept = codes;
    std::erase_if(kept, switches_letters);
    if (!moves && kept.size() == codes.size()) return out_.keep();
    if (!moves) return emit(kept, words);
    const Pole pole = letters_ ? zero() : pole_here();
    if (!radius_ || !angle_)
      return refuse(passes::not_known("a polar position whose radius or angle is not known here"));
    if (!pole[0] || !pole[1]) return refuse(passes::not_known("a polar position whose pole is not known here"));
    if (motion_ == Function::none && has_arcs_)
      return refuse(passes::not_known("a polar position whose motion is not known here"));
    const bool repeats = drills_ && letters_ && !angles.empty() && std::ranges::any_of(words, counts_holes);
    if (repeats)
      each_hole(kept, words, angles.front(), plane, counts_from_zero(codes));
    else
      emit(kept, with_coordinates(words, plane, pole, counts_from_zero(codes)));
    drop_what_may_change();
  }

  // G91 Y45. K7 under G16: seven holes, each 45 degrees further.
  void each_hole(const std::vector<ir::Code>& codes, std::vector<ir::Word> words, const ir::Word& angle,
                 const Plane& plane, bool absolute) {
    constexpr double kMostHoles = 1000.0;
    const auto count = number(std::ranges::find_if(words, counts_holes)->value);
    if (!count || *count < 1.0 || *count > kMostHoles)
      return refuse(passes::not_known("a number of holes by angle that is not known here"));
    std::erase_if(words, counts_holes);
    emit(codes, with_coordinates(words, plane, zero(), absolute));
    for (auto left = static_cast<std::uint32_t>(*count); left > 1; --left) {
      angle_ = sum(*angle_, angle.value);
      emit({}, with_coordinates({}, plane, zero(), absolute));
    }
  }

  // The block's radius or angle; false when it was refused.
  bool take(Value& value, const ir::Word& w, bool radius, const std::vector<ir::Code>& codes) {
    const bool further = adds(w, codes);
    if (further && letters_ && radius) return refuse(passes::not_known("a radius from where the tool stands")), false;
    if (further && !value)
      return refuse(passes::not_known("a polar increment to a value that is not known here")), false;
    value = further ? sum(*value, w.value) : w.value;
    return true;
  }
  [[nodiscard]] bool adds(const ir::Word& w, const std::vector<ir::Code>& codes) const {
    return w.mode == ir::WordMode::incremental || (letters_ && !counts_from_zero(codes));
  }

  std::vector<ir::Word> with_coordinates(const std::vector<ir::Word>& words, const Plane& plane, const Pole& pole,
                                         bool absolute) {
    std::vector<ir::Word> made;
    const auto put = [&](Address address, ExpressionId value, bool center) {
      ir::Word w;
      w.address = address;
      w.value = value;
      w.mode = absolute && !center ? ir::WordMode::as_modal : ir::WordMode::absolute;
      made.push_back(w);
    };
    put(plane.p, sum(*pole[0], product(*radius_, turned(Operator::cos, *angle_))), false);
    put(plane.q, sum(*pole[1], product(*radius_, turned(Operator::sin, *angle_))), false);
    bool has_center = false;
    for (const ir::Word& w : words) {
      if (is_polar(w) || w.address == plane.p || w.address == plane.q) continue;
      has_center |= (w.address >= Address::i && w.address <= Address::k) || w.address == Address::r ||
                    w.address == Address::arc_radius || w.address == Address::opening_angle;
      made.push_back(w);
    }
    if (is_arc(motion_) && !has_center && !letters_) {
      put(plane.center_p, *pole[0], true);
      put(plane.center_q, *pole[1], true);
    }
    return made;
  }

  // Radius and angle stay for the blocks to come only as what they were: a variable may be another by then.
  void drop_what_may_change() {
    if (radius_ && !number(*radius_)) radius_.reset();
    if (angle_ && !number(*angle_)) angle_.reset();
  }

  void emit(const std::vector<ir::Code>& codes, const std::vector<ir::Word>& words) {
    if (!codes.empty() || !words.empty()) out_.emit_block(codes, words);
  }

  // --- values

  [[nodiscard]] std::optional<double> number(ExpressionId id) const {
    const ir::Expression& e = program_.at(id);
    if (e.op != Operator::constant) return std::nullopt;
    return e.value;
  }
  // As printed with four decimals of an inch or millimetre and one more.
  ExpressionId rounded(double value) { return program_.add_constant(std::round(value * 1e5) / 1e5); }

  ExpressionId sum(ExpressionId a, ExpressionId b) {
    const auto x = number(a);
    const auto y = number(b);
    if (x && y) return rounded(*x + *y);
    if (x && *x == 0.0) return b;
    return program_.add_operator(Operator::add, a, b);
  }
  ExpressionId product(ExpressionId a, ExpressionId b) {
    const auto x = number(a);
    const auto y = number(b);
    return x && y ? program_.add_constant(*x * *y) : program_.add_operator(Operator::multiply, a, b);
  }
  ExpressionId turned(Operator op, ExpressionId angle) {
    const auto degrees = number(angle);
    if (!degrees) return program_.add_operator(op, angle);
    const double radians = *degrees * std::numbers::pi / 180.0;
    return program_.add_constant(op == Operator::sin ? std::sin(radians) : std::cos(radians));
  }
  // A pole is read by later blocks: what it was stays in a variable of its own.
  ExpressionId held(ExpressionId value) {
    if (number(value)) return value;
    ir::Symbol symbol;
    symbol.name = program_.strings.add("pole " + std::to_string(++made_));
    ir::Variable variable;
    variable.bank = ir::Bank::named;
    variable.symbol = program_.add(symbol);
    out_.emit_assign(program_.add(ir::Variable(variable)), value);
    return program_.add_variable(variable);
  }

  void cannot(passes::Refusal what) {
    diagnostics_.push_back(passes::diagnose(std::move(what), program_.statements[index_].span, to_.title));
  }
  void refuse(passes::Refusal what) {
    cannot(std::move(what));
    forget();
  }

  ir::Program& program_;
  const ir::Program source_{program_};  // what the modes are followed in
  const ir::Control& to_;
  facts::Resolved modes_;
  std::vector<bool> is_target_;
  Rewrite out_;
  bool has_arcs_;
  Function motion_;  // none: not known
  std::vector<text::Diagnostic> diagnostics_;
  std::map<std::uint32_t, Pole> set_;  // by the block that sets it
  Value radius_;
  Value angle_;
  bool letters_ = false;
  bool drills_ = false;  // a drilling cycle is in effect, in the order of the text
  std::uint32_t index_ = 0;
  std::uint32_t made_ = 0;
};

bool has_polar_positions(const ir::Program& program) {
  return std::ranges::any_of(program.words, is_polar) || std::ranges::any_of(program.codes, switches_letters) ||
         std::ranges::any_of(program.codes, sets_pole);
}

}  // namespace

std::vector<text::Diagnostic> lower_polar_positions(ir::Program& program, const ir::Control& from,
                                                    const ir::Control& to) {
  const bool mills = from.kind == ir::MachineKind::mill && to.kind == ir::MachineKind::mill;
  if (!mills || ir::has_numbered_variables(from) == ir::has_numbered_variables(to) || !has_polar_positions(program))
    return {};
  return PolarPositions(program, from, to).run();
}

}  // namespace dripfeed::passes

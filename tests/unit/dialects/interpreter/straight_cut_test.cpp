// The short path of a straight cut against the long one of `apply`: seeded states and blocks, the same motion, the same
// notes, and the same moves of the block after it.
#include "dialects/interpreter/block/straight_cut.h"

#include <array>
#include <functional>
#include <random>
#include <span>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/interpreter/block/apply.h"
#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::interpreter {
namespace {

using ir::Address;
using ir::Function;

class Kept : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion> motions) override { all.insert(all.end(), motions.begin(), motions.end()); }
  std::vector<ir::Motion> all;
};

auto fields(const ir::Motion& m) {
  static_assert(sizeof(ir::Motion) == 280, "a new field? It is to be compared.");
  const auto head = std::tuple(m.place.program, m.place.line, m.place.ordinal, m.kind, m.plane, m.feed_mode,
                               m.length_offset, m.axes_commanded, m.machine_coordinates, m.exact_stop);
  const auto path = std::tuple(m.start, m.end, m.center, m.feed, m.spindle_rpm, m.surface_speed_m_min, m.spindle);
  const auto rest = std::tuple(m.comp, m.coolant, m.gaps, m.number, m.tool_offset, m.text, m.axes_unknown,
                               m.length_offset_number, m.compute.blocks, m.compute.jumps, m.compute.number_reads);
  return std::tuple_cat(head, path, rest);
}

auto fields(const ModalState& s) {
  return std::tuple(s.position, s.unknown, s.shifted, s.feed, s.feed_unknown, s.tangent, s.tangent_known,
                    s.modes.motion, s.modes.motion_given, s.corner.kind, s.drilling.active, s.stated);
}

// One of the two runs: a state of its own, and what came out of it.
struct Run {
  explicit Run(const ModalState& begin) : state(begin) { out.work = {.blocks = 3, .jumps = 2}; }
  [[nodiscard]] const std::vector<ir::Motion>& motions() {
    out.flush();
    return kept.all;
  }

  ModalState state;
  RunOptions options;
  RunBudget budget{options};
  Kept kept;
  MotionBuffer out{kept, budget};
};

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  bool chance(int of_hundred) { return static_cast<int>(engine_() % 100) < of_hundred; }
  double length() { return static_cast<double>(static_cast<int>(engine_() % 20001) - 10000) / 100.0; }
  template <class T>
  T of(std::initializer_list<T> all) {
    return all.begin()[engine_() % all.size()];
  }
  std::uint16_t axes() { return static_cast<std::uint16_t>(engine_() % (kAllAxes + 1U)); }

 private:
  std::mt19937 engine_;
};

// What a straight cut goes by.
ModalState quiet_state(Random& random) {
  ModalState s;
  Modes& m = s.modes;
  m.motion = Function::linear;
  m.motion_given = true;
  m.plane = random.of({ir::Plane::xy, ir::Plane::zx, ir::Plane::yz});
  m.feed_mode = random.of({ir::FeedMode::per_min, ir::FeedMode::per_rev, ir::FeedMode::inverse_time});
  m.diameter =
      random.of({ir::DiameterMode::radius, ir::DiameterMode::diameter, ir::DiameterMode::diameter_absolute_only});
  m.comp = random.of({ir::CompSide::off, ir::CompSide::left});
  m.inch = random.chance(30);
  m.inch_feed = random.chance(30);
  m.exact_stop = random.chance(20);
  m.surface_speed = random.chance(20);
  for (double& shift : m.shift) shift = random.chance(30) ? random.length() : 0.0;
  for (double& shift : s.coordinate_shift) shift = random.chance(30) ? random.length() : 0.0;
  for (double& at : s.position) at = random.length();
  s.unknown = random.chance(30) ? random.axes() : 0;
  s.shifted = random.chance(20) ? random.axes() : 0;
  s.comp_number = 7.0;
  s.feed = random.of({0.0, 0.25, 500.0});
  s.feed_unknown = random.chance(10);
  s.rpm = 3000.0;
  s.spindle = random.of({ir::SpindleState::stopped, ir::SpindleState::clockwise});
  s.length_offset = random.of({ir::LengthOffset::off, ir::LengthOffset::plus});
  s.length_offset_number = 4;
  s.gaps = random.of({std::uint8_t{0}, ir::kZerosChanged});
  return s;
}

PlainBlock quiet_block(Random& random, const BlockRules& rules) {
  PlainBlock block;
  for (const Address address : {Address::x, Address::y, Address::z, Address::a, Address::c, Address::u})
    if ((rules.axis_addresses & bit_of(address)) != 0 && random.chance(60)) block.set(address, random.length());
  if (random.chance(50)) block.set(Address::f, random.of({0.0, 0.1, 800.0}));
  if (random.chance(20)) block.in_increments = block.present;
  return block;
}

// Each makes more of the block than a line, or leaves it open.
const std::vector<std::function<void(PlainBlock&, ModalState&)>>& disturbances() {
  static const std::vector<std::function<void(PlainBlock&, ModalState&)>> all = {
      [](PlainBlock&, ModalState& s) { s.modes.motion = Function::rapid; },
      [](PlainBlock&, ModalState& s) { s.modes.motion = Function::thread; },
      [](PlainBlock&, ModalState& s) { s.modes.motion_given = false; },
      [](PlainBlock&, ModalState& s) { s.modes.motion_modelled = false; },
      [](PlainBlock&, ModalState& s) { s.modes.absolute = false; },
      [](PlainBlock&, ModalState& s) { s.modes.polar_words = true; },
      [](PlainBlock&, ModalState& s) {
        s.modes.has_matrix = true;
        s.modes.matrix = {0, -1, 0, 1, 0, 0, 0, 0, 1};
      },
      [](PlainBlock&, ModalState& s) { s.drilling.active = true; },
      [](PlainBlock&, ModalState& s) { s.turning.active = true; },
      [](PlainBlock&, ModalState& s) { s.line = {.active = true, .angle_deg = 30.0}; },
      [](PlainBlock&, ModalState& s) { s.modal_rounding_mm = 1.0; },
      [](PlainBlock&, ModalState& s) { s.offsets_contour = true, s.modes.comp = ir::CompSide::left; },
      [](PlainBlock&, ModalState& s) {
        s.transformation.shape = Transformation::Shape::cylinder;
        s.transformation.radius_mm = 20.0;
      },
      [](PlainBlock& b, ModalState&) { b.unknown = bit_of(Address::x); },
      [](PlainBlock& b, ModalState&) { b.incremental = bit_of(Address::x); },
      [](PlainBlock& b, ModalState&) { b.set(Address::rounding, 1.0); },
      [](PlainBlock& b, ModalState&) { b.set(Address::i, 1.0); },
      [](PlainBlock& b, ModalState&) { b.set(Address::s, 900.0); },
      [](PlainBlock& b, ModalState&) { b.set(Address::t, 3.0); },
      [](PlainBlock& b, ModalState&) { b.set(Address::w, 3.0); },
      [](PlainBlock& b, ModalState&) { b.set(Address::block_feed, 3.0); },
      [](PlainBlock& b, ModalState&) { b.present = bit_of(Address::f); },
  };
  return all;
}

const std::vector<PlainCode>& linear_code() {
  static const std::vector<PlainCode> codes = {{Function::linear, 0, ir::ModalGroup::motion}};
  return codes;
}

// Incremental and with a rounding at its end: it goes by all that the cut before it left.
PlainBlock block_after() {
  PlainBlock block;
  block.set(Address::x, 30.0);
  block.set(Address::z, -20.0);
  block.incremental = bit_of(Address::z);
  return block;
}

const ir::Control& control_of(int which) {
  static const std::array controls = {test::mill_control(), test::lathe_control(), test::sinumerik_control()};
  return controls[static_cast<std::size_t>(which) % controls.size()];
}

struct Case {
  ModalState state;
  PlainBlock block;
};

Case make_case(Random& random, const BlockRules& rules) {
  Case made{quiet_state(random), quiet_block(random, rules)};
  if (random.chance(60)) made.block.codes = linear_code();
  if (random.chance(40)) {
    const auto& all = disturbances();
    const auto which = static_cast<std::size_t>(random.length() + 100.0) % all.size();
    all[which](made.block, made.state);
  }
  return made;
}

void expect_same(const Case& one, const BlockRules& rules) {
  Run quick(one.state);
  Run whole(one.state);
  const std::uint64_t notes = cut_straight(one.block, rules, quick.state, quick.out);
  const BlockResult result = apply(one.block, rules, whole.state, whole.out);
  EXPECT_EQ(notes, result.notes);
  EXPECT_TRUE(result.moved);
  EXPECT_EQ(result.fault, text::DiagnosticId::count_);
  EXPECT_EQ(fields(quick.state), fields(whole.state));
  (void)apply(block_after(), rules, quick.state, quick.out);
  (void)apply(block_after(), rules, whole.state, whole.out);
  ASSERT_EQ(quick.motions().size(), whole.motions().size());
  for (std::size_t n = 0; n < quick.motions().size(); ++n)
    EXPECT_EQ(fields(quick.motions()[n]), fields(whole.motions()[n])) << "motion " << n;
}

TEST(StraightCutTest, MakesWhatTheLongPathMakes) {
  Random random(20261128);
  int straight = 0;
  for (int n = 0; n < 15'000; ++n) {
    const BlockRules rules(control_of(n));
    const Case made = make_case(random, rules);
    if (!is_straight_cut(made.block, rules, made.state)) continue;
    ++straight;
    expect_same(made, rules);
    if (HasFailure()) FAIL() << "case " << n;
  }
  EXPECT_GT(straight, 5'000);
}

TEST(StraightCutTest, LeavesWhatIsMoreThanALineToTheLongPath) {
  Random random(1);
  for (int which = 0; which < 3; ++which) {
    const BlockRules rules(control_of(which));
    for (std::size_t n = 0; n < disturbances().size(); ++n) {
      Case made{quiet_state(random), {}};
      made.block.set(Address::x, 10.0);
      made.block.set(Address::z, 10.0);
      ASSERT_TRUE(is_straight_cut(made.block, rules, made.state));
      disturbances()[n](made.block, made.state);
      EXPECT_FALSE(is_straight_cut(made.block, rules, made.state)) << "control " << which << ", disturbance " << n;
    }
  }
}

}  // namespace
}  // namespace dripfeed::interpreter

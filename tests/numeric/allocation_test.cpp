// A long program costs no more memory requests than a short one: a counting operator new around each check.
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

#include <gtest/gtest.h>

#include "checks/accuracy/accuracy.h"
#include "checks/envelope/envelope.h"
#include "checks/gouge/gouge.h"
#include "checks/timing/timing.h"
#include "dialects/curves/conic.h"

namespace {
std::atomic<std::uint64_t> requests{0};
}  // namespace

void* operator new(std::size_t size) {
  ++requests;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace dripfeed {
namespace {

constexpr std::uint64_t kConstant = 64;
const curves::Conic kRoll{curves::ConicKind::hyperbola, 100, 202.4, {0, 0}};

// Passes along a hyperbola and back, in batches from one array, with a stop at each end.
template <class Check>
std::uint64_t requests_of(Check& check, std::size_t count) {
  std::vector<ir::Motion> batch(ir::kMotionBatch);
  const std::uint64_t before = requests;
  double z = 98;
  double step = -0.01;
  std::size_t made = 0;
  while (made < count) {
    std::size_t n = 0;
    for (; n < batch.size() && made < count; ++n, ++made) {
      ir::Motion& motion = batch[n];
      motion.kind = ir::MotionKind::linear;
      motion.plane = ir::Plane::zx;
      motion.feed = 2000;
      motion.place = {0, static_cast<std::uint32_t>(made % 60000 + 1), made};
      motion.axes_commanded = 0b101;
      motion.start[0] = 2 * kRoll.at(z).x;
      motion.start[2] = z;
      if (z + step < -98 || z + step > 98) step = -step;
      z += step;
      motion.end[0] = 2 * kRoll.at(z).x;
      motion.end[2] = z;
    }
    check.consume(std::span(batch).first(n));
  }
  return requests - before;
}

checks::Machine lathe() {
  checks::Machine machine;
  machine.axes.push_back({.axis = ir::Axis::x,
                          .is_diameter = true,
                          .min = -500,
                          .max = 500,
                          .rapid_mm_min = 12000,
                          .acceleration_mm_s2 = 2000});
  machine.axes.push_back(
      {.axis = ir::Axis::z, .min = -500, .max = 500, .rapid_mm_min = 12000, .acceleration_mm_s2 = 2000});
  machine.timing.sample_time_ms = 4;
  machine.timing.look_ahead_blocks = 300;
  machine.buffer = {4096, 0};
  return machine;
}

TEST(Allocations, TimingIsFlat) {
  timing::Settings settings{
      .machine = lathe(), .x_is_diameter = true, .line = timing::Line{.baud = 2000000, .bits_per_char = 11}};
  settings.line_bytes.assign(60000, 20);
  timing::Timing few(settings), many(settings);
  const std::uint64_t base = requests_of(few, 10000);
  EXPECT_LE(requests_of(many, 1000000), base + kConstant);
  const timing::Report report = many.finish();
  EXPECT_EQ(report.blocks, 1000000U);
  EXPECT_EQ(report.stalls, 0U);
}

TEST(Allocations, EnvelopeIsFlat) {
  envelope::Envelope few({.machine = lathe()}), many({.machine = lathe()});
  const std::uint64_t base = requests_of(few, 1000);
  EXPECT_LE(requests_of(many, 1000000), base + kConstant);
}

TEST(Allocations, AccuracyIsFlat) {
  const accuracy::Settings settings{.nominal = {{{curves::curve_of(kRoll, {-98, 98}), 0.01}}}, .coverage_mm = 0.02};
  accuracy::Accuracy few(settings), many(settings);
  const std::uint64_t base = requests_of(few, 1000);
  EXPECT_LE(requests_of(many, 100000), base + kConstant);
  EXPECT_TRUE(many.finish().covered);
}

TEST(Allocations, GougeIsFlat) {
  gouge::Settings settings;
  settings.stock = gouge::Cylinder{230, -98, 98};
  settings.nominal = {{{curves::curve_of(kRoll, {-98, 98}), 0.01}}};
  gouge::Gouge few(settings), many(settings);
  const std::uint64_t base = requests_of(few, 1000);
  EXPECT_LE(requests_of(many, 100000), base + kConstant);
}

}  // namespace
}  // namespace dripfeed

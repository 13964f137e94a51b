// The hot path allocates nothing: a million blocks cost as many allocations as a thousand.
#include <atomic>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "tests/unit/dialects/interpreter/run_trace.h"

namespace {
std::atomic<std::uint64_t> allocations{0};
void* count_and_allocate(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
}  // namespace

// All forms without alignment come here; the interpreter has no over-aligned types.
void* operator new(std::size_t size) { return count_and_allocate(size); }
void* operator new[](std::size_t size) { return count_and_allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace dripfeed::test {
namespace {

using ir::Address;
using ir::Function;
using ir::Operator;
using Builder = ProgramBuilder;

// A loop with arithmetic, an indirect variable, a call, a message and a cut in every pass.
void build_loop(Builder& b, double passes) {
  const auto read = [&](std::uint32_t number) { return b.read(Builder::hash(number)); };
  b.assign(Builder::hash(1), b.number(0));
  b.block({{Function::linear}, {Function::spindle_cw}}, {{Address::f, 100.0}, {Address::s, 500.0}});
  b.when(ir::StatementKind::while_begin, b.apply(Operator::less, read(1), b.number(passes)));
  b.assign(Builder::hash(2), b.apply(Operator::multiply, b.number(100), b.apply(Operator::sin, read(1))));
  b.assign(Builder::indirect(ir::Bank::hash, b.number(101)), read(2));
  b.call(ir::CallKind::macro, "O9000", {{'X', read(2)}});
  b.message(b.text("the same message in every pass, long enough to need memory"));
  b.block({}, {{Address::x, read(2)}, {Address::y, read(1)}});
  b.block({{Function::arc_cw}}, {{Address::i, 5.0}});
  b.block({{Function::linear}}, {{Address::z, -1.0}});
  b.assign(Builder::hash(1), b.apply(Operator::add, read(1), b.number(1)));
  b.structure(ir::StatementKind::while_end);
  b.end();
}

class Discard : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion> motions) override { count += motions.size(); }
  std::uint64_t count = 0;
};

std::uint64_t allocations_of(double passes, std::uint64_t& blocks) {
  Builder macro("O9000");
  macro.assign(Builder::hash(100), macro.read(Builder::hash(24)));
  macro.back();
  Programs programs;
  programs.add("O9000", macro.build());
  Builder b;
  build_loop(b, passes);
  b.build();
  Discard sink;
  const std::uint64_t before = allocations.load();
  const auto result = interpreter::run(b.program(), mill_control(), programs, sink, {});
  const std::uint64_t used = allocations.load() - before;
  EXPECT_EQ(result.ended, interpreter::Ended::end);
  blocks = result.blocks;
  return used;
}

TEST(Allocations, DoNotGrowWithTheBlocks) {
  std::uint64_t few_blocks = 0;
  std::uint64_t many_blocks = 0;
  const std::uint64_t few = allocations_of(83, few_blocks);
  const std::uint64_t many = allocations_of(83'333, many_blocks);
  EXPECT_GT(few, 0U);  // the counter counts
  EXPECT_NEAR(static_cast<double>(few_blocks), 1e3, 50.0);
  EXPECT_NEAR(static_cast<double>(many_blocks), 1e6, 5e4);
  EXPECT_LE(many - few, 8U);
}

TEST(Allocations, TheTraceReusesItsText) {
  const auto allocations_with = [](double passes) {
    Builder b;
    b.assign(Builder::hash(1), b.number(0));
    b.when(ir::StatementKind::while_begin, b.apply(Operator::less, b.read(Builder::hash(1)), b.number(passes)));
    b.block({{Function::rapid}}, {{Address::x, b.read(Builder::hash(1))}});
    b.assign(Builder::hash(1), b.apply(Operator::add, b.read(Builder::hash(1)), b.number(1)));
    b.structure(ir::StatementKind::while_end);
    b.end();
    b.build();
    interpreter::RunNames names;
    std::uint64_t bytes = 0;
    const ir::Control control = mill_control();
    interpreter::TraceWriter writer(control, names, [&](std::string_view text) { bytes += text.size(); });
    interpreter::RunOptions options;
    options.names = &names;
    const std::uint64_t before = allocations.load();
    interpreter::run(b.program(), control, interpreter::no_programs(), writer, options);
    EXPECT_GT(bytes, 30.0 * passes);
    return allocations.load() - before;
  };
  const std::uint64_t few = allocations_with(5'000);
  EXPECT_LE(allocations_with(100'000), few + 8U);
}

}  // namespace
}  // namespace dripfeed::test

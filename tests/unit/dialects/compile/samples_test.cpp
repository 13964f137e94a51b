// The sample programs, each written for one control, on the three others: the same moves there, by plain blocks
// and by variables, loops, cycles and frames.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

// Plain blocks are rounded as each control prints them; computed ones are not.
constexpr double kRounding = 0.0006;
constexpr double kExact = 1e-6;

struct Sample {
  std::string dialect;
  std::string name;
  std::string text;
  ir::MachineKind kind = ir::MachineKind::mill;
};

std::vector<Sample> samples() {
  std::vector<Sample> all;
  for (const std::string& dialect : dialect_names()) {
    const std::string folder = "tests/samples/" + dialect;
    for (const auto& file : std::filesystem::directory_iterator(std::string(DRIPFEED_SOURCE_DIR) + "/" + folder)) {
      const std::string name = file.path().filename().string();
      Sample sample{.dialect = dialect, .name = name, .text = file_text(folder + "/" + name)};
      if (sample.text.contains("LATHE") || sample.text.contains("DIAMON")) sample.kind = ir::MachineKind::lathe;
      all.push_back(std::move(sample));
    }
  }
  return all;
}

ConvertResult converted(const Sample& sample, const std::string& to, ConvertMode mode) {
  ConvertRequest request;
  request.source = text::Source(sample.name, sample.text);
  request.from = control(sample.dialect, sample.kind);
  request.to = control(to, sample.kind);
  request.mode = mode;
  return convert(request);
}

TEST(Samples, EveryControlHasSome) {
  const std::vector<Sample> all = samples();
  for (const std::string& dialect : dialect_names()) {
    EXPECT_GE(std::ranges::count(all, dialect, &Sample::dialect), 3) << dialect;
  }
}

TEST(Samples, MoveTheSameAsPlainBlocksOfEveryOtherControl) {
  for (const Sample& sample : samples()) {
    const auto original = moves_of(run_text(sample.text, control(sample.dialect, sample.kind)).motions);
    ASSERT_GE(original.size(), 9U) << sample.name;
    for (const std::string& to : dialect_names()) {
      if (to == sample.dialect) continue;
      SCOPED_TRACE(sample.dialect + "/" + sample.name + " on " + to);
      const ConvertResult result = converted(sample, to, ConvertMode::explicit_blocks);
      ASSERT_FALSE(text::has_error(result.diagnostics))
          << messages_of(result.diagnostics, text::Source("", sample.text));
      const auto moves = moves_of(run_text(result.text, control(to, sample.kind)).motions);
      // 0.0001 inch is 0.00254 mm.
      const bool inch = sample.text.contains("G20") || sample.text.contains("G70");
      expect_same(original, moves, inch ? 4.0 * kRounding : kRounding, result.text);
    }
  }
}

TEST(Samples, MoveTheSameAsMacrosOfEveryOtherControl) {
  for (const Sample& sample : samples()) {
    const auto original = real_moves(run_text(sample.text, control(sample.dialect, sample.kind)).motions);
    for (const std::string& to : dialect_names()) {
      if (to == sample.dialect) continue;
      SCOPED_TRACE(sample.dialect + "/" + sample.name + " on " + to);
      const ConvertResult result = converted(sample, to, ConvertMode::macro);
      ASSERT_FALSE(text::has_error(result.diagnostics))
          << messages_of(result.diagnostics, text::Source("", sample.text));
      expect_same(original, real_moves(run_text(result.text, control(to, sample.kind)).motions), kExact, result.text);
    }
  }
}

}  // namespace
}  // namespace dripfeed::compile::test

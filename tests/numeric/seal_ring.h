// The four programs of the seal ring (tests/samples/seal_ring), read and run as a SINUMERIK would.
#pragma once

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/execute.h"
#include "server/json/profile_document.h"

namespace dripfeed::seal_ring {

class Collect final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion> motions) override { all.insert(all.end(), motions.begin(), motions.end()); }
  std::vector<ir::Motion> all;
};

inline text::Source text_of(const std::string& name) {
  std::ifstream file(DRIPFEED_SOURCE_DIR "/tests/samples/seal_ring/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return {name, text.str()};
}

// The cost model of the paper's control.
inline ir::CostModel preset() {
  std::ifstream file(DRIPFEED_SOURCE_DIR "/deploy/machines/sinumerik-810d-lathe.json");
  std::ostringstream text;
  text << file.rdbuf();
  const auto profile = json::read_profile(text.str());
  EXPECT_TRUE(profile);
  return profile->machine.timing.cost.value();
}

// The cutting moves of a program.
inline std::vector<ir::Motion> points_of_text(const text::Source& source) {
  const compile::Dialect& dialect = *compile::find_dialect("sinumerik-840d");
  ir::Control control = dialect.control(ir::MachineKind::mill_turn, ir::GSystem::a);
  for (ir::VariableRange& range : control.variables) {
    if (range.bank == ir::Bank::r) range.last = std::max(range.last, 499U);  // the table is in R300 to R471
  }
  const auto read = dialect.read(source, control);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << source.name();
  Collect collect;
  const auto run = compile::execute(read.program, control, nullptr, collect, {});
  EXPECT_EQ(run.ended, interpreter::Ended::end) << source.name();
  std::erase_if(collect.all, [](const ir::Motion& m) { return m.kind != ir::MotionKind::linear; });
  EXPECT_EQ(collect.all.size(), 4U * 72U) << source.name();
  return collect.all;
}

// Of one of the four.
inline std::vector<ir::Motion> points_of(const std::string& name) { return points_of_text(text_of(name)); }

inline constexpr std::array kPrograms = {"1_lud.mpf", "2_r.mpf", "3_merged.mpf", "4_table.mpf"};

}  // namespace dripfeed::seal_ring

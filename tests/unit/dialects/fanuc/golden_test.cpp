// Golden programs under tests/golden/fanuc/<diagnostic>/: trigger*.nc must give that diagnostic, near_miss*.nc must
// not, and all diagnostics must be those of the .expected.diagnostics file beside it (UPDATE_GOLDEN=1 writes it). A
// name with .drip is fed while it runs, one with .machine stands for a named machine.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/fanuc/fanuc.h"

namespace dripfeed::fanuc {
namespace {

namespace fs = std::filesystem;

fs::path golden_folder() { return fs::path(DRIPFEED_SOURCE_DIR) / "tests/golden/fanuc"; }

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<fs::path> programs() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(golden_folder())) {
    if (entry.path().extension() == ".nc") found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

// One line a diagnostic: line:column severity[id] alarm: text
std::string diagnostics_of(const fs::path& path) {
  const std::string name = path.filename().string();
  const text::Source source(name, content_of(path));
  ir::Control control = infer_control(source);
  if (name.contains(".machine")) {
    control = fanuc::control(control.kind, control.g_system);
    control.from_profile = true;
  }
  const ir::ReadResult read = fanuc::read(source, control);
  EXPECT_EQ(ir::print_same(read.program), source.text()) << path;
  std::vector<text::Diagnostic> all = read.diagnostics;
  const auto delivery = name.contains(".drip") ? ir::Delivery::drip : ir::Delivery::memory;
  for (text::Diagnostic& d : validate(read.program, control, delivery)) all.push_back(std::move(d));
  std::ranges::stable_sort(all, {}, [](const text::Diagnostic& d) { return d.span.begin; });
  std::string out;
  for (const text::Diagnostic& d : all) {
    const text::Position at = source.position(d.span.begin);
    out += fmt::format("{}:{} {}[{}] {}: {}\n", at.line, at.column, text::name_of(d.severity), text::row_of(d.id).name,
                       d.alarm.empty() ? "-" : d.alarm, text::message_of(d));
  }
  return out;
}

TEST(Golden, DiagnosticsAreAsExpected) {
  const bool update = std::getenv("UPDATE_GOLDEN") != nullptr;
  ASSERT_GT(programs().size(), 90U);
  for (const fs::path& path : programs()) {
    const fs::path expected = path.string() + ".expected.diagnostics";
    const std::string actual = diagnostics_of(path);
    if (update) std::ofstream(expected, std::ios::binary) << actual;
    EXPECT_EQ(actual, content_of(expected)) << path;
    EXPECT_TRUE(fs::exists(expected)) << expected;
  }
}

TEST(Golden, TriggersTriggerAndNearMissesDoNot) {
  for (const auto& entry : fs::directory_iterator(golden_folder())) {
    const std::string id = entry.path().filename().string();
    if (text::find_diagnostic(id) == nullptr) continue;  // papers and other topics
    int triggers = 0;
    int near_misses = 0;
    for (const auto& file : fs::directory_iterator(entry.path())) {
      if (file.path().extension() != ".nc") continue;
      const bool found = diagnostics_of(file.path()).contains("[" + id + "]");
      const bool trigger = file.path().filename().string().starts_with("trigger");
      EXPECT_EQ(found, trigger) << file.path();
      ++(trigger ? triggers : near_misses);
    }
    EXPECT_GE(triggers, 1) << id;
    EXPECT_GE(near_misses, 1) << id;
  }
}

TEST(Golden, EachNamesItsOracle) {
  for (const fs::path& path : programs()) {
    if (path.filename() == "hyperbola_as_printed.nc") continue;  // the paper's bytes
    const std::string text = content_of(path);
    const auto comment = text.find('(');
    EXPECT_TRUE(text.substr(comment).starts_with("(ORACLE: ")) << path;
  }
}

}  // namespace
}  // namespace dripfeed::fanuc

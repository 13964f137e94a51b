// Golden programs under tests/golden/sinumerik/<diagnostic>/: trigger* must give that diagnostic, near_miss* must not,
// and all diagnostics must be those of the .expected.diagnostics file next to it (UPDATE_GOLDEN=1 writes it). A name
// with .drip is fed while it runs, one with .machine stands for a named machine. Folders that are no diagnostic hold
// programs of papers.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/sinumerik/sinumerik.h"

namespace dripfeed::sinumerik {
namespace {

namespace fs = std::filesystem;

fs::path golden_folder() { return fs::path(DRIPFEED_SOURCE_DIR) / "tests/golden/sinumerik"; }

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool is_program(const fs::path& path) { return path.extension() == ".mpf" || path.extension() == ".spf"; }

std::vector<fs::path> programs() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(golden_folder()))
    if (is_program(entry.path())) found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

// One line a diagnostic: line:column severity[id] alarm: text
std::string diagnostics_of(const fs::path& path) {
  const std::string name = path.filename().string();
  const text::Source source(name, content_of(path));
  ir::Control control = infer_control(source);
  if (name.contains(".machine")) {
    control = sinumerik::control(control.kind);
    control.from_profile = true;
  }
  const ir::ReadResult read = sinumerik::read(source, control);
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
  ASSERT_GT(programs().size(), 100U);
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
    if (text::find_diagnostic(id) == nullptr) continue;
    int triggers = 0;
    int near_misses = 0;
    for (const auto& file : fs::directory_iterator(entry.path())) {
      if (!is_program(file.path())) continue;
      const bool found = diagnostics_of(file.path()).contains("[" + id + "]");
      const bool trigger = file.path().filename().string().starts_with("trigger");
      EXPECT_EQ(found, trigger) << file.path() << "\n" << diagnostics_of(file.path());
      ++(trigger ? triggers : near_misses);
    }
    EXPECT_GE(triggers, 1) << id;
    EXPECT_GE(near_misses, 1) << id;
  }
}

// A near miss is a good program: nothing else is wrong with it either, as far as errors go.
TEST(Golden, NearMissesAreFreeOfErrors) {
  for (const fs::path& path : programs()) {
    if (!path.filename().string().starts_with("near_miss")) continue;
    EXPECT_FALSE(diagnostics_of(path).contains(" error[")) << path << "\n" << diagnostics_of(path);
  }
}

TEST(Golden, EachNamesItsOracle) {
  for (const fs::path& path : programs()) {
    if (text::find_diagnostic(path.parent_path().filename().string()) == nullptr) continue;  // a paper's own bytes
    EXPECT_TRUE(content_of(path).starts_with("; oracle: ")) << path;
  }
}

// The alarms that a control's list names must be the ones that its diagnostics carry.
TEST(Golden, EveryAlarmOfTheTableIsOfARuleThatExists) {
  for (const ir::AlarmRow& row : control(ir::MachineKind::mill).alarms) {
    EXPECT_FALSE(row.alarm.empty());
    EXPECT_EQ(row.alarm, alarm_of(control(ir::MachineKind::mill), row.id, row.detail));
  }
}

}  // namespace
}  // namespace dripfeed::sinumerik

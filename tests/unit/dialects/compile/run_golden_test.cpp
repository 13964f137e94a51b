// Golden programs under tests/golden/run/<diagnostic>/ for what only a run sees: trigger* must give that diagnostic,
// near_miss* must not, and all that the run says must be what the .expected.run file next to it says (UPDATE_GOLDEN=1
// writes it). A program is a lathe's where it says so, and x.cir.nc one of a control whose 3403#5 (CIR) is 1.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// x.nc is Fanuc's, x.m80.nc and x.mazak.nc are those controls', x.mpf is SINUMERIK's.
std::string dialect_of(const fs::path& path) {
  if (path.extension() == ".mpf") return "sinumerik-840d";
  const std::string ending = path.stem().extension().string();
  return ending == ".m80" ? "mitsubishi-m80" : ending == ".mazak" ? "mazak" : "fanuc";
}

std::string reported_by_run(const fs::path& path, const std::string& id, bool& gives) {
  const text::Source source(path.filename().string(), content_of(path));
  const auto kind = source.text().contains("LATHE") ? ir::MachineKind::lathe : ir::MachineKind::mill;
  const std::string dialect = dialect_of(path);
  ir::Control machine = control(dialect, kind);
  if (path.stem().extension() == ".cir") machine.semantics.arc_without_center_is_line = false;
  const ir::ReadResult read = find_dialect(dialect)->read(source, machine);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << path;
  ProgramLibrary standard(machine, [](std::string_view) { return std::nullopt; });
  Motions motions;
  std::string out;
  for (const auto& d : execute(read.program, machine, &standard, motions, {}).diagnostics) {
    const std::string_view name = text::row_of(d.diagnostic.id).name;
    gives |= name == id;
    out += fmt::format("{} {}[{}] {}: {}\n", d.line, text::name_of(d.diagnostic.severity), name,
                       d.diagnostic.alarm.empty() ? "-" : d.diagnostic.alarm, text::message_of(d.diagnostic));
  }
  return out;
}

TEST(RunGolden, TriggersTriggerAndNearMissesDoNot) {
  const bool update = std::getenv("UPDATE_GOLDEN") != nullptr;
  std::size_t programs = 0;
  for (const auto& folder : fs::directory_iterator(fs::path(DRIPFEED_SOURCE_DIR) / "tests/golden/run")) {
    const std::string id = folder.path().filename().string();
    ASSERT_NE(text::find_diagnostic(id), nullptr) << id;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      const fs::path& path = entry.path();
      if (path.extension() != ".nc" && path.extension() != ".mpf") continue;
      ++programs;
      bool gives = false;
      const std::string actual = reported_by_run(path, id, gives);
      EXPECT_EQ(gives, path.filename().string().starts_with("trigger")) << path << "\n" << actual;
      const fs::path expected = path.string() + ".expected.run";
      if (update) std::ofstream(expected, std::ios::binary) << actual;
      EXPECT_TRUE(fs::exists(expected)) << expected;
      EXPECT_EQ(actual, content_of(expected)) << path;
    }
  }
  EXPECT_GE(programs, 2U);
}

}  // namespace
}  // namespace dripfeed::compile::test

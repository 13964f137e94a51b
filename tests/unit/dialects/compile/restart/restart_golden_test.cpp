// Golden programs under tests/golden/restart/<diagnostic>/: a restart at the line that says HERE gives that diagnostic
// for trigger* and a text for near_miss*. What it says, or the preamble and what it assumes, is what the
// .expected.restart file next to it says (UPDATE_GOLDEN=1 writes it).
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/compile/restart/restart.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string written(const Restart& made, bool& gives, const std::string& id) {
  std::string out;
  for (const text::Diagnostic& d : made.diagnostics) {
    gives |= text::row_of(d.id).name == id;
    out += fmt::format("{}[{}] {}\n", text::name_of(d.severity), text::row_of(d.id).name, text::message_of(d));
  }
  if (!made.diagnostics.empty()) return out + fmt::format("possible: {} {}\n", made.safe_before, made.safe_after);
  for (const std::string& one : made.assumptions) out += one + "\n";
  return out + fmt::format("line {} of:\n", made.rest_line) + made.preamble;
}

TEST(RestartGolden, TriggersAreRefusedAndNearMissesAreNot) {
  const bool update = std::getenv("UPDATE_GOLDEN") != nullptr;
  std::size_t programs = 0;
  for (const auto& folder : fs::directory_iterator(fs::path(DRIPFEED_SOURCE_DIR) / "tests/golden/restart")) {
    const std::string id = folder.path().filename().string();
    ASSERT_NE(text::find_diagnostic(id), nullptr) << id;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      const fs::path& path = entry.path();
      if (path.extension() != ".nc" && path.extension() != ".mpf") continue;
      ++programs;
      const text::Source source(path.filename().string(), content_of(path));
      const std::size_t here = source.text().find("HERE");
      ASSERT_NE(here, std::string_view::npos) << path;
      const auto kind = source.text().contains("LATHE") ? ir::MachineKind::lathe : ir::MachineKind::mill;
      const std::string dialect = path.extension() == ".mpf" ? "sinumerik-840d" : "fanuc";
      const Restart made = restart_at({.source = source,
                                       .control = control(dialect, kind),
                                       .line = source.position(static_cast<std::uint32_t>(here)).line});
      bool gives = false;
      const std::string actual = written(made, gives, id);
      const bool trigger = path.filename().string().starts_with("trigger");
      EXPECT_EQ(gives, trigger) << path << "\n" << actual;
      EXPECT_EQ(made.text.empty(), trigger) << path << "\n" << actual;
      const fs::path expected = path.string() + ".expected.restart";
      if (update) std::ofstream(expected, std::ios::binary) << actual;
      EXPECT_TRUE(fs::exists(expected)) << expected;
      EXPECT_EQ(actual, content_of(expected)) << path;
    }
  }
  EXPECT_GE(programs, 10U);
}

}  // namespace
}  // namespace dripfeed::compile::test

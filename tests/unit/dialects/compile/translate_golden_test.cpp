// Programs under tests/golden/translate and what they become on every other control, macro and explicit: the text, what
// is reported of it, and why a run of both could not compare them. x.nc is Fanuc's, x.mpf SINUMERIK's; a program is a
// lathe's where it says LATHE, and with .machine in its name source and target are named machines. The answers stand in
// the .expected.translate file next to it (UPDATE_GOLDEN=1 writes it). A program named refused* gives no text anywhere.
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

ir::Control control_for(const std::string& dialect, const text::Source& source) {
  const auto kind = source.text().contains("LATHE") ? ir::MachineKind::lathe : ir::MachineKind::mill;
  ir::Control made = control(dialect, kind);
  made.from_profile = source.name().contains(".machine");
  return made;
}

std::string translation(const text::Source& source, const std::string& from, const std::string& to, ConvertMode mode) {
  ProgramLibrary standard(control_for(from, source), [](std::string_view) { return std::nullopt; });
  ConvertRequest request{.source = source,
                         .from = control_for(from, source),
                         .to = control_for(to, source),
                         .mode = mode,
                         .library = &standard};
  const ConvertResult result = convert(request);
  std::string out = fmt::format("=== {} {}\n", to, mode == ConvertMode::macro ? "macro" : "explicit");
  for (const text::Diagnostic& d : result.diagnostics)
    out += fmt::format("{} {}[{}]: {}\n", source.position(d.span.begin).line, text::name_of(d.severity),
                       text::row_of(d.id).name, text::message_of(d));
  if (text::has_error(result.diagnostics)) {
    EXPECT_EQ(result.text, "") << source.name();
    return out;
  }
  if (!result.not_verified.empty()) out += fmt::format("not verified: {}\n", result.not_verified);
  return out + result.text;
}

TEST(TranslateGolden, EveryTargetAndMode) {
  const bool update = std::getenv("UPDATE_GOLDEN") != nullptr;
  std::size_t programs = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(DRIPFEED_SOURCE_DIR) / "tests/golden/translate")) {
    const fs::path& path = entry.path();
    if (path.extension() != ".nc" && path.extension() != ".mpf") continue;
    ++programs;
    const text::Source source(path.filename().string(), content_of(path));
    const std::string from = path.extension() == ".mpf" ? "sinumerik-840d" : "fanuc";
    std::string actual;
    for (const std::string& to : dialect_names())
      if (to != from)
        for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks})
          actual += translation(source, from, to, mode);
    const fs::path expected = path.string() + ".expected.translate";
    if (update) std::ofstream(expected, std::ios::binary) << actual;
    EXPECT_TRUE(fs::exists(expected)) << expected;
    EXPECT_EQ(actual, content_of(expected)) << path;
    // The texts of all controls set the unit in a block; diagnostics do not.
    if (path.filename().string().starts_with("refused")) {
      EXPECT_FALSE(actual.contains("\nG21 ") || actual.contains("\nG710 ")) << path << "\n" << actual;
    }
  }
  EXPECT_GE(programs, 10U);
}

}  // namespace
}  // namespace dripfeed::compile::test

// Wrong families and what is reported of them: each file in tests/golden/family/errors against its expected text, and
// each near miss against nothing. A line "# set name = value" of the file is an override.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/family/bind.h"
#include "dialects/family/read.h"

namespace dripfeed::family {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(DRIPFEED_SOURCE_DIR) / "tests/golden/family/errors";

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

std::vector<Override> overrides_in(const std::string& text) {
  std::vector<Override> out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    constexpr std::string_view kMark = "# set ";
    const std::size_t equals = line.find(" = ");
    if (line.starts_with(kMark) && equals != std::string::npos) {
      out.push_back({line.substr(kMark.size(), equals - kMark.size()), line.substr(equals + 3)});
    }
  }
  return out;
}

std::string messages_in(const fs::path& path) {
  const std::string text = contents(path);
  const text::Source source(path.filename().string(), text);
  ReadFamilyResult read = read_family(source);
  std::vector<text::Diagnostic> diagnostics = std::move(read.diagnostics);
  if (!text::has_error(diagnostics)) {
    const BindResult bound = bind_family(std::make_shared<const Family>(std::move(read.family)), overrides_in(text));
    diagnostics.insert(diagnostics.end(), bound.diagnostics.begin(), bound.diagnostics.end());
  }
  std::string out;
  for (const text::Diagnostic& diagnostic : diagnostics) out += text::format_diagnostic(diagnostic, source, "");
  return out;
}

std::vector<fs::path> families() {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".family") out.push_back(entry.path());
  }
  std::ranges::sort(out);
  return out;
}

bool is_near_miss(const fs::path& path) { return path.stem().extension() == ".near-miss"; }

TEST(FamilyGolden, ErrorsAreReportedAsExpected) {
  int count = 0;
  for (const fs::path& path : families()) {
    if (is_near_miss(path)) continue;
    ++count;
    const fs::path expected = path.string() + ".expected.diagnostics";
    const std::string messages = messages_in(path);
    if (std::getenv("UPDATE_GOLDEN") != nullptr) std::ofstream(expected, std::ios::binary) << messages;
    EXPECT_EQ(messages, contents(expected)) << path;
    EXPECT_NE(messages, "") << path << " is not wrong";
  }
  EXPECT_GE(count, 18);
}

TEST(FamilyGolden, NearMissesAreFine) {
  for (const fs::path& path : families()) {
    if (is_near_miss(path)) {
      EXPECT_EQ(messages_in(path), "") << path;
    } else {
      EXPECT_TRUE(fs::exists(kFolder / (path.stem().string() + ".near-miss.family"))) << path << " has no near miss";
    }
  }
}

TEST(FamilyGolden, ShippedFamiliesAreFine) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(DRIPFEED_SOURCE_DIR) / "deploy/families")) {
    EXPECT_EQ(messages_in(entry.path()), "") << entry.path();
    ++count;
  }
  EXPECT_GE(count, 3);
}

}  // namespace
}  // namespace dripfeed::family

// Golden programs of the '#' controls, under tests/golden/<folder>/<diagnostic>/: trigger*.nc must give that
// diagnostic, near_miss*.nc must not, and all diagnostics must be those of the expected file next to it
// (UPDATE_GOLDEN=1 writes it). A name with .drip is fed while it runs, one with .machine stands for a named machine,
// .two moves at most two axes at once, .parallel has an axis U besides X, Y and Z.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"

namespace dripfeed::test {

struct GoldenDialect {
  std::string ending;  // of the expected files: ".expected.diagnostics"
  ir::Control (*control)(ir::MachineKind kind, ir::GSystem system);
  ir::Control (*infer_control)(const text::Source& source);
  ir::ReadResult (*read)(const text::Source& source, const ir::Control& control);
  std::vector<text::Diagnostic> (*validate)(const ir::Program& program, const ir::Control& control,
                                            ir::Delivery delivery);
};

class Golden {
 public:
  Golden(GoldenDialect dialect, const std::string& folder)
      : dialect_(std::move(dialect)), folder_(std::filesystem::path(DRIPFEED_SOURCE_DIR) / "tests/golden" / folder) {}

  static std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  [[nodiscard]] std::vector<std::filesystem::path> programs() const {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
      if (entry.path().extension() == ".nc") found.push_back(entry.path());
    }
    std::ranges::sort(found);
    return found;
  }

  // One line a diagnostic: line:column severity[id] alarm: text
  [[nodiscard]] std::string diagnostics_of(const std::filesystem::path& path) const {
    const std::string name = path.filename().string();
    const text::Source source(name, content_of(path));
    ir::Control control = dialect_.infer_control(source);
    if (name.contains(".machine")) {
      control = dialect_.control(control.kind, control.g_system);
      control.from_profile = true;
    }
    if (name.contains(".two")) control.limits.axes_at_once = 2;
    if (name.contains(".parallel")) control.axes = "XYZU";
    const ir::ReadResult read = dialect_.read(source, control);
    EXPECT_EQ(ir::print_same(read.program), source.text()) << path;
    std::vector<text::Diagnostic> all = read.diagnostics;
    const auto delivery = name.contains(".drip") ? ir::Delivery::drip : ir::Delivery::memory;
    for (text::Diagnostic& d : dialect_.validate(read.program, control, delivery)) all.push_back(std::move(d));
    std::ranges::stable_sort(all, {}, [](const text::Diagnostic& d) { return d.span.begin; });
    std::string out;
    for (const text::Diagnostic& d : all) {
      const text::Position at = source.position(d.span.begin);
      out += fmt::format("{}:{} {}[{}] {}: {}\n", at.line, at.column, text::name_of(d.severity),
                         text::row_of(d.id).name, d.alarm.empty() ? "-" : d.alarm, text::message_of(d));
    }
    return out;
  }

  void expect_files() const {
    const bool update = std::getenv("UPDATE_GOLDEN") != nullptr;
    for (const std::filesystem::path& path : programs()) {
      const std::filesystem::path expected = path.string() + dialect_.ending;
      const std::string actual = diagnostics_of(path);
      if (update) std::ofstream(expected, std::ios::binary) << actual;
      EXPECT_EQ(actual, content_of(expected)) << path;
      EXPECT_TRUE(std::filesystem::exists(expected)) << expected;
    }
  }

  // `other`: folders whose rule this control has otherwise; it has programs of its own for them.
  void expect_triggers(const std::vector<std::string>& other = {}) const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      const std::string id = entry.path().filename().string();
      if (text::find_diagnostic(id) == nullptr) continue;  // papers and other topics
      if (std::ranges::find(other, id) != other.end()) continue;
      int triggers = 0;
      int near_misses = 0;
      for (const auto& file : std::filesystem::directory_iterator(entry.path())) {
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

  // `printed`: a program whose bytes are a paper's.
  void expect_oracles(std::string_view printed = {}) const {
    for (const std::filesystem::path& path : programs()) {
      if (path.filename() == printed) continue;
      const std::string text = content_of(path);
      const auto comment = text.find('(');
      ASSERT_NE(comment, std::string::npos) << path;
      EXPECT_TRUE(text.substr(comment).starts_with("(ORACLE: ")) << path;
    }
  }

 private:
  GoldenDialect dialect_;
  std::filesystem::path folder_;
};

}  // namespace dripfeed::test

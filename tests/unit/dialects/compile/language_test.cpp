// What editors ask of a dialect: the words of its language, and the outline of a text.
#include "dialects/compile/dialect/language.h"

#include <algorithm>
#include <map>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/outline.h"

namespace dripfeed::compile {
namespace {

std::map<std::string, DialectWord> words_of(std::string_view dialect, ir::MachineKind kind,
                                            ir::GSystem system = ir::GSystem::a) {
  const Dialect* of = find_dialect(dialect);
  std::map<std::string, DialectWord> words;
  for (DialectWord& word : language_of(*of, of->control(kind, system))) {
    const std::string spelling = word.spelling;
    EXPECT_TRUE(words.emplace(spelling, std::move(word)).second) << dialect << " has twice " << spelling;
  }
  return words;
}

TEST(Language, EachWordIsOnceAndSaysSomething) {
  for (const Dialect& dialect : dialects())
    for (const auto kind : {ir::MachineKind::mill, ir::MachineKind::lathe, ir::MachineKind::mill_turn})
      for (const auto& [spelling, word] : words_of(dialect.name, kind))
        EXPECT_FALSE(word.about.empty()) << dialect.name << ": " << spelling;
}

// Every code that the control knows by a number is found by its name.
TEST(Language, HasEveryCodeOfTheControl) {
  for (const Dialect& dialect : dialects()) {
    const ir::Control control = dialect.control(ir::MachineKind::lathe, ir::GSystem::a);
    const auto words = words_of(dialect.name, ir::MachineKind::lathe);
    for (const auto rows : {control.g_codes, control.m_codes})
      for (const ir::CodeRow& row : rows)
        if (row.function != ir::Function::none) {
          ASSERT_TRUE(words.contains(std::string(row.name))) << dialect.name << ": " << row.name;
          EXPECT_EQ(words.at(std::string(row.name)).sort, ir::WordSort::code);
        }
  }
}

TEST(Language, SaysWhatACodeDoesOnThisControl) {
  EXPECT_EQ(words_of("fanuc", ir::MachineKind::mill).at("G90").about, "absolute");
  EXPECT_EQ(words_of("fanuc", ir::MachineKind::lathe).at("G90").about, "turning cycle along Z");
  EXPECT_EQ(words_of("fanuc", ir::MachineKind::lathe, ir::GSystem::b).at("G90").about, "absolute");
  EXPECT_EQ(words_of("fanuc", ir::MachineKind::mill).at("G55").about, "work offset 2");
  EXPECT_EQ(words_of("fanuc", ir::MachineKind::mill).at("G83").about.substr(0, 18), "deep hole drilling");
  EXPECT_EQ(words_of("sinumerik-840d", ir::MachineKind::mill).at("G500").about, "no work offset");
  EXPECT_EQ(words_of("sinumerik-840d", ir::MachineKind::mill).at("CYCLE83").sort, ir::WordSort::cycle);
  EXPECT_EQ(words_of("mitsubishi-m80", ir::MachineKind::mill).at("ROUND").sort, ir::WordSort::function);
}

std::string outline(const std::string& text, std::string_view dialect = "fanuc") {
  const Dialect* of = find_dialect(dialect);
  const text::Source source("program", text);
  std::string out;
  for (const OutlineRow& row : outline_of(of->read(source, of->infer_control(source))).rows)
    out += fmt::format("{}{} {} {}", out.empty() ? "" : ", ", row.line, name_of(row.sort), row.text);
  return out;
}

TEST(Outline, HasProgramsToolsCallsLabelsAndStops) {
  EXPECT_EQ(outline("%\nO12 (PUMP)\nT1 M6\nM98 P7\nN20 X1.\nGOTO20\nM0\nM30\n%\n"),
            "2 program O12 (PUMP), 3 tool T1 M6, 4 call M98 P7, 5 label N20 X1., 7 stop M0, 8 stop M30");
  EXPECT_EQ(outline("A1: G0 X0\nGROOVE\nCYCLE83(1,2,3,4)\nGOTOB A1\nM30\n", "sinumerik-840d"),
            "1 label A1: G0 X0, 2 call GROOVE, 5 stop M30");
}

TEST(Outline, NumbersThatNothingJumpsToAreNoPlaces) { EXPECT_EQ(outline("N10 X1.\nN20 X2.\n"), ""); }

TEST(Outline, HasEachOfSeveralPrograms) {
  EXPECT_EQ(outline("%\nO1\nM30\nO2\nM99\n%\n"), "2 program O1, 3 stop M30, 4 program O2");
}

TEST(Outline, IsOfATextThatCannotBeReadToo) {
  EXPECT_EQ(outline("%\nO1\nX[1.\nT1 M6\nM30\n"), "2 program O1, 4 tool T1 M6, 5 stop M30");
  EXPECT_EQ(outline(""), "");
  EXPECT_EQ(outline("O1 (\xE4)\nM30\n"), "1 program O1 (\xC3\xA4), 2 stop M30");
}

TEST(Outline, IsCut) {
  std::string text;
  for (int i = 0; i < 600; ++i) text += "M0\n";
  const Dialect* of = find_dialect("fanuc");
  const text::Source source("program", text);
  const Outline found = outline_of(of->read(source, of->infer_control(source)));
  EXPECT_EQ(found.rows.size(), Outline::kMost);
  EXPECT_TRUE(found.is_cut);
}

}  // namespace
}  // namespace dripfeed::compile

// Parameters that are texts or lists of points, and block skip of single statements.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/compile/render/list_table.h"
#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

std::string faults_of(const text::Source& family, const std::string& dialect, const Values& values = {}) {
  const RenderResult result = rendered(family, dialect, RenderMode::macro, values);
  return result.diagnostics.empty() ? "" : messages_of({result.diagnostics.front()}, family);
}

const text::Source kNamed = with("param part text \"FLANGE 7\" count 0..12\nparam depth length 2 mm in 0..9\n",
                                 "  message \"part \" part \", depth \" depth\n  cut x depth\n");

TEST(FamilyTexts, StandInMessagesAndHeadings) {
  EXPECT_EQ(one_trace(kNamed).size(), 1U);
  for (const std::string& dialect : dialect_names()) {
    const bool as_written = dialect.starts_with("sinumerik");
    for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
      const std::string text = rendered(kNamed, dialect, mode, {{"part", "Hub 4711-b"}}).text;
      EXPECT_TRUE(text.contains(as_written ? "part Hub 4711-b, depth 2 mm" : "PART HUB 4711-B, DEPTH 2 MM")) << text;
      EXPECT_EQ(text.find(as_written ? "; part Hub 4711-b\n" : "(PART HUB 4711-B)\n") != std::string::npos, true)
          << text;
      EXPECT_FALSE(text.contains("FLANGE")) << text;
    }
  }
}

TEST(FamilyTexts, MayBeEmpty) {
  EXPECT_TRUE(rendered(kNamed, "fanuc", RenderMode::macro, {{"part", ""}}).text.contains("(PART , DEPTH 2 MM)"));
}

TEST(FamilyTexts, FaultsNameTheParameter) {
  const auto fault = [](const std::string& value) { return faults_of(kNamed, "fanuc", {{"part", value}}); };
  EXPECT_TRUE(fault("A;B").contains("part: character 2 of the text, ';', ends a comment")) << fault("A;B");
  EXPECT_TRUE(fault("50 %").contains("part: character 4 of the text, '%'")) << fault("50 %");
  EXPECT_TRUE(fault("H\xC3\xBClse").contains("part: character 2 of the text is not an ASCII")) << fault("H\xC3\xBClse");
  EXPECT_TRUE(fault("A\nB").contains("part: character 2")) << fault("A\nB");
  EXPECT_TRUE(fault("THIRTEEN LONG").contains("part: the text has 13 characters, 0 to 12")) << fault("THIRTEEN LONG");
  EXPECT_TRUE(
      faults_of(with("param part text \"A\" count 1..9\n", "  cut x part\n"), "fanuc").contains("part is a text"));
  EXPECT_TRUE(
      faults_of(with("param part text \"AB\" count 3..9\n", ""), "fanuc").contains("the default has 2 characters"));
}

// What only some controls show is refused where it would be shown as something else.
TEST(FamilyTexts, AControlThatDoesNotShowACharacterRefusesIt) {
  const Values values = {{"part", "HUB_(4)"}};
  EXPECT_EQ(faults_of(kNamed, "sinumerik-840d", values), "");
  for (const char* dialect : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const std::string fault = faults_of(kNamed, dialect, values);
    EXPECT_TRUE(fault.contains("the character '_' of the text part")) << fault;
  }
}

const text::Source kPoints = with(
    "param corners list of points x y (0 mm, 0 mm), (40 mm, 5 mm), (1 in, 20 mm) x in 0..100 y in -50..50 "
    "count 2..6 \"of the contour\"\n",
    "  for n from 0 to count(corners) - 1 step 1\n    cut x corners.x[n]  y corners.y[n]\n  end\n");

std::vector<std::pair<double, double>> corners(const Values& values) {
  std::vector<std::pair<double, double>> out;
  for (const ir::Motion& one : one_trace(kPoints, values)) out.emplace_back(one.end[0], one.end[1]);
  return out;
}

TEST(FamilyPoints, AreListsOfTheirAxes) {
  using Points = std::vector<std::pair<double, double>>;
  EXPECT_EQ(corners({}), (Points{{0, 0}, {40, 5}, {25.4, 20}}));
  EXPECT_EQ(corners({{"corners", "(1 mm, 2 mm),(3 mm,-4 mm) , (5 mm, 6 mm), (7 mm, 0.25 in)"}}),
            (Points{{1, 2}, {3, -4}, {5, 6}, {7, 6.35}}));
  EXPECT_EQ(corners({{"corners.y", "1 mm, 2 mm, 3 mm"}}), (Points{{0, 1}, {40, 2}, {25.4, 3}}));
}

TEST(FamilyPoints, FaultsNameTheParameter) {
  const auto fault = [](const char* name, const char* value) { return faults_of(kPoints, "fanuc", {{name, value}}); };
  EXPECT_TRUE(fault("corners", "(1 mm, 2 mm), (3 mm)").contains("corners: '(1 mm, 2 mm), (3 mm)' are not points of 2"));
  EXPECT_TRUE(fault("corners", "(1 mm, 2 mm),").contains("such as (0 mm, 0 mm)"));
  EXPECT_TRUE(fault("corners", "").contains("are not points"));
  EXPECT_TRUE(fault("corners", "(1 mm, 2 mm), (3, 4 mm)").contains("corners.x"));
  EXPECT_TRUE(fault("corners", "(1 mm, 2 mm), (3 mm, 51 mm)").contains("corners.y"));
  EXPECT_TRUE(fault("corners", "(1 mm, 2 mm)").contains("corners.x has 1 numbers, 2 to 6"));
  EXPECT_TRUE(fault("corners.x", "1 mm, 2 mm").contains("corners.x has 2 numbers and corners.y has 3"));
  EXPECT_TRUE(faults_of(kPoints, "fanuc", {{"corners", "(1 mm, 2 mm), (3 mm, 4 mm)"}, {"corners.x", "1 mm, 2 mm"}})
                  .contains("corners.x"));
  EXPECT_TRUE(faults_of(with("param p list of points x y (0 mm, 0 mm) in 0..9 count 1..2\n", "  cut x p\n"), "fanuc")
                  .contains("p.x[0]"));
  EXPECT_TRUE(faults_of(with("param p list of points x a (0 mm, 0 mm) in 0..9 count 1..2\n", ""), "fanuc")
                  .contains("x y, x z, y z or x y z"));
  EXPECT_TRUE(faults_of(with("param p list of points x y (0 mm, 10 mm) in 0..9 count 1..2\n", ""), "fanuc")
                  .contains("outside"));
}

TEST(FamilyPoints, ComeFromATable) {
  const text::Source table("t.csv", "y mm, x [in]\n1, 2\n3, 1 mm\n");
  EXPECT_EQ(list_of_column(table, "", kPoints, "corners").value, "(2 in, 1 mm), (1 mm, 3 mm)");
  EXPECT_EQ(list_of_column(table, "x", kPoints, "corners.x").value, "2 in, 1 mm");
  const TableColumn wrong = list_of_column({"t.csv", "x mm,y mm\n1,2\n3,60\n"}, "", kPoints, "corners");
  EXPECT_TRUE(messages_of(wrong.diagnostics, table).contains("corners.y"));
  EXPECT_TRUE(wrong.value.empty());
}

const text::Source kSkips =
    with("param far length 30 mm in 1..99\n",
         "  rapid x 0 mm  y 0 mm  z 5 mm\n  skip cut x 10 mm\n  cut x min(far, 20 mm)  y 5 mm\n  skip 2 coolant flood\n"
         "  skip 3 rapid y 50 mm\n  rapid x 0 mm\n  skip message \"OPTION\"\n  skip optional stop\n  cut y 1 mm\n");

TEST(FamilySkips, StandInTheOutputOfEveryControl) {
  for (const std::string& dialect : dialect_names()) {
    for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
      const RenderResult made = rendered(kSkips, dialect, mode, {});
      EXPECT_TRUE(made.diagnostics.empty()) << messages_of(made.diagnostics, kSkips);
      const bool sinumerik = dialect.starts_with("sinumerik");
      if (dialect != "sinumerik-840d" && dialect != "fanuc") continue;
      const std::vector<std::string> fanuc = {"\n/G01 X10.", "\n/2 M08\n", "\n/3 G00", "\n/(OPTION)\n", "\n/M01\n"};
      const std::vector<std::string> own = {"\n/ G1 X10", "\n/1 M8\n", "\n/2 G0", "\n/ MSG(\"OPTION\")\n", "\n/ M1\n"};
      for (const std::string& block : sinumerik ? own : fanuc)
        EXPECT_TRUE(made.text.contains(block)) << block << " of " << dialect << "\n" << made.text;
    }
  }
}

// Whatever the operator switches, both forms move alike on every control.
TEST(FamilySkips, EverySwitchIsOneTrace) {
  EXPECT_EQ(one_trace(kSkips).size(), 6U);
  for (const std::uint32_t switches : {1U << 1, 1U << 2, 1U << 3, 7U << 1}) {
    std::vector<ir::Motion> first;
    for (const std::string& dialect : dialect_names()) {
      for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
        const ir::Control machine = control(dialect, ir::MachineKind::mill);
        const std::string text = rendered(kSkips, dialect, mode, {}).text;
        const ir::ReadResult read = find_dialect(dialect)->read(text::Source("skip.nc", text), machine);
        Motions motions;
        interpreter::RunOptions options;
        options.skip_switches = switches;
        EXPECT_EQ(execute(read.program, machine, nullptr, motions, options).ended, interpreter::Ended::end);
        const std::vector<ir::Motion> moves = moves_of(motions.all);
        if (first.empty()) first = moves;
        expect_same(first, moves, kTolerance, dialect + " " + std::string(name_of(mode)) + "\n" + text);
      }
    }
    EXPECT_EQ(first.size(), (switches >> 1 & 1U) != 0 && (switches >> 3 & 1U) != 0 ? 4U
                            : switches == 1U << 2                                  ? 6U
                                                                                   : 5U);
  }
}

TEST(FamilySkips, FaultsNameWhatIsWrong) {
  const auto fault = [](const char* steps) { return faults_of(with("", steps), "fanuc"); };
  EXPECT_TRUE(fault("  skip 9 cut x 1 mm\n").contains("levels 1 to 8"));
  EXPECT_TRUE(fault("  skip feed 5 mm/min\n").contains("what may be skipped"));
  EXPECT_TRUE(fault("  skip ct x 1 mm\n").contains("did you mean cut?"));
  EXPECT_TRUE(fault("  compensate left\n  skip cut x 1 mm\n").contains("not skipped"));
  EXPECT_TRUE(fault("  drill from 1 mm to 0 mm\n    skip at x 1 mm\n  end\n").contains("among holes"));
}

}  // namespace
}  // namespace dripfeed::compile::test

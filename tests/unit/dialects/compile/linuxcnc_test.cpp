// LinuxCNC's language: what a program in it does, written out. Whole programs against LinuxCNC itself:
// tests/bench/linuxcnc_tests.py and rs274_compare.py.
#include <algorithm>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/readers.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

ir::Control linuxcnc() { return find_reader("linuxcnc")->control(ir::MachineKind::mill, ir::GSystem::a); }

struct Ran {
  std::string trace;  // without lines; words of axes that stay at 0 left out
  std::string not_interpreted;
  interpreter::Ended ended = interpreter::Ended::end;
};

std::string without_zeros(std::string line) {
  for (std::size_t at = line.find(" 0.0000"); at != std::string::npos; at = line.find(" 0.0000")) line.erase(at, 7);
  for (const char axis : {'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W'}) {
    const std::string zero = std::string(" ") + axis + "0.0000";
    if (const std::size_t at = line.find(zero); at != std::string::npos) line.erase(at, zero.size());
  }
  return line;
}

Ran run(const std::string& text, ProgramLibrary* library = nullptr) {
  const ir::Control on = linuxcnc();
  const text::Source source("program", text);
  const ir::ReadResult read = find_reader("linuxcnc")->read(source, on);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << messages_of(read.diagnostics, source) << text;
  EXPECT_EQ(ir::print_same(read.program), text);
  interpreter::RunNames names;
  interpreter::TraceWriter writer(on, names);
  interpreter::RunOptions options;
  options.names = &names;
  ProgramLibrary none(on, [](std::string_view) { return std::nullopt; });
  const interpreter::RunResult result =
      execute(read.program, on, library == nullptr ? &none : library, writer, options);
  Ran out{.trace = {}, .not_interpreted = {}, .ended = result.ended};
  for (const auto& one : result.not_interpreted)
    if (!one.effects_known) out.not_interpreted += one.name + ";";
  std::istringstream lines(writer.text());
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('@') && !line.contains(':')) continue;
    out.trace += without_zeros(line.substr(line.find(' ') + 1)) + "\n";
  }
  return out;
}

// The rapid moves of a program are the values of X that it names.
std::string values(const std::string& text) {
  std::string out;
  std::istringstream lines(run(text + "\nm2\n").trace);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("rapid X")) out += line.substr(7) + " ";
  return out;
}

bool is_refused(const std::string& text) {
  const text::Source source("program", text);
  return text::has_error(find_reader("linuxcnc")->read(source, linuxcnc()).diagnostics);
}

TEST(LinuxCnc, RanksOperatorsAsItsManualDoes) {
  EXPECT_EQ(values("g0 x[2+3*4]\nx[2*3**2]\nx[8/4/2]\nx[1+2 gt 2]\nx[1 gt 2 or 2 gt 1]\nx-[1]"),
            "14.0000 18.0000 1.0000 1.0000 1.0000 -1.0000 ");
  EXPECT_EQ(values("g0 x[[1 eq 0] xor 1]\nx[2 and 4]"), "1.0000 1.0000 ");
}

TEST(LinuxCnc, CalculatesAsItsInterpreterDoes) {
  EXPECT_EQ(values("g0 x[-7 mod 3]\nx fix[-1.5]\nxfup[-1.5]\nxround[2.5]\nxatan[-1]/[1]\nxasin[-1]"),
            "2.0000 -2.0000 -1.0000 3.0000 -45.0000 -90.0000 ");
  EXPECT_EQ(
      values("g0 x[1 eq 1.00009]\nx[[1 eq 1.0002]+3]\nx[[1 ne 1.00009]+4]\nx[[1.00005 le 1]+5]\nx[[1 ge 1.0002]+6]"),
      "1.0000 3.0000 4.0000 6.0000 6.0000 ");
}

TEST(LinuxCnc, ReadsSmallLettersAndBlanksAnywhere) {
  EXPECT_EQ(values("G 0 X 1 . 5 (a comment) Y0 ; X99\n  N 1.5 # < A b > = 3\nx #<aB>"), "1.5000 3.0000 ");
}

// "Parameters are set after all values of the line are known" (user manual, order of execution).
TEST(LinuxCnc, ReadsAllValuesOfALineBeforeItSetsAny) {
  EXPECT_EQ(values("#1=1 #2=2\n#1=#2 #2=#1\ng0 x#1\nx#2 #2=7\nx#2"), "2.0000 1.0000 7.0000 ");
  EXPECT_EQ(values("#1=3 #3=5\ng0 x##1"), "5.0000 ");
}

TEST(LinuxCnc, RunsEveryStructure) {
  EXPECT_EQ(values("g0\n#1=0\no1 while [#1 lt 4]\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\no2 elseif [#1 eq 4]\n"
                   "o1 break\no2 else\nx#1\no2 endif\no1 endwhile\nx9"),
            "1.0000 3.0000 9.0000 ");
  EXPECT_EQ(values("g0\n#1=0\no1 do\n#1=[#1+1]\nx#1\no1 while [#1 lt 3]"), "1.0000 2.0000 3.0000 ");
  EXPECT_EQ(values("g0\n#1=0\no<a b> repeat [2.6]\n#1=[#1+1]\nx#1\no<AB> endrepeat"), "1.0000 2.0000 3.0000 ");
}

TEST(LinuxCnc, CallsWithOwnParametersAndGivesBackValues) {
  const std::string sub = "o100 sub\no1 if [#1 gt 5]\no100 return [#1*2]\no1 endif\n#1=99\n#<own>=1\no100 endsub\n";
  EXPECT_EQ(values(sub + "g0\n#1=7 #<own>=4\no100 call [#1] [1]\nx#<_value>\nx[#<_value_returned>+1]\n"
                         "o100 call [1]\nx[#<_value>+#<_value_returned>+3]\nx#1\nx#<own>"),
            "14.0000 2.0000 3.0000 7.0000 4.0000 ");
  // Where its lines stand does not matter, nor whether its number is computed; what is not given is 0.
  EXPECT_EQ(values("g0\n#<n>=20\no[#<n>] call [1] [2] [3] [4] [5]\nm2\no20 sub\nx[#1+#5]\nx[#6+1]\no20 endsub"),
            "6.0000 1.0000 ");
}

TEST(LinuxCnc, CallsProgramsByFile) {
  ProgramLibrary files(linuxcnc(), [](std::string_view name) -> std::optional<text::Source> {
    if (name != "slot") return std::nullopt;
    return text::Source("slot.ngc",
                        "o<slot> sub\no<deep> call [#1+1]\no<slot> endsub\no<deep> sub\ng0x#1\no<deep> endsub\nm2\n");
  });
  EXPECT_EQ(run("o<SLOT> call [3]\nm2\n", &files).trace, "rapid X4.0000\nend\n");
}

TEST(LinuxCnc, CallsNumberedProgramsAsItsRelativesDo) {
  EXPECT_EQ(values("o1\ng0\n#1=1\nm98 p200 l2\nx#1\nm30\no200\n#1=[#1+1]\nm99"), "3.0000 ");
}

TEST(LinuxCnc, KnowsWhatExists) {
  EXPECT_EQ(values("g0 x[1+exists[#<a>]]\n#<a>=0\nx[1+exists[#<a>]]\nx[1+exists[#5601]]\nx[1+exists[#5602]]\n"
                   "x[1+exists[#<_x>]]"),
            "1.0000 2.0000 2.0000 1.0000 2.0000 ");
}

TEST(LinuxCnc, ReportsItsMessages) {
  EXPECT_EQ(run("#<a>=2.5\n( Debug , a is #<a>, 3 is #1)\n(MSG, #<a>)\nm2\n").trace,
            "message \" a is 2.5, 3 is 0\"\nmessage \" #<a>\"\nend\n");
}

TEST(LinuxCnc, CountsDwellsInSecondsAndTurnsByP) {
  EXPECT_EQ(run("g4 p1.5\nm2\n").trace, "dwell P1.5000\nend\n");
  EXPECT_EQ(run("g4 p1 g0 x1 s500 m3\nm2\n").trace, "spindle cw S500.0000/rpm\ndwell P1.0000\nrapid X1.0000\nend\n");
  const std::string twice = run("g0 x1\ng3 x1 i-1 z4 p2 f100\nm2\n").trace;
  EXPECT_EQ(std::ranges::count(twice, 'a' /* of arc-ccw, rapid */), 3);
  EXPECT_NE(twice.find("Z2.0000"), std::string::npos) << twice;
}

TEST(LinuxCnc, TakesCentersAsPositions) {
  EXPECT_EQ(run("g0 x2\ng90.1\ng3 x0 y2 i0 j0 f100\nm2\n").trace, run("g0 x2\ng3 x0 y2 i-2 j0 f100\nm2\n").trace);
}

TEST(LinuxCnc, SaysWhatItDoesNotInterpret) {
  for (const char* line :
       {"g10 l20 p1 x0", "g10 l2 p1 r45", "m73", "g5.2 x1 y1 p1", "g33.1 z-5 k1", "g76 p1 z-5 i-1 j1 k2 r1"})
    EXPECT_NE(run(std::string("g0 x1 y1\nf100\n") + line + "\nm2\n").not_interpreted, "") << line;
  EXPECT_EQ(run("g0 x[#<_metric>]\nm2\n").not_interpreted, "#<_metric>;");
  EXPECT_EQ(run("g64 p0.01\nm48\ng90.1\nm70\nm2\n").not_interpreted, "");
}

TEST(LinuxCnc, RefusesWhatItsInterpreterRefuses) {
  for (const char* text :
       {"o1 sub\no2 sub\no2 endsub\no1 endsub\nm2\n", "o1 if [1]\nm2\n", "o1 endwhile\nm2\n", "g0 x\nm2\n", "#1\nm2\n",
        "#5602=1\nm2\n", "g0 x[1\nm2\n", "x1 @\n#=1\nm2\n", "g0 x exists[1]\nm2\n", "g12 x1\nm2\n",
        "o1 repeat [2]\no1 break\no1 endrepeat\nm2\n", "(open\nm2\n"})
    EXPECT_TRUE(is_refused(text)) << text;
  EXPECT_EQ(run("g0 x[1/0]\nm2\n").ended, interpreter::Ended::alarm);
}

TEST(LinuxCnc, IsReadAndNotWritten) {
  EXPECT_EQ(find_dialect("linuxcnc"), nullptr);
  EXPECT_TRUE(std::ranges::none_of(dialects(), [](const Dialect& d) { return d.print == nullptr; }));
  ConvertRequest request;
  request.source = text::Source("program", "g0 x1\nm2\n");
  request.from = linuxcnc();
  request.to = control("fanuc", ir::MachineKind::mill);
  EXPECT_TRUE(text::has_error(convert(request).diagnostics));
  std::swap(request.from, request.to);
  EXPECT_TRUE(text::has_error(convert(request).diagnostics));
}

}  // namespace
}  // namespace dripfeed::compile::test

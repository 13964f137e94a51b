// A value that the program takes must still be there when the program reads it: what may set the variable otherwise
// than by its name is refused, and what no one can see is a warning.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/compile/native/native_mention.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

std::vector<text::Diagnostic> found_in(const std::string& target, const std::string& dialect, ir::MachineKind kind,
                                       const std::string& native) {
  const std::string machine = kind == ir::MachineKind::mill ? "mill" : "lathe, x is diameter";
  RenderRequest request;
  request.family = text::Source("f", "family holder\nmachine " + machine + "\nparam size ratio 5 in 0..100 is " +
                                         target + "\nnative " + dialect + "\n" + native);
  request.target = control(dialect, kind);
  return render(request).diagnostics;
}

// Errors and warnings, one a line.
std::string messages_by(const std::vector<text::Diagnostic>& found) {
  std::string out;
  for (const text::Diagnostic& one : found)
    out.append(one.severity == text::Severity::error ? "error: " : "warning: ").append(text::message_of(one)) += "\n";
  return out;
}

std::string mill(const std::string& target, const std::string& native) {
  return messages_by(found_in(target, "fanuc", ir::MachineKind::mill, native));
}

std::string turn(const std::string& target, const std::string& native) {
  return messages_by(found_in(target, "sinumerik-840d", ir::MachineKind::lathe, native));
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(WrappedOverwrites, ComputedNumbersOfTheBankMaySetIt) {
  EXPECT_EQ(mill("#100", "#100=5.\n#501=100\n#[#501]=7.\nG1X#100\nM30\n"),
            "error: #100 does not take the value: line 3 of the native program may set it before it is read, by a "
            "computed number or a text that is executed\n");
  EXPECT_TRUE(has(turn("R1", "R1=5 R2=1\nR[R2]=7\nG1 X=R1\nM30\n"), "error: R1 does not take the value: line 2"));
  // Through a jump back, and in a program that is called.
  EXPECT_TRUE(has(mill("#100", "#100=5.\nN1X#100\n#[#501]=7.\nIF[#1EQ0]GOTO1\nM30\n"), "error: "));
  EXPECT_TRUE(has(mill("#100", "O1\n#100=5.\nM98P2\nX#100\nM30\nO2\n#[#501]=7.\nM99\n"), "line 7 of the native"));
  // Read in the called program alone, after it came back from another one.
  EXPECT_TRUE(has(mill("#100", "O1\n#100=5.\nM98P2\nM98P3\nM30\nO2\n#[#501]=7.\nM99\nO3\nX#100\nM99\n"), "error: "));
  // For others to read.
  EXPECT_TRUE(has(mill("#100", "#100=5.\n#[#501]=7.\nM30\n"), "error: "));
}

TEST(WrappedOverwrites, ComputedNumbersBeforeItOrAfterTheLastReadAreFine) {
  EXPECT_EQ(mill("#100", "#[#501]=7.\n#100=5.\nG1X#100\nM30\n"), "");
  EXPECT_EQ(mill("#100", "#100=5.\nG1X#100\n#[#501]=7.\nM30\n"), "");
  // The loop sets it again each time.
  EXPECT_EQ(mill("#100", "N1#100=5.\nG1X#100\n#[#501]=7.\nIF[#1EQ0]GOTO1\nM30\n"), "");
  EXPECT_EQ(mill("#100", "#100=5.\n#[501]=7.\nG1X#100\nM30\n"), "");
  EXPECT_EQ(turn("DIA", "DEF REAL DIA=5\nR[R2]=7\nG1 X=DIA\nM30\n"), "");
}

TEST(WrappedOverwrites, ExecutedTextsMaySetIt) {
  for (const char* text : {"\"R1=7\"", "\"r1 = 7\"", "\"R[1]=7\"", "\"R[R2]=7\"", "\"R\"<<R2<<\"=7\""})
    EXPECT_TRUE(has(turn("R1", std::string("R1=5\nEXECSTRING(") + text + ")\nG1 X=R1\nM30\n"), "error: R1 does not"))
        << text;
  for (const char* text : {"\"R10=7\"", "\"M8\"", "\"G1 X=R1\""})
    EXPECT_EQ(turn("R1", std::string("R1=5\nEXECSTRING(") + text + ")\nG1 X=R1\nM30\n"), "") << text;
  EXPECT_TRUE(has(turn("R1", "R1=5\nEXECSTRING(\"L100\")\nG1 X=R1\nM30\n"), "warning: R1 may lose the value"));
}

TEST(WrappedOverwrites, SynchronizedActionsSetItAtAnyTime) {
  for (const char* action : {"ID=1 WHENEVER TRUE DO R1=7", "IDS=2 EVERY $AA_IW[X]>5 DO $R1=7",
                             "WHEN $AA_IW[X]>5 DO $R[1]=7 M8", "ID=1 DO $R[$AC_MARKER[1]]=7"}) {
    EXPECT_TRUE(has(turn("R1", std::string(action) + "\nR1=5\nG1 X=R1\nM30\n"),
                    "error: R1 does not take the value: line 1 of the native program may set it at any time"))
        << action << turn("R1", std::string(action) + "\nR1=5\nG1 X=R1\nM30\n");
  }
  for (const char* action : {"ID=1 WHENEVER $R1==7 DO M8", "ID=1 WHENEVER TRUE DO $R10=7"})
    EXPECT_EQ(turn("R1", std::string("R1=5\n") + action + "\nG1 X=R1\nM30\n"), "") << action;
}

TEST(WrappedOverwrites, AParameterIsReadBeforeItsProgramSetsIt) {
  const auto native = [](const std::string& body) {
    return "%_N_MAIN_MPF\nEXTERN SUBP(REAL)\nG71\nSUBP(5)\nM30\n%_N_SUBP_SPF\nPROC SUBP(REAL A1)\n" + body + "M17\n";
  };
  EXPECT_EQ(turn("SUBP.A1", native("A1=3\nG1 X=A1\n")),
            "error: SUBP.A1 does not take the value: line 8 of the native program may set it before the called program "
            "reads it\n");
  EXPECT_TRUE(has(turn("SUBP.A1", native("IF R1==2\nA1=3\nENDIF\nG1 X=A1\n")), "error: "));
  EXPECT_TRUE(has(turn("SUBP.A1", native("EXECSTRING(\"A1=3\")\nG1 X=A1\n")), "error: "));
  for (const char* body : {"A1=A1/2\nG1 X=A1\n", "IF A1<2\nA1=2\nENDIF\nG1 X=A1\n", "G1 X=A1\nA1=3\nG1 Z=A1\n"})
    EXPECT_EQ(turn("SUBP.A1", native(body)), "") << body;
}

TEST(WrappedOverwrites, ProgramsThatAreNotHereAreAWarning) {
  EXPECT_EQ(mill("#100", "#100=5.\nM98P2\nG65P9010A1.\nG65P9010A2.\nG1X#100\nM30\n"),
            "warning: #100 may lose the value: programs that the native text does not hold may set it before it is "
            "read: O0002 (line 2), O9010 (lines 3 and 4)\n");
  EXPECT_TRUE(has(turn("R1", "R1=5\nL100\nG1 X=R1\nM30\n"), "warning: R1 may lose the value"));
  EXPECT_TRUE(has(turn("R1", "R1=5\nGROOVE(1)\nG1 X=R1\nM30\n"), "GROOVE (line 2)"));
  EXPECT_EQ(mill("#100", "M98P2\n#100=5.\nG1X#100\nM98P2\nM30\n"), "");
  EXPECT_EQ(mill("#1", "#1=5.\nG65P9010A1.\nG1X#1\nM30\n"), "");
  EXPECT_TRUE(has(mill("#1", "#1=5.\nM98P2\nG1X#1\nM30\n"), "warning: #1 may lose the value"));
  EXPECT_EQ(turn("DIA", "DEF REAL DIA=5\nGROOVE(1)\nG1 X=DIA\nM30\n"), "");
  // The program is here.
  EXPECT_EQ(mill("#100", "O1\n#100=5.\nM98P2\nG1X#100\nM30\nO2\nG0Z1.\nM99\n"), "");
}

// READ(VAR INT error, ...): what a procedure of the control leaves in its argument.
TEST(WrappedOverwrites, ProceduresGiveBackValues) {
  for (const char* line : {"READ(R1,\"_N_F_MPF\",1,1,TXT)", "N20 read ( R[1] , \"F\",1,1,TXT)",
                           "FILEDATE(R1,\"F\",TXT)", "WRITE(R1,\"F\",\"SIZE\")"}) {
    const std::string text = std::string("DEF STRING[20] TXT\nR1=5\n") + line + "\nG1 X=R1\nM30\n";
    EXPECT_EQ(turn("R1", text),
              "error: R1 does not take the value: line 3 of the native program may set it before it is read: a "
              "procedure gives back values in its arguments\n")
        << line;
  }
  for (const char* line : {"READ(R10,\"F\",1,1,TXT)", "READ(R10,\"F\",R1,1,TXT)", "WRITE(R10,\"F\",\"R1\")",
                           "READ(R10,\"F\",R1+1,1,TXT)"}) {
    const std::string text = std::string("DEF STRING[20] TXT\nR1=5\n") + line + "\nG1 X=R1\nM30\n";
    EXPECT_EQ(turn("R1", text), "") << line;
  }
  EXPECT_EQ(turn("R1", "DEF STRING[20] TXT\nR1=5\nG1 X=R1\nREAD(R1,\"F\",1,1,TXT)\nM30\n"), "");
}

TEST(WrappedOverwrites, AProgramThatIsNotHereMayGiveBackItsArguments) {
  const auto native = [](const std::string& external, const std::string& call) {
    return external + "DEF REAL DIA=5\n" + call + "\nG1 X=DIA\nM30\n";
  };
  EXPECT_EQ(
      turn("DIA", native("EXTERN GROOVE(REAL, VAR REAL)\n", "GROOVE(1,DIA)")),
      "error: DIA does not take the value: line 3 of the native program may set it before it is read: a procedure "
      "gives back values in its arguments\n");
  EXPECT_TRUE(has(turn("R1", "EXTERN GROOVE(VAR REAL)\nR1=5\nGROOVE(R1)\nG1 X=R1\nM30\n"), "error: R1 does not"));
  EXPECT_TRUE(has(turn("DIA", native("", "GROOVE(1,DIA)")), "warning: DIA may lose the value"));
  EXPECT_EQ(turn("DIA", native("EXTERN GROOVE(REAL, VAR REAL)\n", "GROOVE(DIA,R1)")), "");
  EXPECT_EQ(turn("DIA", native("EXTERN GROOVE(REAL, REAL)\n", "GROOVE(1,DIA)")), "");
  EXPECT_EQ(turn("DIA", native("", "GROOVE(1,DIA+0)")), "");
}

TEST(WrappedOverwrites, VariablesOfOtherProgramsAreOthers) {
  const std::string two =
      "%_N_MAIN_MPF\nEXTERN SUBP\nDEF REAL A1=5\nSUBP\nG1 X=A1\nM30\n%_N_SUBP_SPF\nPROC SUBP\n"
      "DEF REAL A1=7\nG1 X=A1\nA1=8\nM17\n";
  EXPECT_EQ(turn("A1", two), "");
  EXPECT_EQ(mill("#1", "O1\n#1=5.\nG65P2\nG1X#1\nM30\nO2\n#1=7.\nG1X#1\nM99\n"), "");
  EXPECT_TRUE(has(mill("#1", "O1\n#1=5.\nM98P2\nG1X#1\nM30\nO2\n#1=7.\nG1X#1\nM99\n"), "set in lines 2 and 7"));
  EXPECT_TRUE(has(turn("R1", "%_N_MAIN_MPF\nR1=5\nSUBP\nM30\n%_N_SUBP_SPF\nR1=7\nM17\n"), "set in lines 2 and 6"));
}

TEST(WrappedOverwrites, TheDoubtIsShownWhereItStands) {
  const std::vector<text::Diagnostic> found =
      found_in("#100", "fanuc", ir::MachineKind::mill, "#100=5.\nM98P2\nG1X#100\nM30\n");
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].notes.size(), 1U);
  EXPECT_EQ(found[0].notes[0].text, "it may be set here");
}

TEST(NativeMention, NamesAreWhole) {
  EXPECT_EQ(mention_of("DO R1=7", "R1"), Mention::sets);
  EXPECT_EQ(mention_of("WHEN R1==7", "R1"), Mention::reads);
  EXPECT_EQ(mention_of("DO R10=7 R1_X=3 AR1=2", "R1"), Mention::none);
  EXPECT_EQ(mention_of("X#100#1000=5", "#100"), Mention::reads);
  EXPECT_EQ(mention_of("#[100]=5", "#100"), Mention::sets);
  EXPECT_EQ(mention_of("R[2]=R[1]", "R1"), Mention::reads);
  EXPECT_EQ(mention_of("dia = 5", "DIA"), Mention::sets);
}

}  // namespace
}  // namespace dripfeed::compile::test

// The unit of a value is that of the words that read it; one number for two units is refused.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

RenderResult set(const std::string& parameter, const std::string& value, const std::string& dialect,
                 const std::string& native) {
  RenderRequest request;
  request.family =
      text::Source("f", "family holder\nmachine mill\nparam size " + parameter + "\nnative " + dialect + "\n" + native);
  request.values = {{"size", value}};
  request.target = control(dialect, ir::MachineKind::mill);
  return render(request);
}

std::string fault(const std::string& parameter, const std::string& dialect, const std::string& native) {
  const std::string value = parameter.starts_with("length") ? "50.8 mm"
                            : parameter.contains("rev")     ? "1 mm/rev"
                                                            : "50.8 mm/min";
  std::string out;
  for (const text::Diagnostic& one : set(parameter, value, dialect, native).diagnostics)
    out.append(text::message_of(one)) += "\n";
  return out;
}

// The number that the first line sets.
std::string written(const std::string& native, const std::string& dialect = "fanuc",
                    const std::string& parameter = "length 80 mm in 0..900 is #100") {
  const RenderResult result = set(parameter, "50.8 mm", dialect, native);
  std::string out;
  for (const text::Diagnostic& one : result.diagnostics) out.append(text::message_of(one)) += "\n";
  const std::size_t at = result.text.find("=");
  return at == std::string::npos ? out : result.text.substr(at + 1, result.text.find('\n', at) - at - 1) + out;
}

const std::string kLength = "length 80 mm in 0..900 is #100";
const std::string kFeed = "feed 250 mm/min in 0..900 is #100";
const std::string kTurnFeed = "feed 0.1 mm/rev in 0..900 is #100";

TEST(WrappedUnits, TheAssignmentAndTheReadHaveOne) {
  EXPECT_EQ(fault(kLength, "fanuc", "G20\n#100=80.\nG21\nG1X#100F9\nM30\n"),
            "#100 does not take the value: line 2 of the native program sets it in inches, and line 4 of the native "
            "program reads it in millimetres\n");
  EXPECT_NE(fault(kFeed, "fanuc", "G94G20\n#100=250.\nG21\nG1X1.F#100\nM30\n"), "");
  // In the block of the code, through another variable, as a radius and a centre.
  for (const char* read : {"G21G1X#100F9\n", "#101=#100/2\nG21\nG1X#101F9\n", "G21\nG1X1.F9\nG2X5.R#100\n",
                           "G21\nG1X1.F9\nG2X5.I[-#100]\n"})
    EXPECT_NE(fault(kLength, "fanuc", std::string("G20\n#100=80.\n") + read + "M30\n"), "") << read;
  // What changes the unit itself.
  EXPECT_EQ(fault(kLength, "fanuc", "G20\n#100=80.\n#101=#100*25.4\nG21\nG1X#101F9\nM30\n"), "");
}

TEST(WrappedUnits, ReadsHaveOneAmongEachOther) {
  EXPECT_EQ(fault(kLength, "fanuc", "#100=80.\nG20\nG0X#100\nG21\nG0X#100\nM30\n"),
            "#100 does not take the value: it is read in inches in line 3 of the native program and in millimetres in "
            "line 5 of the native program\n");
  EXPECT_NE(fault(kLength, "fanuc", "#100=80.\nIF[#1EQ0]GOTO1\nG20\nGOTO2\nN1G21\nN2G0X#100\nM30\n")
                .find("by the path that leads there"),
            std::string::npos);
}

TEST(WrappedUnits, TheReadsUnitIsWritten) {
  EXPECT_EQ(written("#100=80.\nG20\nG0X#100\nG21\nG0X1.\nM30\n"), "2.");
  EXPECT_EQ(written("#100=80.\nG21\nG0X#100\nG20\nG0X1.\nM30\n"), "50.8");
  EXPECT_EQ(written("#100=80.\nG20\nM98P7\nG0X#100\nM30\n").substr(0, 2), "2.");
}

TEST(WrappedUnits, CalledProgramsCountAsFarAsTheyStateIt) {
  const auto native = [](const std::string& body) {
    return "%_N_MAIN_MPF\nEXTERN SUBP(REAL)\nG700\nSUBP(80)\nM30\n%_N_SUBP_SPF\nPROC SUBP(REAL A1)\n" + body + "M17\n";
  };
  const std::string target = "length 80 mm in 0..900 is SUBP.A1";
  EXPECT_NE(fault(target, "sinumerik-840d", native("G710\nG0 X=A1\n")), "");
  EXPECT_EQ(fault(target, "sinumerik-840d", native("G0 X=A1\n")), "");
  EXPECT_NE(fault(kLength, "fanuc", "O1\nG20\n#100=80.\nM98P2\nM30\nO2\nG21\nG0X#100\nM99\n"), "");
  EXPECT_EQ(fault(kLength, "fanuc", "O1\nG20\n#100=80.\nM98P2\nM30\nO2\nG0X#100\nM99\n"), "");
  EXPECT_NE(fault("length 80 mm in 0..900 is R1", "sinumerik-840d",
                  "%_N_MAIN_MPF\nG700\nR1=80\nSUBP(R1)\nM30\n%_N_SUBP_SPF\nPROC SUBP(REAL A1)\nG710\nG0 X=A1\nM17\n"),
            "");
  // #1 of a macro is another variable.
  EXPECT_EQ(
      fault("length 80 mm in 0..900 is #1", "fanuc", "O1\nG20\n#1=80.\nG0X#1\nG65P2A3.\nM30\nO2\nG21\nG0X#1\nM99\n"),
      "");
}

TEST(WrappedUnits, FeedsAreReadInTheirMode) {
  EXPECT_EQ(
      fault(kFeed, "fanuc", "G21G95\n#100=250.\nG1X1.F#100\nM30\n"),
      "#100 does not take the value: it is a feed per minute, and line 3 of the native program reads it as a feed "
      "per revolution\n");
  EXPECT_NE(fault(kTurnFeed, "fanuc", "G21G94\n#100=.1\nG1X1.F#100\nM30\n"), "");
  EXPECT_EQ(fault(kFeed, "fanuc", "G21G94\n#100=250.\nG1X1.F#100\nM30\n"), "");
  EXPECT_EQ(fault(kTurnFeed, "fanuc", "G21G95\n#100=.1\nG1X1.F#100\nM30\n"), "");
  // Not stated.
  EXPECT_EQ(fault(kFeed, "fanuc", "G21\n#100=250.\nG1X1.F#100\nM30\n"), "");
}

}  // namespace
}  // namespace dripfeed::compile::test

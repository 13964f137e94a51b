// What a Haas reads differently from its relatives: the same moves as the common form, and back again.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

ir::Control haas(ir::MachineKind kind = ir::MachineKind::mill) { return control("haas", kind); }

std::string trace_of(const std::string& text, const ir::Control& on) {
  const text::Source source("program", text);
  const ir::ReadResult read = find_dialect(on.dialect)->read(source, on);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << messages_of(read.diagnostics, source);
  interpreter::RunNames names;
  interpreter::TraceWriter writer(on, names);
  interpreter::RunOptions options;
  options.names = &names;
  ProgramLibrary none(on, [](std::string_view) { return std::nullopt; });
  const interpreter::RunResult result = execute(read.program, on, &none, writer, options);
  EXPECT_NE(result.ended, interpreter::Ended::alarm) << text;
  // Without the lines, which differ between forms.
  std::string out;
  std::istringstream lines(writer.text());
  for (std::string line; std::getline(lines, line);) out += line.substr(line.find(' ') + 1) + "\n";
  return out;
}

TEST(Haas, ADwellWithAPointIsInSeconds) {
  const std::string seconds = trace_of("O1\nG04 P1.5\nM30\n", haas());
  EXPECT_EQ(seconds, trace_of("O1\nG04 P1500\nM30\n", haas()));
  EXPECT_EQ(seconds, trace_of("O1\nG04 P1500\nM30\n", control("fanuc", ir::MachineKind::mill)));
  const std::string hole = "G21 G90 G54 G0 X0. Y0. Z10.\nG82 Z-5. R2. F100. ";
  EXPECT_EQ(trace_of("O1\n" + hole + "P0.5\nG80\nM30\n", haas()),
            trace_of("O1\n" + hole + "P500\nG80\nM30\n", control("fanuc", ir::MachineKind::mill)));
}

TEST(Haas, CountsHolesByL) {
  const std::string start = "O1\nG21 G90 G54 G0 X0. Y0. Z10.\n";
  const ir::Control fanuc = control("fanuc", ir::MachineKind::mill);
  EXPECT_EQ(trace_of(start + "G81 Z-5. R2. F100. L0\nG91 X10. L3\nG80\nM30\n", haas()),
            trace_of(start + "G81 Z-5. R2. F100. K0\nG91 X10. K3\nG80\nM30\n", fanuc));
}

// The patterns of a Mitsubishi are the same figures by other numbers.
TEST(Haas, DrillsPatternsAsItsRelatives) {
  const std::string start = "O1\nG21 G90 G54 G0 X0. Y0. Z10.\nG81 Z-5. R2. F100. ";
  const ir::Control other = control("mitsubishi-m80", ir::MachineKind::mill);
  EXPECT_EQ(trace_of(start + "L0\nG70 I20. J15. L6\nG80\nM30\n", haas()),
            trace_of(start + "K0\nG34 I20. J15. K6\nG80\nM30\n", other));
  EXPECT_EQ(trace_of(start + "L0\nG71 I20. J15. K30. L4\nG80\nM30\n", haas()),
            trace_of(start + "K0\nG36 I20. J15. P30. K4\nG80\nM30\n", other));
  EXPECT_EQ(trace_of(start + "L0\nG72 I20. J15. L4\nG80\nM30\n", haas()),
            trace_of(start + "K0\nG35 I20. J15. K4\nG80\nM30\n", other));
}

TEST(Haas, CallsABlockOfItsOwnProgram) {
  const std::string text =
      "O1\nG21 G90 G54 G0 X0. Y0. Z10.\nM97 P100 L2\nG0 X9.\nM30\nN100 G91 G1 X1. F100.\nG90\nM99\n";
  const std::string trace = trace_of(text, haas());
  EXPECT_NE(trace.find("linear X2.0000"), std::string::npos) << trace;
  EXPECT_NE(trace.find("rapid X9.0000"), std::string::npos) << trace;
  // What is in effect in the part and after it is not taken from the text's order.
  const text::Source source("program", text);
  const ir::ReadResult read = find_dialect("haas")->read(source, haas());
  const auto call = std::ranges::find(read.program.statements, ir::StatementKind::call, &ir::Statement::kind);
  ASSERT_NE(call, read.program.statements.end());
}

TEST(Haas, G28AloneIsAllAxes) {
  const std::string trace = trace_of("O1\nG21 G90 G54 G0 X1. Y2. Z3.\nG28\nG91 G1 X1. F100.\nM30\n", haas());
  // Where an increment leads from there is not known, and no intermediate point was passed.
  const text::Source source("program", "O1\nG28\nM30\n");
  const ir::ReadResult read = find_dialect("haas")->read(source, haas());
  ASSERT_EQ(read.program.words.size(), 3U);
  for (const ir::Word& word : read.program.words) EXPECT_EQ(word.mode, ir::WordMode::incremental);
  EXPECT_EQ(trace.find("rapid X0.0000 Y0.0000"), std::string::npos) << trace;
}

TEST(Haas, ExtendedOffsetsHaveTwoNames) {
  EXPECT_EQ(trace_of("O1\nG110\nG0 X1. Y1.\nM30\n", haas()), trace_of("O1\nG154 P1\nG0 X1. Y1.\nM30\n", haas()));
  EXPECT_EQ(trace_of("O1\nG154 P5\nG0 X1. Y1.\nM30\n", haas()),
            trace_of("O1\nG54.1 P5\nG0 X1. Y1.\nM30\n", control("fanuc", ir::MachineKind::mill)));
}

ConvertResult between(const std::string& text, const std::string& from, const std::string& to) {
  return translated(text, from, to);
}

TEST(Haas, IsWrittenInItsOwnForms) {
  const std::string fanuc =
      "O1\nG21 G17 G90 G94 G54.1 P5\nT1 M6\nG0 X0. Y0.\nG43 H1 Z10.\nM3 S500\nG4 P500\nG99 G82 X5. Y5. Z-5. R2. P200 "
      "F100. "
      "K0\nX10.\nG91 X10. K3\nG90 G80\nG28 G91 Z0\nM30\n";
  const ConvertResult result = between(fanuc, "fanuc", "haas");
  EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, text::Source("p", fanuc));
  EXPECT_NE(result.text.find("G154 P5"), std::string::npos) << result.text;
  EXPECT_NE(result.text.find("L0"), std::string::npos) << result.text;
  EXPECT_NE(result.text.find("L3"), std::string::npos) << result.text;
  EXPECT_EQ(result.text.find('K'), std::string::npos) << result.text;
  EXPECT_EQ(trace_of(fanuc, control("fanuc", ir::MachineKind::mill)), trace_of(result.text, haas())) << result.text;
  const ConvertResult back = between(result.text, "haas", "fanuc");
  EXPECT_FALSE(text::has_error(back.diagnostics)) << messages_of(back.diagnostics, text::Source("p", result.text));
  EXPECT_EQ(trace_of(fanuc, control("fanuc", ir::MachineKind::mill)),
            trace_of(back.text, control("fanuc", ir::MachineKind::mill)))
      << back.text;
}

TEST(Haas, M29OfAFanucIsLeftOut) {
  const std::string fanuc =
      "O1\nG21 G17 G90 G95 G54\nT1 M6\nG0 X0. Y0.\nG43 H1 Z10.\nM29 S500\nG84 X5. Y5. Z-5. R2. F1.\nG80\nM30\n";
  const ConvertResult result = between(fanuc, "fanuc", "haas");
  EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, text::Source("p", fanuc));
  EXPECT_EQ(result.text.find("M29"), std::string::npos) << "a relay on a Haas: " << result.text;
  const ConvertResult back = between(result.text, "haas", "fanuc");
  EXPECT_NE(back.text.find("M29"), std::string::npos) << "its taps are rigid: " << back.text;
}

// Whether what follows M29 is understood: only where it announces a rigid tap.
TEST(Haas, M29OfItsOwnIsARelay) {
  const text::Source source("program", "O1\nG21 G17 G90 G94 G54\nG0 X0. Y0.\nM29 S500\nM30\n");
  const auto says_m29 = [&](const ir::Control& on) {
    const Dialect* dialect = find_dialect(on.dialect);
    const ir::ReadResult read = dialect->read(source, on);
    Motions motions;
    const interpreter::RunResult result = execute(read.program, on, nullptr, motions, {});
    const auto found = std::ranges::find(result.not_interpreted, "M29", &interpreter::NotInterpreted::name);
    return found != result.not_interpreted.end() && !found->effects_known;
  };
  EXPECT_TRUE(says_m29(haas()));
  EXPECT_FALSE(says_m29(control("fanuc", ir::MachineKind::mill)));
  ir::Control listed = haas();
  listed.machine_functions = {29};
  EXPECT_FALSE(says_m29(listed)) << "the profile knows what its relay does";
}

TEST(Haas, ADwellThatIsComputedIsRefused) {
  const std::string fanuc = "O1\nG21 G90 G54\n#100=500\nG4 P#100\nM30\n";
  EXPECT_TRUE(text::has_error(between(fanuc, "fanuc", "haas").diagnostics));
}

TEST(Haas, PocketsAreKnownByNameAndNotInterpreted) {
  const ir::Control on = haas();
  const text::Source source("program", "O1\nG21 G90 G54 G0 X0. Y0. Z5.\nG12 I10. F100. Z-5. D1\nM30\n");
  const ir::ReadResult read = find_dialect("haas")->read(source, on);
  EXPECT_FALSE(text::has_error(find_dialect("haas")->validate(read.program, on, ir::Delivery::memory)));
  Motions motions;
  const interpreter::RunResult result = execute(read.program, on, nullptr, motions, {});
  ASSERT_FALSE(result.not_interpreted.empty());
  EXPECT_EQ(result.not_interpreted[0].name, "G12");
}

TEST(Haas, HasAnAlarmForACodeOfItsRelatives) {
  const text::Source source("program", "O1\nG21 G90 G54.1 P1\nM30\n");
  const ir::ReadResult read = find_dialect("haas")->read(source, haas());
  const auto unknown = std::ranges::find(read.diagnostics, text::DiagnosticId::unknown_code, &text::Diagnostic::id);
  ASSERT_NE(unknown, read.diagnostics.end());
  EXPECT_EQ(unknown->alarm, "310");
}

TEST(Haas, IsTakenForOneByItsCodes) {
  EXPECT_EQ(infer_dialect(text::Source("p", "O1\nG154 P3\nM30\n")).name, "haas");
  EXPECT_EQ(infer_dialect(text::Source("p", "O1\n(HAAS VF2)\nM30\n")).name, "haas");
  EXPECT_EQ(infer_dialect(text::Source("p", "O1\nG54.1 P3\nM30\n")).name, "fanuc");
}

}  // namespace
}  // namespace dripfeed::compile::test

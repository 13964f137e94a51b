// Block skip: '/' in front of a block and inside of one, with the operator's switch on and off, here and translated.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

constexpr std::string_view kProgram =
    "%\nO1\nG21 G90 G94 G17\nG00 X0. Z5.\n/X7.\nG01 Z2. F100. /M08\nX1. /2 Y2. Z3.\nM30\n%\n";

std::string trace_of(const std::string& text, std::uint32_t switches) {
  const ir::Control machine = control("fanuc", ir::MachineKind::mill);
  const text::Source source("skip.nc", text);
  const ir::ReadResult read = find_dialect("fanuc")->read(source, machine);
  EXPECT_TRUE(read.diagnostics.empty()) << messages_of(read.diagnostics, source);
  interpreter::RunNames names;
  interpreter::TraceWriter trace(machine, names);
  interpreter::RunOptions options;
  options.names = &names;
  options.skip_switches = switches;
  EXPECT_EQ(execute(read.program, machine, nullptr, trace, options).ended, interpreter::Ended::end);
  return trace.text();
}

ConvertResult converted(std::string text, const std::string& to, ConvertMode mode,
                        ir::MachineKind kind = ir::MachineKind::mill) {
  ConvertRequest request;
  request.source = text::Source("skip.nc", std::move(text));
  request.from = control("fanuc", kind);
  request.to = control(to, kind);
  request.mode = mode;
  return convert(request);
}

TEST(BlockSkip, LeavesOutWhatTheSwitchNames) {
  const std::string text(kProgram);
  EXPECT_EQ(trace_of(text, 0),
            "4 rapid X0.0000 Y0.0000 Z5.0000\n5 rapid X7.0000 Y0.0000 Z5.0000\n6 coolant flood\n"
            "6 linear X7.0000 Y0.0000 Z2.0000 F100.0000/min\n7 linear X1.0000 Y2.0000 Z3.0000 F100.0000/min\n8 end\n");
  EXPECT_EQ(trace_of(text, 1U << 1),
            "4 rapid X0.0000 Y0.0000 Z5.0000\n6 linear X0.0000 Y0.0000 Z2.0000 F100.0000/min\n"
            "7 linear X1.0000 Y2.0000 Z3.0000 F100.0000/min\n8 end\n");
  EXPECT_EQ(trace_of(text, 1U << 2),
            "4 rapid X0.0000 Y0.0000 Z5.0000\n5 rapid X7.0000 Y0.0000 Z5.0000\n6 coolant flood\n"
            "6 linear X7.0000 Y0.0000 Z2.0000 F100.0000/min\n7 linear X1.0000 Y0.0000 Z2.0000 F100.0000/min\n8 end\n");
}

TEST(BlockSkip, IsKeptByAMacroTranslation) {
  const ConvertResult mazak = converted(std::string(kProgram), "mazak", ConvertMode::macro);
  EXPECT_TRUE(mazak.diagnostics.empty());
  EXPECT_NE(mazak.text.find("G01 Z2. F100. / M08\nX1. /2 Y2. Z3.\n"), std::string::npos) << mazak.text;
}

std::vector<ir::Motion> moves_with(const std::string& text, const std::string& dialect, std::uint32_t switches) {
  const ir::Control machine = control(dialect, ir::MachineKind::mill);
  const ir::ReadResult read = find_dialect(dialect)->read(text::Source("skip.nc", text), machine);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << text;
  Motions motions;
  interpreter::RunOptions options;
  options.skip_switches = switches;
  EXPECT_EQ(execute(read.program, machine, nullptr, motions, options).ended, interpreter::Ended::end);
  return real_moves(motions.all);
}

TEST(BlockSkip, InsideABlockIsAChoiceOnSinumerik) {
  const std::string text(kProgram);
  const ConvertResult made = converted(text, "sinumerik-840d", ConvertMode::macro);
  ASSERT_FALSE(text::has_error(made.diagnostics)) << text::message_of(made.diagnostics.front());
  EXPECT_NE(made.text.find("GOTOF N"), std::string::npos) << made.text;
  for (const std::uint32_t switches : {0U, 1U << 1, 1U << 2, 3U << 1})
    expect_same(moves_with(text, "fanuc", switches), moves_with(made.text, "sinumerik-840d", switches), 1e-9,
                made.text);
}

TEST(BlockSkip, OfAModeInsideABlockHasNoWordOnSinumerik) {
  const ConvertResult made =
      converted("%\nO1\nG21 G90 G94 G17\nG00 X0. /G91 Y5.\nM30\n%\n", "sinumerik-840d", ConvertMode::macro);
  EXPECT_EQ(made.text, "");
  ASSERT_FALSE(made.diagnostics.empty());
  EXPECT_EQ(text::message_of(made.diagnostics.front()),
            "block skip inside a block has no counterpart on SINUMERIK 840D sl");
}

TEST(BlockSkip, IsDecidedByPlainBlocksAndThatIsReported) {
  const ConvertResult made = converted(std::string(kProgram), "sinumerik-840d", ConvertMode::explicit_blocks);
  ASSERT_EQ(made.diagnostics.size(), 1U);
  EXPECT_EQ(made.diagnostics.front().id, text::DiagnosticId::block_skip_decided);
  EXPECT_NE(made.text.find("M8\nG1 Z2. F100\n"), std::string::npos) << made.text;
  const ConvertResult plain =
      converted("%\nO1\nG21 G90 G94 G17\nG00 X0.\nM30\n%\n", "mazak", ConvertMode::explicit_blocks);
  EXPECT_TRUE(plain.diagnostics.empty());  // near miss: no skip
}

TEST(BlockSkip, OfANumberThatIsNoLevelIsAFault) {
  const text::Source source("skip.nc", "%\nO1\nG00 X1. /12 Y2.\nM30\n%\n");
  const ir::ReadResult read = find_dialect("fanuc")->read(source, control("fanuc", ir::MachineKind::mill));
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_EQ(read.diagnostics.front().id, text::DiagnosticId::skip_level_invalid);
}

// A subprogram stays one: without its return the control would stop in it.
TEST(Explicit, SubprogramsGoBackToTheirCaller) {
  const std::string sub = "%\nO2\nG21 G90 G94 G17\nG00 X1. Y2.\nM99\n%\n";
  for (const auto& [to, end] :
       {std::pair{"mazak", "M99\n%\n"}, {"mitsubishi-m80", "M99\n%\n"}, {"sinumerik-840d", "M17\n"}}) {
    const ConvertResult made = converted(sub, to, ConvertMode::explicit_blocks);
    EXPECT_TRUE(made.text.ends_with(end)) << to << ":\n" << made.text;
  }
}

// What comes first may be no move: a lathe's plane is Z-X all the same.
TEST(Explicit, LathesBeginInTheirPlane) {
  const ConvertResult made = converted("%\nO3\nM16\nG21 G00 X20. Z5.\nM30\n%\n", "sinumerik-840d",
                                       ConvertMode::explicit_blocks, ir::MachineKind::lathe);
  EXPECT_NE(made.text.find("G18"), std::string::npos) << made.text;
  EXPECT_EQ(made.text.find("G17"), std::string::npos) << made.text;
}

}  // namespace
}  // namespace dripfeed::compile::test

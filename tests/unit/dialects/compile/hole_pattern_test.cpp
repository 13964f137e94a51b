// Hole patterns from one control to another: between the controls that have them, and their moves for the others.
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

const std::string kHead = "%\nO1\nG21 G17 G90 G94 G40\nM03 S1000\nG00 X0. Y0. Z50.\nG81 Z-10. R5. L0 F200.\n";
const std::string kTail = "G80\nM30\n%\n";
const std::string kFigures =
    "G34 X200. Y100. I100. J20. K6\nG35 X0. Y0. I10. J30. K4\nG36 X200. Y100. I100. J20. P15. K4\n"
    "G37.1 X0. Y0. I10. P3 J-8. K2\n";

TEST(HolePatterns, AreCarriedWhereTheyAreKnown) {
  const std::string text = kHead + kFigures + kTail;
  const ConvertResult made = translated(text, "mitsubishi-m80", "mazak");
  ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, {"program", text});
  EXPECT_NE(made.text.find(kFigures), std::string::npos) << made.text;
  const auto moves = [](const std::string& program, const std::string& dialect) {
    return moves_of(run_text(program, control(dialect, ir::MachineKind::mill)).motions);
  };
  expect_same(moves(text, "mitsubishi-m80"), moves(made.text, "mazak"), 1e-9, made.text);
  EXPECT_EQ(moves(text, "mitsubishi-m80").size(), 1 + 4U * (6 + 4 + 4 + 6)) << "a place, R, the bottom and back";
}

// Lengths and angles get their points; numbers of holes stay whole.
TEST(HolePatterns, CountedNumbersKeepTheirMeaning) {
  const ConvertResult made = translated(
      kHead + "G37.1 X1000 Y2000 I5000 P3 J-4000 K2\nG35 X0 Y0 I500 J30000 K4\n" + kTail, "mitsubishi-m80", "mazak");
  EXPECT_NE(made.text.find("G37.1 X1. Y2. I5. P3 J-4. K2\nG35 X0. Y0. I0.5 J30. K4\n"), std::string::npos) << made.text;
}

TEST(HolePatterns, AreTheirMovesForTheOthers) {
  const std::string text = kHead + kFigures + kTail;
  for (const std::string to : {"fanuc", "sinumerik-840d"}) {
    for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
      ConvertRequest request;
      request.source = text::Source("program", text);
      request.from = control("mitsubishi-m80", ir::MachineKind::mill);
      request.to = control(to, ir::MachineKind::mill);
      request.mode = mode;
      const ConvertResult plain = convert(request);
      ASSERT_FALSE(text::has_error(plain.diagnostics)) << messages_of(plain.diagnostics, request.source);
      expect_same(real_moves(run_text(text, request.from).motions),
                  real_moves(run_text(plain.text, request.to).motions), 6e-4, plain.text);
    }
  }
}

// Without a cycle only places come of it, and that is not certain; with a variable of others no one knows the places.
TEST(HolePatterns, AreRefusedWithTheirPlace) {
  for (const std::string& text :
       {"%\nO1\nG21 G17 G90 G94 G40\nG00 X0. Y0. Z50.\n" + kFigures + "M30\n%\n",
        kHead +
            "G34 X#100 Y100. I100. J20. K6\nG35 X0. Y0. I10. J30. K4\nG36 X200. Y100. I100. J20. P15. K4\n"
            "G37.1 X0. Y0. I10. P3 J-8. K2\n" +
            kTail}) {
    for (const std::string to : {"fanuc", "sinumerik-840d"}) {
      const ConvertResult refused = translated(text, "mitsubishi-m80", to);
      std::vector<std::uint32_t> places;
      for (const text::Diagnostic& d : refused.diagnostics)
        if (d.severity == text::Severity::error) places.push_back(d.span.begin);
      ASSERT_EQ(places.size(), 4U) << messages_of(refused.diagnostics, {"program", text});
      EXPECT_EQ(places[0], text.find("G34"));
      EXPECT_EQ(places[3], text.find("G37.1"));
      EXPECT_EQ(refused.text, "");
    }
  }
}

}  // namespace
}  // namespace dripfeed::compile::test

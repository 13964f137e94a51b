// G34 and G35 from one control to another: the lead and its change in the other's words, or refused with the place.
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

ConvertResult lathe_to(const std::string& text, const std::string& from, const std::string& to, ConvertMode mode) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = control(from, ir::MachineKind::lathe);
  request.to = control(to, ir::MachineKind::lathe);
  request.mode = mode;
  return convert(request);
}

const std::string kFanuc =
    "%\nO1\nG21 G18 G99 G97 G40\nS500 M03\nG00 X20. Z5.\nG34 Z-30. F2. K0.1\nW-5. F3.5 K-0.25\nG00 X60.\n"
    "G01 X50. F0.2\nM30\n%\n";
const std::string kSinumerik =
    "G18 G90 G95 G71 DIAMON\nS500 M3\nG0 X20 Z5\nG34 Z-30 K2 F0.1\nG35 Z-35 K3.5 F0.25\nG0 X60\nG1 X50 F0.2\nM30\n";

void expect_same_threads(const std::string& text, const std::string& from, const std::string& to, ConvertMode mode) {
  const ConvertResult made = lathe_to(text, from, to, mode);
  ASSERT_FALSE(text::has_error(made.diagnostics)) << from << to << messages_of(made.diagnostics, {"program", text});
  const auto moves = [](const std::string& program, const std::string& dialect) {
    return moves_of(run_text(program, control(dialect, ir::MachineKind::lathe)).motions);
  };
  const std::vector<ir::Motion> motions = moves(made.text, to);
  expect_same(moves(text, from), motions, 1e-9, made.text);
  ASSERT_EQ(motions.size(), 5U);
  EXPECT_DOUBLE_EQ(motions[1].center[0], 0.1) << made.text;
  EXPECT_DOUBLE_EQ(motions[2].center[0], -0.25) << made.text;
}

TEST(ChangingThreads, AreCarriedBetweenLathes) {
  for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
    for (const std::string& to : dialect_names()) {
      expect_same_threads(kSinumerik, "sinumerik-840d", to, mode);
      expect_same_threads(kFanuc, "fanuc", to, mode);
    }
    expect_same_threads(kFanuc, "mazak", "mitsubishi-m80", mode);
  }
  const std::string there = lathe_to(kFanuc, "fanuc", "sinumerik-840d", ConvertMode::macro).text;
  EXPECT_NE(there.find("G34 Z-30. K2. F0.1"), std::string::npos) << there;
  EXPECT_NE(there.find("G35 Z=IC(-5.) K3.5 F0.25"), std::string::npos) << there;
  const std::string back = lathe_to(kSinumerik, "sinumerik-840d", "fanuc", ConvertMode::macro).text;
  EXPECT_NE(back.find("G34 Z-30. F2. K0.1"), std::string::npos) << back;
  EXPECT_NE(back.find("F3.5 K-0.25"), std::string::npos) << back;
}

TEST(ChangingThreads, WhatCannotBeWrittenIsRefusedWithItsPlace) {
  struct Row {
    std::string from;
    std::string to;
    std::string blocks;
  };
  const std::string fanuc = "%\nO1\nG21 G18 G99 G97 G40\nS500 M03\nG00 X20. Z5.\n";
  const std::string sinumerik = "G18 G90 G95 G71 DIAMON\nS500 M3\nG0 X20 Z5\n";
  for (const Row& row : {
           Row{"fanuc", "sinumerik-840d", fanuc + "G34 Z-30. F2.\nM30\n%\n"},                // which change
           Row{"fanuc", "sinumerik-840d", fanuc + "G34 Z-30. F2. K#1\nM30\n%\n"},            // which sign
           Row{"fanuc", "sinumerik-840d", fanuc + "G34 Z-30. F2. K.1\nG01 X30.\nM30\n%\n"},  // the feed is 2 there
           Row{"fanuc", "sinumerik-840d", fanuc + "G34 Z-30. F2. K.1\nF.2\nG01 X9.\nM30\n%\n"},
           Row{"sinumerik-840d", "fanuc", sinumerik + "G34 Z-30 F0.1\nM30\n"},  // which lead
           Row{"sinumerik-840d", "fanuc", sinumerik + "G35 Z-30 K2 F=R1\nM30\n"},
           Row{"sinumerik-840d", "fanuc", sinumerik + "G34 Z-30 K2 F-0.1\nM30\n"},
           Row{"sinumerik-840d", "fanuc", sinumerik + "G34 Z-30 K2 F0.1\nG1 X30\nM30\n"},  // no feed
       }) {
    const ConvertResult made = lathe_to(row.blocks, row.from, row.to, ConvertMode::macro);
    ASSERT_TRUE(text::has_error(made.diagnostics)) << row.blocks << made.text;
    const auto error = std::ranges::find(made.diagnostics, text::Severity::error, &text::Diagnostic::severity);
    EXPECT_GT(error->span.begin, 30U) << row.blocks;
  }
  // A mill has no such thread.
  const std::string mill = "G17 G90 G95 G71\nS500 M3\nG0 X0 Y0 Z5\nG34 Z-30 K2 F0.1\nM30\n";
  EXPECT_TRUE(text::has_error(translated(mill, "sinumerik-840d", "fanuc").diagnostics));
  ConvertRequest request;
  request.source = text::Source("program", mill);
  request.from = control("sinumerik-840d", ir::MachineKind::mill);
  request.to = control("fanuc", ir::MachineKind::mill);
  request.mode = ConvertMode::explicit_blocks;
  const ConvertResult made = convert(request);
  EXPECT_TRUE(text::has_error(made.diagnostics)) << made.text;
}

// The lead of a thread that is an increment along Z is K all the same.
TEST(ChangingThreads, AnIncrementAlongZHasItsLeadInK) {
  const std::string made =
      lathe_to("%\nO1\nG21 G18 G99 G97 G40\nS500 M03\nG00 X20. Z5.\nG32 W-20. F2.\nG00 X40.\nM30\n%\n", "fanuc",
               "sinumerik-840d", ConvertMode::macro)
          .text;
  EXPECT_NE(made.find("G33 Z=IC(-20.) K2."), std::string::npos) << made;
}

// With G70 lengths are in inch, leads with them, and feeds stay in mm.
TEST(ChangingThreads, LeadsAreLengthsWhereFeedsAreNot) {
  const std::string text =
      "G18 G90 G95 G70 DIAMON\nS500 M3\nG0 X2 Z0.5\nG33 Z-1 K0.1\nX2.1 Z-1.2 K0.1\nG0 X3\nG1 Z-1 F0.254\nM30\n";
  for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
    const ConvertResult made = lathe_to(text, "sinumerik-840d", "fanuc", mode);
    const auto moves = [](const std::string& program, const std::string& dialect) {
      return moves_of(run_text(program, control(dialect, ir::MachineKind::lathe)).motions);
    };
    const std::vector<ir::Motion> motions = moves(made.text, "fanuc");
    expect_same(moves(text, "sinumerik-840d"), motions, 1e-9, made.text);
    ASSERT_EQ(motions.size(), 5U);
    EXPECT_DOUBLE_EQ(motions[2].feed, 2.54) << made.text;
  }
  const ConvertResult changing = lathe_to("G18 G90 G95 G70 DIAMON\nS500 M3\nG0 X2 Z0.5\nG34 Z-1 K0.1 F0.01\nM30\n",
                                          "sinumerik-840d", "fanuc", ConvertMode::macro);
  EXPECT_TRUE(text::has_error(changing.diagnostics)) << changing.text;
}

// From X20 to X60 are 20 mm of radius: more than 5 along Z, and less than 25.
TEST(ChangingThreads, TheLeadOfAConeCountsAlongItsLongerAxis) {
  const std::string head = "%\nO1\nG21 G18 G99 G97 G40\nS500 M03\nG00 X20. Z5.\n";
  struct Row {
    std::string block;
    std::string macro;
    std::string plain;
  };
  for (const Row& row : {Row{"G32 X60. Z0. F2.", "G33 X60. Z0. I2.", "G33 X60. Z0. I2."},
                         Row{"G32 X60. Z-20. F2.", "G33 X60. Z-20. K2.", "G33 X60. Z-20. K2."},
                         Row{"G32 U40. W-5. F2.", "G33 X=IC(40.) Z=IC(-5.) I2.", "G33 X60. Z0. I2."},
                         Row{"G34 X60. Z0. F2. K0.1", "G34 X60. Z0. I2. F0.1", "G34 X60. Z0. I2. F0.1"}}) {
    const std::string text = head + row.block + "\nG00 X80.\nM30\n%\n";
    const std::string macro = lathe_to(text, "fanuc", "sinumerik-840d", ConvertMode::macro).text;
    EXPECT_NE(macro.find(row.macro), std::string::npos) << macro;
    const std::string plain = lathe_to(text, "fanuc", "sinumerik-840d", ConvertMode::explicit_blocks).text;
    EXPECT_NE(plain.find(row.plain), std::string::npos) << plain;
    const std::string mazak = lathe_to(text, "fanuc", "mazak", ConvertMode::explicit_blocks).text;
    EXPECT_NE(mazak.find("F2."), std::string::npos) << mazak;
    EXPECT_EQ(mazak.find('I'), std::string::npos) << mazak;
  }
  const ConvertResult unknown =
      lathe_to(head + "#100=60.\nG32 X#100 Z0. F2.\nG00 X80.\nM30\n%\n", "fanuc", "sinumerik-840d", ConvertMode::macro);
  EXPECT_NE(unknown.text.find("K2."), std::string::npos) << messages_of(unknown.diagnostics, {"program", head});
  EXPECT_TRUE(std::ranges::any_of(unknown.diagnostics, [](const text::Diagnostic& d) {
    return d.severity == text::Severity::warning && text::message_of(d).contains("lead of a cone");
  }));
}

}  // namespace
}  // namespace dripfeed::compile::test

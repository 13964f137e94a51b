// A native program as a family: its bytes stay, its constants take the values, and what is not plain is refused.
#include "dialects/compile/render/wrapped_family.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/text/number.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

using Values = std::vector<family::Override>;

const std::string kMill = "family holder \"Holder\"\nmachine mill\n";
const std::string kLathe = "family holder\nmachine lathe, x is diameter\n";

RenderResult rendered(const std::string& family, const std::string& dialect, const Values& values = {},
                      RenderMode mode = RenderMode::automatic, ir::Delivery delivery = ir::Delivery::memory) {
  RenderRequest request;
  request.family = text::Source("holder.family", family);
  request.values = values;
  request.target = control(dialect, family.contains("machine lathe") ? ir::MachineKind::lathe : ir::MachineKind::mill);
  request.mode = mode;
  request.delivery = delivery;
  return render(request);
}

std::string text_of(const std::string& family, const std::string& dialect, const Values& values = {}) {
  const RenderResult out = rendered(family, dialect, values);
  EXPECT_FALSE(text::has_error(out.diagnostics)) << messages_of(out.diagnostics, text::Source("f", family));
  return out.text;
}

// All errors, one a line.
std::string faults_of(const std::string& family, const std::string& dialect, const Values& values = {},
                      RenderMode mode = RenderMode::automatic, ir::Delivery delivery = ir::Delivery::memory) {
  std::string out;
  for (const text::Diagnostic& one : rendered(family, dialect, values, mode, delivery).diagnostics)
    if (one.severity == text::Severity::error) out.append(text::message_of(one)).append("\n");
  return out;
}

// The diagnostics where the family is stored: without a machine.
std::string reported_of_description(const std::string& family) {
  const text::Source source("holder.family", family);
  return messages_of(describe_family(source).diagnostics, source);
}

std::string fanuc_with(const std::string& assignment, const std::string& rest = "G0X#100\n") {
  return kMill + "param width length 50 mm in 1..500 is #100\nnative fanuc\n%\nO1000\nG21G90\n" + assignment + rest +
         "M30\n%\n";
}

TEST(WrappedFamily, DefaultsKeepEveryByte) {
  const std::string odd =
      "% \r\nO1000 (BOHRUNG \xD8 50)\r\n  G21G90G17\r\n#100 = 050.000(Breite)\r\n\r\nn10 "
      "g0x#100\r\nM30\r\n%\r\n\r\n\x1A";
  const std::string family = kMill + "param width length 50 mm in 1..500 \"width\" is #100\nnative fanuc\n";
  EXPECT_EQ(text_of(family + odd, "fanuc"), odd);
  EXPECT_EQ(text_of(family + odd, "fanuc", {{"width", "51.25 mm"}}),
            "% \r\nO1000 (BOHRUNG \xD8 50)\r\n  G21G90G17\r\n#100 = 51.25(Breite)\r\n\r\nn10 "
            "g0x#100\r\nM30\r\n%\r\n\r\n\x1A");
}

TEST(WrappedFamily, NumbersKeepTheirForm) {
  struct Row {
    std::string old;
    std::string value;
    std::string expected;
  };
  const std::vector<Row> rows = {
      {"50.", "60 mm", "60."},          {"50", "60 mm", "60"},       {"50", "60.5 mm", "60.5"},
      {"50.0", "60 mm", "60."},         {"50.", "50 mm", "50."},     {"+50.", "60 mm", "60."},
      {"50.", "1.5 in", "38.1"},        {"[50.]", "60 mm", "[60.]"}, {"0050.", "60 mm", "60."},
      {"50.", "33.3333 mm", "33.3333"},
  };
  for (const Row& row : rows)
    EXPECT_EQ(text_of(fanuc_with("#100=" + row.old + "(W)\n"), "fanuc", {{"width", row.value}}),
              "%\nO1000\nG21G90\n#100=" + row.expected + "(W)\nG0X#100\nM30\n%\n")
        << row.old;
}

TEST(WrappedFamily, SignsStayShort) {
  const std::string head = kLathe + "param depth length -3.5 mm in -10..10 is R10\nnative sinumerik-840d\n";
  const auto program = [](const std::string& number) {
    return fmt::format("G71\nR10={} R11=1\nG0 X=R10\nM30\n", number);
  };
  for (const auto& [old, value, expected] : std::vector<std::array<std::string, 3>>{{"-3.5", "-4 mm", "-4."},
                                                                                    {"-3.5", "4 mm", "4."},
                                                                                    {"- 3.5", "2.25 mm", "2.25"},
                                                                                    {"+3.5", "-2 mm", "-2."},
                                                                                    {"-3.5", "0 mm", "0."}})
    EXPECT_EQ(text_of(head + program(old), "sinumerik-840d", {{"depth", value}}), program(expected));
}

TEST(WrappedFamily, LetsBindToo) {
  const std::string family = kMill +
                             "param part length 30 mm in 1..100 is #1\nparam wall length 5 mm in 1..100\n"
                             "let total = part + 2*wall is #20\nnative fanuc\nG21\nN1#1=30.\n#20=40.\nG0X#20Y#1\nM30\n";
  EXPECT_EQ(text_of(family, "fanuc"), "G21\nN1#1=30.\n#20=40.\nG0X#20Y#1\nM30\n");
  EXPECT_EQ(text_of(family, "fanuc", {{"wall", "1 mm"}}), "G21\nN1#1=30.\n#20=32.\nG0X#20Y#1\nM30\n");
}

TEST(WrappedFamily, UnitsAreTheProgramsOwn) {
  const auto family = [](const std::string& unit, const std::string& kind) {
    return kMill + "param size " + kind + " is #100\nnative fanuc\n" + unit + "\n#100=1.\nX#100\nM30\n";
  };
  const auto value_in = [&](const std::string& unit, const std::string& kind, const std::string& value) {
    const std::string text = text_of(family(unit, kind), "fanuc", {{"size", value}});
    const std::size_t at = text.find('=') + 1;
    return text.substr(at, text.find('\n', at) - at);
  };
  EXPECT_EQ(value_in("G20", "length 1 in in 0..100", "50.8 mm"), "2.");
  EXPECT_EQ(value_in("G21", "length 1 in in 0..100", "2 in"), "50.8");
  EXPECT_EQ(value_in("G20", "feed 1 in/min in 0..100", "50.8 mm/min"), "2.");
  EXPECT_EQ(value_in("G20", "speed 1 ft/min in 0..1000", "30.48 m/min"), "100.");
  EXPECT_EQ(value_in("G20", "speed 1 rpm in 0..9000", "800 rpm"), "800.");
  EXPECT_EQ(value_in("G20", "angle 1 deg in 0..360", "0.5 rad"), "28.64789");
  EXPECT_EQ(value_in("G20", "time 1 ms in 0..9000", "2 s"), "2000.");
  EXPECT_EQ(value_in("G20", "time 1 s in 0..9000", "500 ms"), "0.5");
  EXPECT_EQ(value_in("G20", "count 1 in 0..9", "7"), "7.");
}

// A header stands before the code: the only unit of the text is meant. Without one it is not known.
TEST(WrappedFamily, UnknownUnitsAreRefused) {
  const std::string head = kMill + "param size length 1 mm in 0..100 is #100\nnative fanuc\n#100=1.\n";
  EXPECT_EQ(text_of(head + "G20\nX#100\nM30\n", "fanuc", {{"size", "25.4 mm"}}), "#100=1.\nG20\nX#100\nM30\n");
  EXPECT_NE(faults_of(head + "X#100\nM30\n", "fanuc").find("whether lengths of its line 1 are in inches"),
            std::string::npos);
  EXPECT_NE(faults_of(head + "G20\nG21\nM30\n", "fanuc"), "");
  // The machine's profile knows.
  RenderRequest request;
  request.family = text::Source("f", head + "X#100\nM30\n");
  request.target = control("fanuc", ir::MachineKind::mill);
  request.target.semantics.power_on_known = true;
  request.target.semantics.power_on_unit = ir::Function::unit_inch;
  request.values = {{"size", "50.8 mm"}};
  EXPECT_EQ(render(request).text, "#100=2.\nX#100\nM30\n");
}

// G70 and G71 leave feeds in the basic system of the machine; G700 and G710 do not.
TEST(WrappedFamily, FeedsOfSinumerikHaveTheirOwnUnit) {
  const std::string head = kLathe + "param size feed 1 mm/min in 0..100 is R1\nnative sinumerik-840d\n";
  EXPECT_NE(faults_of(head + "G70\nR1=1.\nG94 G1 F=R1\nM30\n", "sinumerik-840d"), "");
  EXPECT_EQ(text_of(head + "G700\nR1=1.\nG94 G1 F=R1\nM30\n", "sinumerik-840d", {{"size", "50.8 mm/min"}}),
            "G700\nR1=2.\nG94 G1 F=R1\nM30\n");
}

TEST(WrappedFamily, WhatIsNotPlainIsRefused) {
  struct Row {
    std::string assignment;
    std::string rest;
    std::string messages;
  };
  const std::string use = "G0X#100\n";
  const std::vector<Row> rows = {
      {"#100=#1\n", use, "line 4 of the native program does not set it to a plain decimal number"},
      {"#100=50.+1.\n", use, "line 4 of the native program does not set it to a plain decimal number"},
      {"#101=50.\n", "G0X#101\n", "no line of the native program sets it"},
      {"#100=50.\n#100=60.\n", use, "set in lines 4 and 5 of the native program"},
      {"#100=50.\n", use + "#100=#100+1.\n" + use, "set in lines 4 and 6 of the native program"},
      {"G0X#100\n#100=50.\n", "G0Z#100\n", "line 4 of the native program may read it before line 5"},
      {"IF[#1EQ1]GOTO9\n#100=50.\nN9G0Z1.\n", use, "line 7 of the native program may read it before line 5"},
      {"IF[#1EQ1]THEN#100=50.\n", use, "line 5 of the native program may read it before line 4"},
      {"IF[#1EQ1]GOTO9\n#100=50.\nN9G0Z1.\n", "", "line 7 of the native program may read it before line 5"},
      {"/#100=50.\n", use, "line 4 of the native program may be skipped"},
  };
  for (const Row& row : rows) {
    const std::string messages = faults_of(fanuc_with(row.assignment, row.rest), "fanuc");
    EXPECT_TRUE(messages.starts_with("#100 does not take the value: ")) << messages;
    EXPECT_NE(messages.find(row.messages), std::string::npos) << messages;
  }
}

TEST(WrappedFamily, LoopsAndJumpsAfterTheAssignmentAreFine) {
  EXPECT_EQ(faults_of(fanuc_with("#100=50.\n#1=0\nWHILE[#1LT3]DO1\nG0X[#100*#1]\n#1=#1+1\nEND1\nIF[#1EQ3]GOTO9\nN9\n"),
                      "fanuc"),
            "");
}

TEST(WrappedFamily, FaultsAreShownInTheFamilysText) {
  const std::string family = fanuc_with("#100=50.\n#100=60.\n");
  const RenderResult result = rendered(family, "fanuc");
  ASSERT_EQ(result.diagnostics.size(), 1U);
  const text::Diagnostic& one = result.diagnostics[0];
  EXPECT_EQ(one.span.in(family), "#100");
  ASSERT_EQ(one.notes.size(), 2U);
  EXPECT_EQ(one.notes[1].span.in(family), "#100=60.");
  EXPECT_TRUE(result.text.empty());
}

TEST(WrappedFamily, ParametersNeedTargetsOfTheirOwn) {
  const std::string native = "native fanuc\nG21\n#100=5.\nX#100\nM30\n";
  EXPECT_NE(faults_of(kMill + "param one length 5 mm in 1..9\n" + native, "fanuc").find("one changes nothing"),
            std::string::npos);
  EXPECT_NE(faults_of(kMill + "param one length 5 mm in 1..9 is #100\nparam two length 5 mm in 1..9 is #100\n" + native,
                      "fanuc")
                .find("#100 takes one value"),
            std::string::npos);
  EXPECT_NE(
      faults_of(kMill + "param one length 5 mm in 1..9 is #100\nparam two length 5 mm in 1..9 is #0100\n" + native,
                "fanuc")
          .find("it is the number that #100 names"),
      std::string::npos);
  EXPECT_NE(
      faults_of(kMill + "param one length 5 mm in 1..9 is R10\n" + native, "fanuc").find("no variable of that kind"),
      std::string::npos);
  EXPECT_NE(
      faults_of(kMill + "param one length 5 mm in 1..9 is #100\nprogram p\nend\n", "fanuc").find("the family has none"),
      std::string::npos);
}

TEST(WrappedFamily, AnotherLanguageIsRefused) {
  const std::string messages = faults_of(fanuc_with("#100=50.\n"), "mitsubishi-m80");
  EXPECT_NE(messages.find("fanuc"), std::string::npos) << messages;
  EXPECT_NE(messages.find("mitsubishi-m80"), std::string::npos) << messages;
  const std::string unknown = kMill + "native okuma\nM30\n";
  EXPECT_NE(reported_of_description(unknown).find("no control here has the language 'okuma'"), std::string::npos);
}

// What the documentation shows is what happens.
TEST(WrappedFamily, TheExampleOfTheDocumentationRenders) {
  const std::string document = file_text("docs/families.md");
  const std::size_t at = document.find("```wrapped\n") + 11;
  const std::string family = document.substr(at, document.find("```", at) - at);
  const std::string program = family.substr(family.find("native fanuc\n") + 13);
  EXPECT_EQ(text_of(family, "fanuc"), program);
  const std::string changed = text_of(family, "fanuc", {{"slot_length", "100.5 mm"}, {"cut_feed", "90 mm/min"}});
  EXPECT_NE(changed.find("\n#100=100.5  (LENGTH)\n#101=4.   (DEPTH)\n#102=90. (FEED)\n#103=45. (FEED OF THE PLUNGE)\n"),
            std::string::npos)
      << changed;
  EXPECT_FALSE(run_text(changed, control("fanuc", ir::MachineKind::mill)).motions.empty());
}

TEST(WrappedFamily, ListsAndChoicesAreNoNumbers) {
  const std::string native = "native fanuc\nG21\n#100=1.\nX#100\nM30\n";
  EXPECT_NE(
      faults_of(kMill + "param entry choice slow of slow, fast is #100\n" + native, "fanuc").find("is not a number"),
      std::string::npos);
  const std::string row = kMill + "param row list of length 1 mm, 2 mm in 0..9 count 1..5";
  EXPECT_NE(faults_of(row + " is #100\n" + native, "fanuc").find("is not a number"), std::string::npos);
  EXPECT_EQ(text_of(row + "\nlet first = row[0] is #100\n" + native, "fanuc", {{"row", "7 mm, 8 mm"}}),
            "G21\n#100=7.\nX#100\nM30\n");
  EXPECT_EQ(text_of(kMill + "param probe yes_no yes is #100\n" + native, "fanuc", {{"probe", "no"}}),
            "G21\n#100=0.\nX#100\nM30\n");
}

// --- names and calls

const std::string kCalls =
    "%_N_MAIN_MPF\nEXTERN TURN(REAL, INT, REAL)\nG71\nDEF REAL DIA=100, LEN=20.5\nDEF INT TIMES\nTIMES=3\n"
    "G0 X=DIA Z=LEN\nTURN(DIA, 4, -2.50)\nG0 X=TIMES\nM30\n"
    "%_N_TURN_SPF\nPROC TURN(REAL DM, INT PASSES, REAL DEPTH)\nG1 X=DM Z=DEPTH\nM17\n";
const std::string kBoundCalls =
    kLathe +
    "param dia length 100 mm in 1..300 is DIA\nparam reach length 20.5 mm in 1..300 is len\n"
    "param times count 3 in 1..9 is TIMES\nparam passes count 4 in 1..9 is TURN.PASSES\n"
    "param depth length -2.5 mm in -10..10 is turn.depth\nnative sinumerik-840d\n";

TEST(WrappedFamily, NamesAndCallsTakeValues) {
  EXPECT_EQ(text_of(kBoundCalls + kCalls, "sinumerik-840d"), kCalls);
  const std::string changed =
      text_of(kBoundCalls + kCalls, "sinumerik-840d",
              {{"dia", "80.5 mm"}, {"reach", "7 mm"}, {"times", "5"}, {"passes", "6"}, {"depth", "1 mm"}});
  EXPECT_NE(changed.find("DEF REAL DIA=80.5, LEN=7.\n"), std::string::npos) << changed;
  EXPECT_NE(changed.find("\nTIMES=5\n"), std::string::npos) << changed;
  EXPECT_NE(changed.find("TURN(DIA, 6, 1.)"), std::string::npos) << changed;
}

TEST(WrappedFamily, LowerCaseStays) {
  const std::string head = kLathe + "param dia length 100 mm in 1..300 is DIA\nnative sinumerik-840d\n";
  EXPECT_EQ(text_of(head + "g71\ndef real dia = 100 ; D\xFCse\r\ng0 x=dia\nm30", "sinumerik-840d", {{"dia", "80 mm"}}),
            "g71\ndef real dia = 80 ; D\xFCse\r\ng0 x=dia\nm30");
}

TEST(WrappedFamily, CallsThatCannotTakeAValueAreRefused) {
  const auto messages = [](const std::string& target, const std::string& native) {
    return faults_of(kLathe + "param size length 1.5 mm in 0..100 is " + target + "\nnative sinumerik-840d\n" + native,
                     "sinumerik-840d");
  };
  EXPECT_NE(messages("TURN.DM", kCalls).find("does not set it to a plain decimal number"), std::string::npos);
  EXPECT_NE(messages("TURN.WIDTH", kCalls).find("TURN has no parameter WIDTH; it has DM, PASSES, DEPTH"),
            std::string::npos);
  EXPECT_NE(messages("MILL.DM", kCalls).find("holds no program MILL"), std::string::npos);
  EXPECT_NE(messages("DEPTH", kCalls).find("name it with the program, as in PROGRAM.DEPTH"), std::string::npos);
  std::string twice = kCalls;
  twice.replace(twice.find("G0 X=TIMES"), 10, "TURN(1,2,3)");
  EXPECT_NE(messages("TURN.DEPTH", twice).find("TURN is called in lines 8 and 9 of the native program"),
            std::string::npos);
  std::string left_out = kCalls;
  left_out.replace(left_out.find(", -2.50"), 7, "");
  EXPECT_NE(messages("TURN.DEPTH", left_out).find("the call in line 8 of the native program leaves it out"),
            std::string::npos);
  // PASSES is an INT.
  EXPECT_NE(messages("TURN.PASSES", kCalls).find("it takes whole numbers (INT), and 1.5 is not one"),
            std::string::npos);
}

// --- modes

TEST(WrappedFamily, MemoryAndPlainProgramsAreKept) {
  const std::string loop = fanuc_with("#100=50.\nWHILE[#1LT3]DO1\n#1=#1+1\nEND1\n");
  const RenderResult kept = rendered(loop, "fanuc");
  EXPECT_EQ(kept.mode, RenderMode::macro);
  EXPECT_EQ(kept.because, "the program is kept unchanged");
  EXPECT_EQ(kept.variables, 2U);
  EXPECT_EQ(kept.blocks, 8U);
  EXPECT_EQ(kept.bytes, kept.text.size());
  const RenderResult plain = rendered(fanuc_with("#100=50.\n"), "fanuc", {}, RenderMode::automatic, ir::Delivery::drip);
  EXPECT_EQ(plain.mode, RenderMode::macro);
  EXPECT_NE(faults_of(loop, "fanuc", {}, RenderMode::macro, ir::Delivery::drip).find("fed block by block"),
            std::string::npos);
}

TEST(WrappedFamily, LoopsAreFedAsBlocks) {
  const std::string loop = kMill +
                           "param width length 50 mm in 1..500 is #100\nnative fanuc\n%\nO1000\nG21G90G17G94G40\n"
                           "#100=50.\n#1=1\nWHILE[#1LE3]DO1\nG0X[#100*#1]\n#1=#1+1\nEND1\nM30\n%\n";
  for (const RenderMode mode : {RenderMode::automatic, RenderMode::explicit_blocks}) {
    const RenderResult fed = rendered(loop, "fanuc", {{"width", "10 mm"}}, mode, ir::Delivery::drip);
    EXPECT_FALSE(text::has_error(fed.diagnostics)) << messages_of(fed.diagnostics, text::Source("f", loop));
    EXPECT_EQ(fed.mode, RenderMode::explicit_blocks);
    EXPECT_EQ(fed.text.find("WHILE"), std::string::npos);
    for (const char* word : {"X10.", "X20.", "X30."}) EXPECT_NE(fed.text.find(word), std::string::npos) << fed.text;
    ASSERT_FALSE(fed.places.entries.empty());
    // Lines of the family: the move stands in its line 11.
    std::vector<std::uint32_t> origins;
    origins.reserve(fed.places.entries.size());
    for (const PlaceEntry& entry : fed.places.entries) origins.push_back(entry.origin);
    EXPECT_EQ(std::ranges::count(origins, 11U), 3) << fed.text;
  }
}

// --- the shipped one

struct Turned {
  double smallest_x = 1e9;
  double smallest_z = 1e9;
  int roughing = 0;  // passes
};

Turned turned(const Values& values) {
  RenderRequest request;
  request.family = shipped("turning-cycle");
  request.values = values;
  request.target = control("sinumerik-840d", ir::MachineKind::lathe);
  request.target.semantics.power_on_known = true;
  const RenderResult result = render(request);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, request.family);
  Turned out;
  for (const ir::Motion& m : run_text(result.text, request.target).motions) {
    if (m.kind != ir::MotionKind::linear) continue;
    out.smallest_x = std::min(out.smallest_x, m.end[0]);
    out.smallest_z = std::min(out.smallest_z, m.end[2]);
    out.roughing += m.end[2] < m.start[2] - 1.0 && std::abs(m.feed - 0.25) < 1e-9 ? 1 : 0;
  }
  return out;
}

// Layers of the depth that is asked for at most, down to the allowance; then the drawing's diameter and length.
TEST(WrappedFamily, TurningCycleTurnsItsValues) {
  const Turned standard = turned({});
  EXPECT_NEAR(standard.smallest_x, 50.0, 1e-9);
  EXPECT_NEAR(standard.smallest_z, -100.0, 1e-9);
  EXPECT_EQ(standard.roughing, 10);  // 24.75 mm in layers of 2.5
  const Turned shorter = turned({{"turned_diameter", "60 mm"}, {"end_z", "-80.5 mm"}, {"layer", "4 mm"}});
  EXPECT_NEAR(shorter.smallest_x, 60.0, 1e-9);
  EXPECT_NEAR(shorter.smallest_z, -80.5, 1e-9);
  EXPECT_EQ(shorter.roughing, 5);  // 19.75 mm in layers of 4
}

// --- any values

// What is between the constants stays, and the constants read back as the values.
TEST(WrappedFamily, AnyValuesGoIntoTheConstantsAlone) {
  const std::vector<std::string> pieces = {"%\r\nO7 (\xC4NDERN \xB0)\r\nG21\r\n#500=", "(A)\r\n#501 = ", "\r\n#502=[",
                                           "]\r\nG0X#500Y[#501+#502]\r\nM30\r\n%"};
  const std::vector<std::string> defaults = {"50.", "-12.25", "7"};
  const std::string family =
      kMill +
      "param one length 50 mm in -9999..9999 is #500\nparam two length -12.25 mm in -9999..9999 is "
      "#501\nparam three ratio 7 in -9999..9999 is #502\nnative fanuc\n" +
      pieces[0] + defaults[0] + pieces[1] + defaults[1] + pieces[2] + defaults[2] + pieces[3];
  std::mt19937 random(20240611);
  const auto decimal = [&random] {
    const int decimals = static_cast<int>(random() % 4);
    const double scale = std::pow(10.0, decimals);
    const double value = static_cast<double>(static_cast<std::int64_t>(random() % 19'998) - 9'999) / 10.0;
    return text::format_fixed(std::round(value * scale) / scale, decimals);
  };
  for (int round = 0; round < 500; ++round) {
    const std::vector<std::string> values = {decimal(), decimal(), decimal()};
    const std::string out =
        text_of(family, "fanuc", {{"one", values[0] + " mm"}, {"two", values[1] + " mm"}, {"three", values[2]}});
    std::size_t at = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      ASSERT_EQ(out.substr(at, pieces[i].size()), pieces[i]) << out;
      at += pieces[i].size();
      const std::size_t end = out.find_first_not_of("+-.0123456789", at);
      const std::string written = out.substr(at, end - at);
      ASSERT_EQ(text::parse_number(written), text::parse_number(values[i])) << out;
      ASSERT_EQ(text::parse_number(written) == text::parse_number(defaults[i]), written == defaults[i]) << out;
      at = end;
    }
    ASSERT_EQ(out.substr(at), pieces.back());
  }
}

}  // namespace
}  // namespace dripfeed::compile::test

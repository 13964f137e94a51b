// A program read without its stretches of plain moves does what it does when it is read whole, whatever is in effect
// around them; where something might take a block of a stretch by its name, the program is read whole.
#include "dialects/compile/translate/thin_program.h"

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "dialects/compile/translate/convert_thin.h"
#include "dialects/facts/resolved.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

constexpr ThinOptions kShort = {.least_bytes = 0, .least_lines = 4};

std::unique_ptr<ThinProgram> thin(const std::string& text, const ir::Control& on) {
  return ThinProgram::read(text::Source("p", text), *find_dialect(on.dialect), on, kShort);
}

// `count` lines "X1.25 Y-2. Z.5", each with some of the axes.
std::string moves(std::mt19937& random, int count, const std::string& code, bool numbered) {
  std::string out;
  for (int i = 0; i < count; ++i) {
    if (numbered) out += "N" + std::to_string(10 * i + 1000) + " ";
    out += code;
    const auto axes = static_cast<unsigned>(1 + random() % 7);
    for (int axis = 0; axis < 3; ++axis)
      if ((axes >> axis & 1U) != 0)
        out += std::string(1, static_cast<char>('X' + axis)) + std::to_string(static_cast<int>(random() % 40) - 20) +
               "." + std::to_string(random() % 1000);
    out += "\n";
  }
  return out;
}

// What a CAM system writes: straight lines and half circles, feeds where they change, rapids in between.
class Cuts {
 public:
  explicit Cuts(unsigned seed) : random_(seed) {}

  // After its head.
  std::string program(int lines, int lines_after_coolant) {
    std::string out = " G17 G90 G94 G40\nT1 M6\nG54\nS500 M3\nG0 X0. Y0. Z5.\nG1 Z1. F100\n";
    for (int i = 0; i < lines; ++i) out += line() + "\n";
    out += "M8\n";
    for (int i = 0; i < lines_after_coolant; ++i) out += line() + "\n";
    return out;
  }

 private:
  int number(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
  std::string point(char letter, int hundredths) {
    const std::string sign = hundredths < 0 ? "-" : "";
    const int size = std::abs(hundredths);
    return std::string(1, letter) + sign + std::to_string(size / 100) + "." + std::to_string(size % 100 / 10) +
           std::to_string(size % 10);
  }
  std::string line() {
    const std::string feed = number(3) == 0 ? " F" + std::to_string(100 + number(5)) + (number(2) == 0 ? "." : "") : "";
    const int kind = number(8);
    if (kind < 2) {
      const int i = number(400) - 200;
      const int j = number(400) - 200;
      x_ += 2 * i;
      y_ += 2 * j;
      return (kind == 0 ? "G2 " : "G3 ") + point('X', x_) + " " + point('Y', y_) + " " + point('I', i) + " " +
             point('J', j) + feed;
    }
    if (kind == 2) return "G1 " + point('Z', number(900) - 450) + feed;
    x_ = number(4000) - 2000;
    y_ = number(4000) - 2000;
    return (kind == 3 ? "G0 " : "G1 ") + point('X', x_) + " " + point('Y', y_) + (kind == 3 ? "" : feed);
  }

  std::mt19937 random_;
  int x_ = 0;
  int y_ = 0;
};

struct Seen {
  std::vector<std::string> diagnostics;
  std::vector<ir::Motion> motions;
  interpreter::RunResult result;
};

Seen see(const text::Source& source, const ir::ReadResult& read, const ThinProgram* by, const ir::Control& on) {
  Seen seen;
  std::vector<text::Diagnostic> found = read.diagnostics;
  for (text::Diagnostic& one : find_dialect(on.dialect)->validate(read.program, on, ir::Delivery::memory))
    found.push_back(std::move(one));
  if (by != nullptr) by->place(found);
  Motions motions;
  interpreter::RunOptions options;
  if (by != nullptr) options.stretches = &by->stretches;
  seen.result = execute(read.program, on, nullptr, motions, options);
  if (by != nullptr) by->place(seen.result);
  for (const interpreter::RunDiagnostic& one : seen.result.diagnostics) found.push_back(one.diagnostic);
  for (const text::Diagnostic& one : found) seen.diagnostics.push_back(text::format_diagnostic(one, source, ""));
  seen.motions = std::move(motions.all);
  return seen;
}

void expect_like_whole(const std::string& text, const ir::Control& on) {
  const text::Source source("p", text);
  const auto part = ThinProgram::read(source, *find_dialect(on.dialect), on, kShort);
  ASSERT_NE(part, nullptr) << text;
  const Seen a = see(source, find_dialect(on.dialect)->read(source, on), nullptr, on);
  const Seen b = see(source, part->read_result, part.get(), on);
  EXPECT_EQ(a.diagnostics, b.diagnostics) << text;
  EXPECT_EQ(a.result.blocks, b.result.blocks) << text;
  EXPECT_EQ(a.result.ended, b.result.ended) << text;
  ASSERT_EQ(a.motions.size(), b.motions.size()) << text;
  for (std::size_t i = 0; i < a.motions.size(); ++i) {
    ASSERT_EQ(a.motions[i].place.line, b.motions[i].place.line) << text;
    ASSERT_EQ(a.motions[i].end, b.motions[i].end) << a.motions[i].place.line << "\n" << text;
    ASSERT_EQ(a.motions[i].comp, b.motions[i].comp) << text;
    ASSERT_EQ(a.motions[i].feed, b.motions[i].feed) << text;
    ASSERT_EQ(a.motions[i].kind, b.motions[i].kind) << text;
  }
}

TEST(ThinProgram, IsTheWholeProgramWhateverIsInEffect) {
  const std::vector<std::string> before = {"G90\nG1 X0. F100.\n",
                                           "G91\nG1 X0. F100.\n",
                                           "G0 X1.\n",
                                           "G20 G90\nG1 X0. F10.\n",
                                           "G90 G41 D1\nG1 X5. F200.\n",
                                           "G1 X1. F0\n",
                                           "G81 X1. Y1. Z-5. R2. F50.\n",
                                           "G95 G1 X1.\n",
                                           "G18 G2 X4. Z1. I2. K0. F100.\nG1\n"};
  std::mt19937 random(7);
  for (const std::string& dialect : dialect_names()) {
    const ir::Control on = control(dialect, ir::MachineKind::mill);
    const bool siemens = dialect == "sinumerik-840d";
    for (const std::string& state : before) {
      if (siemens && (state.starts_with("G81") || state.starts_with("G20"))) continue;
      for (const std::string code : {"", "G1 ", "G01"}) {
        const std::string head = siemens ? "" : "%\nO1\n";
        const std::string body = state + moves(random, 60, code, random() % 2 == 0) + "M8\n" +
                                 moves(random, 40, code, false) + "G0 Z50.\nM30\n";
        expect_like_whole(head + "G21 G17\nS500 M3\n" + body, on);
      }
    }
  }
}

TEST(ThinProgram, HasNeitherArcsNorFeedsOfAStretch) {
  for (const std::string& dialect : dialect_names()) {
    const ir::Control on = control(dialect, ir::MachineKind::mill);
    const std::string head = dialect == "sinumerik-840d" ? "G710" : "%\nO1\nG21";
    for (unsigned seed = 1; seed <= 20; ++seed) {
      Cuts cuts(seed);
      const std::string text = head + cuts.program(300, 200) + "G91 G1 X1. Y1. Z1.\nG90 G0 Z50.\nM30\n";
      expect_like_whole(text, on);
      if (HasFatalFailure()) return;
      const text::Source source("p", text);
      EXPECT_EQ(see(source, find_dialect(dialect)->read(source, on), nullptr, on).result.ended, interpreter::Ended::end)
          << "the whole program ends with an alarm: " << text;
    }
  }
}

// The last lines of the stretch, which are kept, do not state Z.
TEST(ThinProgram, LeavesAnAxisUnknownThatItMovedUnseen) {
  std::string text = "%\nO1\nG21 G17 G90 G94\nG0 X0. Y0. Z5.\nG1 Z1. F100.\n";
  for (int i = 0; i < 40; ++i) text += "X" + std::to_string(i) + ". Y1. Z" + std::to_string(i) + ".\n";
  for (int i = 0; i < 40; ++i) text += "X" + std::to_string(i) + ". Y2.\n";
  text += "M8\nM30\n%\n";
  const ir::Control on = control("fanuc", ir::MachineKind::mill);
  const auto part = thin(text, on);
  ASSERT_NE(part, nullptr);
  const ir::Program& program = part->read_result.program;
  const facts::Resolved known(program, on);
  const auto coolant = std::ranges::find(program.statements, 86U, &ir::Statement::line);
  ASSERT_NE(coolant, program.statements.end());
  const facts::Facts* at_end = known.before(static_cast<std::uint32_t>(coolant - program.statements.begin()));
  ASSERT_NE(at_end, nullptr);
  EXPECT_TRUE((*at_end)[facts::Number::x].is(39.0));
  EXPECT_FALSE((*at_end)[facts::Number::z].is_certain());
}

TEST(ThinProgram, RunsAStretchEachTimeThatItComesBy) {
  std::mt19937 random(3);
  expect_like_whole("%\nO1\n#1=0\nS500 M3\nWHILE [#1LT3] DO1\nG91 G1 F100.\n" + moves(random, 40, "", false) +
                        "#1=#1+1\nEND1\nM30\n%\n",
                    control("fanuc", ir::MachineKind::mill));
}

TEST(ThinProgram, LeavesOutLinesThatLookLikeThoseThatItKeeps) {
  std::mt19937 random(5);
  const ir::Control on = control("fanuc", ir::MachineKind::mill);
  std::string text = "%\nO1\nG1 X0. F100.\n";
  for (int i = 0; i < 30; ++i) text += "X" + std::to_string(i) + ".\n";
  text += "X1. Y2.\n";  // another look: kept
  for (int i = 0; i < 30; ++i) text += "X" + std::to_string(i) + ".\n";
  text += "X1. F50.\nM30\n%\n";
  const auto part = thin(text, on);
  ASSERT_NE(part, nullptr);
  ASSERT_EQ(part->stretches.all.size(), 2U);
  EXPECT_EQ(part->stretches.all[0].line, 11U);
  EXPECT_EQ(part->stretches.all[0].line_count, 21U);
  EXPECT_NE(part->read_result.program.source.text().find("X1. Y2."), std::string::npos);
}

TEST(ThinProgram, IsReadWholeWhereBlocksAreTakenByName) {
  std::mt19937 random(9);
  const std::string m = moves(random, 60, "G1 ", true);
  const ir::Control mill = control("fanuc", ir::MachineKind::mill);
  const ir::Control siemens = control("sinumerik-840d", ir::MachineKind::mill);
  for (const std::string taker : {"GOTO 1100\n", "G66 P9000\n", "G93\n", "M98 P1 Q1100\n"})
    EXPECT_EQ(thin("%\nO1\nF100.\n" + m + taker + "M30\n%\n", mill), nullptr) << taker;
  for (const std::string taker : {"GOTOB N1100\n", "MCALL DRILL\n", "REPEAT N1000 N1100\n", "CYCLE95(\"A:B\")\n"})
    EXPECT_EQ(thin("F100\n" + m + taker + "M30\n", siemens), nullptr) << taker;
  EXPECT_NE(thin("%\nO1\nF100.\n" + m + "M30\n%\n", mill), nullptr);
  const std::string shape = "G71 U1. R1.\nG71 P1000 Q1590 U1. W1. F.2\n";
  const ir::Control lathe = control("fanuc", ir::MachineKind::lathe);
  std::string profile;
  for (int i = 0; i < 60; ++i)
    profile += "N" + std::to_string(1000 + 10 * i) + " G1 X" + std::to_string(i) + ". Z-" + std::to_string(i) + ".\n";
  EXPECT_EQ(thin("%\nO1\n" + shape + profile + "M30\n%\n", lathe), nullptr);
  EXPECT_NE(thin("%\nO1\n" + profile + "M30\n%\n", lathe), nullptr);
}

TEST(ThinProgram, FaultsOfAStretchHaveTheirOwnPlace) {
  // The radius of the tool does not fit into a corner of the stretch.
  std::string text = "G17 G90 G710 G94\nT1 D1\nS500 M3\nG1 G41 X0 Y0 F100\n";
  for (int i = 1; i < 40; ++i) text += "X" + std::to_string(i) + ". Y" + std::to_string(i % 2) + ".\n";
  text += "G40 X60 Y60\nM30\n";
  expect_like_whole(text, control("sinumerik-840d", ir::MachineKind::mill));
}

// Every control to every other one: what is written without the stretches is what is written of the whole.
TEST(ThinProgram, IsTranslatedAsTheWholeProgram) {
  std::mt19937 random(11);
  std::size_t programs = 0;
  std::size_t thin_ones = 0;
  for (const std::string& from : dialect_names()) {
    for (const std::string& to : dialect_names()) {
      if (from == to) continue;
      for (const std::string code : {"", "G1 ", "G01"}) {
        const std::string head = from == "sinumerik-840d" ? "G710" : "%\nO1\nG21";
        const std::string text = head + " G17 G90 G94 G40\nT1 M6\nG54\nS500 M3\nG0 X0. Y0.\nG1 X1. F100.\n" +
                                 moves(random, 80, code, random() % 2 == 0) + "G91\n" + moves(random, 40, code, false) +
                                 "G90 G0 Z50.\nM30\n";
        const ConvertRequest request{.source = text::Source("p", text),
                                     .from = control(from, ir::MachineKind::mill),
                                     .to = control(to, ir::MachineKind::mill)};
        const auto made = convert_thin(request, kShort);
        const ConvertResult whole = convert_whole(request);
        ++programs;
        if (!made) continue;
        ++thin_ones;
        EXPECT_EQ(made->text, whole.text);
        EXPECT_EQ(made->origin_lines, whole.origin_lines);
        EXPECT_EQ(messages_of(made->diagnostics, request.source), messages_of(whole.diagnostics, request.source));
        EXPECT_EQ(made->not_verified, whole.not_verified);
      }
    }
  }
  EXPECT_GE(programs, 60U);
  EXPECT_EQ(thin_ones, programs) << "no program should have to be translated as a whole";
}

TEST(ThinProgram, WithArcsAndFeedsIsTranslatedAsTheWholeProgram) {
  std::size_t thin_ones = 0;
  for (const std::string& from : dialect_names()) {
    for (const std::string& to : dialect_names()) {
      if (from == to) continue;
      for (unsigned seed = 1; seed <= 4; ++seed) {
        Cuts cuts(seed);
        const std::string head = from == "sinumerik-840d" ? "G710" : "%\nO1\nG21";
        const std::string text = head + cuts.program(400, 200) + "G90 G0 Z50.\nM30\n";
        const ConvertRequest request{.source = text::Source("p", text),
                                     .from = control(from, ir::MachineKind::mill),
                                     .to = control(to, ir::MachineKind::mill)};
        const auto made = convert_thin(request, kShort);
        if (!made) continue;
        ++thin_ones;
        const ConvertResult whole = convert_whole(request);
        EXPECT_EQ(made->text, whole.text) << from << " to " << to;
        EXPECT_EQ(made->origin_lines, whole.origin_lines);
        EXPECT_EQ(messages_of(made->diagnostics, request.source), messages_of(whole.diagnostics, request.source));
      }
    }
  }
  EXPECT_GE(thin_ones, 40U) << "most of them should not have to be translated as a whole";
}

TEST(ThinProgram, IsTranslatedAsAWholeWhereALineIsWrittenInAnotherForm) {
  std::mt19937 random(13);
  // An increment of SINUMERIK's diameter axis becomes U on a Fanuc lathe.
  const std::string text =
      "G90 G18 G710 G95 DIAMON\nT1 D1\nS500 M3\nG1 X1. F.2\nG91\n" + moves(random, 60, "", false) + "M30\n";
  const ConvertRequest request{.source = text::Source("p", text),
                               .from = control("sinumerik-840d", ir::MachineKind::lathe),
                               .to = control("fanuc", ir::MachineKind::lathe)};
  EXPECT_FALSE(convert_thin(request, kShort).has_value());
}

TEST(ThinProgram, KnowsALineOfPlainMoves) {
  const auto letters = [](const char* line) { return move_form_of(line).letters; };
  EXPECT_EQ(letters("X1.Y-2.5"), "XY");
  EXPECT_EQ(letters("N10 G01 X.5 Z3."), "XZ");
  EXPECT_EQ(move_form_of("N10 G01 X.5 Z3.").number, "10");
  EXPECT_EQ(move_form_of("N10 G01 X.5 Z3.").words, "X.5 Z3.");
  EXPECT_EQ(letters("X1. F100"), "Xf");
  EXPECT_EQ(letters("G1X1.F12.5"), "XF");
  EXPECT_EQ(letters("G03 X1. Y2. I.5 J-1."), "XYIJ");
  for (const char* other :
       {"",       "X1",     "X",    "X#1",    "X1.F0.", "X1.F1.2.3", "F100.", "G2X1.",  "X1.I1.", "G2X1.I1.A1.",
        "G10X1.", "X1.X2.", "/X1.", "X1.(A)", "NX1.",   "X1.2.3",    "X-.",   "X1. M8", "G1",     "x1."})
    EXPECT_EQ(letters(other), "") << other;
}

}  // namespace
}  // namespace dripfeed::compile::test

// A text that is run while it is read gives what the same text gives when it is read whole: motions, counts, reports,
// and the place of every diagnostic. The oracle is the whole reading. Next to it: long plain programs take no memory.
#include "dialects/compile/dialect/stream.h"

#include <atomic>
#include <cstdlib>
#include <new>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/stream_runs.h"

namespace {
std::atomic<std::uint64_t> requests{0};
}  // namespace

void* operator new(std::size_t size) {
  ++requests;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++requests;
  return std::malloc(size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace dripfeed::compile {
namespace {

constexpr std::uint64_t kMostBlocks = 100'000;

void expect_same(const std::string& text, const Dialect& dialect, const ir::Control& control) {
  for (const std::size_t piece : {std::size_t{7}, std::size_t{4096}, text.size() + 1})
    ASSERT_EQ(test::difference_of_stream(text, piece, dialect, control, kMostBlocks), "") << text;
}
bool reads_whole(const std::string& text, const Dialect& dialect, const ir::Control& control) {
  return test::run_stream(text, 64, dialect, control, kMostBlocks).was_whole;
}

const Dialect& fanuc() { return *find_dialect("fanuc"); }
const Dialect& sinumerik() { return *find_dialect("sinumerik-840d"); }

TEST(Stream, AlmostEverySpellingOfAPlainBlock) {
  for (const ir::MachineKind kind : {ir::MachineKind::mill, ir::MachineKind::lathe}) {
    const ir::Control control = fanuc().control(kind, ir::GSystem::a);
    const std::string text =
        "\n %O7\nO0012 (PLAIN)\nN1 G21 G40 G17\nN10G00X1.Z-2.S500M3\r\nG54 G1 X 1.5 Z+3 F.2 ; "
        "X2.\n\r\rX-.5(NOTE)Z0.25\n"
        "U1.W-1.\nY5.\nG04 P500\nG28 U0 W0\nM88\nG05.1 Q1\nM8\nT0101\nG02 X5. Z5. R5.\nX100\nM30\nX1.\n%\n";
    expect_same(text, fanuc(), control);
    EXPECT_FALSE(reads_whole(text, fanuc(), control));
  }
}

TEST(Stream, GoesOnInTheWholeProgram) {
  const ir::Control control = fanuc().control(ir::MachineKind::mill, ir::GSystem::a);
  const std::string text = "O1\nG21 G90 G00 X0. Y0.\nN5 G01 X1. F100.\n#1=1\nN20 X#1\n#1=#1+1\nIF[#1LT4]GOTO20\nM30\n";
  expect_same(text, fanuc(), control);
  EXPECT_TRUE(reads_whole(text, fanuc(), control));
  // The jump leads back into what was scanned.
  expect_same("O1\nG21 G90\nN5 X1.\nY2.\n#1=#1+1\nIF[#1LT4]GOTO5\nM30\n", fanuc(), control);
}

// A spline is made when it has ended; the move that it leaves tangentially was streamed before.
TEST(Stream, SplinesAreTheSame) {
  const ir::Control control = sinumerik().control(ir::MachineKind::mill, ir::GSystem::a);
  for (const char* code : {"ASPLINE", "BSPLINE", "CSPLINE"})
    expect_same("G17 G90 G94 G1 X0 Y0 Z0 F500\nX5 Y1\n" + std::string(code) +
                    " X10 Y5\nM8\nX20 Y-3 Z2\nX30 Y0\nX40 Y2\nG1 X50\nX60\nM30\n",
                sinumerik(), control);
}

// Blocks of plain words under POLY are streamed, and those of polynomials are not.
TEST(Stream, PolynomialsAreTheSame) {
  const ir::Control control = sinumerik().control(ir::MachineKind::mill, ir::GSystem::a);
  const std::string text =
      "G17 G90 G94 G1 X0 Y0 Z0 F500\nX5 Y1\nPOLY\nX9\nPO[X]=(10) PO[Y]=(0,-4) PL=5\nX20 Y4\nZ3 F200\n"
      "PO[Y]=(IC(3),R1)\nX40 Y2\nG1 X50\nM30\n";
  expect_same(text, sinumerik(), control);
  EXPECT_TRUE(reads_whole(text, sinumerik(), control));
}

// What is written of a length before it is forgotten in both.
TEST(Stream, MeasuringAToolIsTheSame) {
  const ir::Control control = fanuc().control(ir::MachineKind::mill, ir::GSystem::a);
  expect_same("O1\nG21 G90 G94 G17 G43 H1\nG00 X0. Y0. Z9.\nG37 Z-400.\nX5.\nG01 Z1. F9.\nX9.\nM30\n", fanuc(),
              control);
  expect_same("O1\nG21 G90 G94 G17 G43 H1\n#2001=5.\nG00 Z9.\nG37 Z-4.\n#1=#2001\nX#1\nZ1.\nM30\n", fanuc(), control);
}

TEST(Stream, SaysWhatTheReaderSays) {
  const ir::Control mill = fanuc().control(ir::MachineKind::mill, ir::GSystem::a);
  for (const char* text : {"",
                           "%",
                           "\n\n",
                           "G01 X1.",
                           "X1.\nM30",
                           "G01 X1. Y\nM30\n",
                           "G01 X1.2.3\nM30\n",
                           "G77 X1.\nM30\n",
                           "G02 X1. R.1\nM30\n",
                           "(A (B) C)\nM30\n",
                           "(NOT CLOSED\nM30\n",
                           "X123456789\nM30\n",
                           "M98 P1\nM30\n",
                           "G65 P1 X1.\nM30\n",
                           "/X1.\nM30\n",
                           "N1.5 X1.\nM30\n",
                           "G54.1 P2 X1.\nM30\n",
                           "G91X1.\nM99\n",
                           "X1.\nM99 P7\n",
                           "M30 M02\n",
                           "G01 X1. F0\nM30\n",
                           "%\nO1\n%\nX1.\n",
                           "g01 x1.\nM30\n",
                           "X--1.\nM30\n",
                           "X1.Y2.;X3.\n;\nM30\n"})
    expect_same(text, fanuc(), mill);
  const ir::Control lathe = fanuc().control(ir::MachineKind::lathe, ir::GSystem::a);
  for (const char* text : {"G00 X20. Z5.\nG34 Z-30. F2. K0.1\nZ-60. F4. K0.1\nG01 X30.\nM30\n",
                           "G00 X20. Z5.\nG34 Z-50. F2. K-0.1\nM30\n"})
    expect_same(text, fanuc(), lathe);
  const Dialect& m80 = *find_dialect("mitsubishi-m80");
  expect_same("G90 G81 X0. Y0. Z-9. R2. L0 F99.\nG34 X10. Y0. I5. J30. K3\nG35 X0. Y0. I4. J90. K2\nX7.\nG80\nM30\n",
              m80, m80.control(ir::MachineKind::mill, ir::GSystem::a));
}

TEST(Stream, SinumerikPlainBlocks) {
  for (const ir::MachineKind kind : {ir::MachineKind::mill, ir::MachineKind::lathe}) {
    const ir::Control control = sinumerik().control(kind, ir::GSystem::a);
    const std::string text =
        "; head\nN10 G71 G90 G94 G40\ng0 x1 z2.5\nG54 T1 D1\nM6\nS500 M3\nG1 X-1.5 Z+2 F100 ; cut\r\nG2 X5 Z5 I1 "
        "K0\nM88\nG64\n"
        "G4 F0.5\nM30\n";
    expect_same(text, sinumerik(), control);
    EXPECT_FALSE(reads_whole(text, sinumerik(), control));
    for (const char* other :
         {"R1=5\nX=R1\nM30\n", "X10 X20\nM30\n", "G1 X10 CR=5\nM30\n", "G96 S100\nM30\n", "X1EX2\nM30\n",
          "X1 =5\nM30\n", "MSG(\"A\")\nX1 F1\nM2\n", "G1 G0 X1\nM30\n", "%_N_A_MPF\n;$PATH=/_N_MPF_DIR\nX1\nM30\n",
          "G0 X1 Z9\nG35 Z0 K2 F0.1\nZ-9 K1 F0.01\nG1 X5\nM30\n", "/X1\nM30\n", "G1 X\nM30\n", "AA: X1\nM30\n",
          "D1.5\nM30\n", "M17\n", "RET\n", "X1"})
      expect_same(other, sinumerik(), control);
  }
}

// Lines put together at random from parts that are plain, almost plain and not plain at all.
TEST(Stream, RandomProgramsAreTheSame) {
  struct Case {
    const Dialect* dialect;
    std::vector<std::string> parts;
  };
  const Case cases[] = {{&fanuc(),
                         {"G00",
                          "G01",
                          "G2",
                          "G91",
                          "G90",
                          "G20",
                          "G21",
                          "X1.",
                          "X-2",
                          "Y3.25",
                          "Z.5",
                          "Z-.125",
                          "U1.",
                          "R5.",
                          "I1.",
                          "F100.",
                          "S500",
                          "M03",
                          "M5",
                          "M30",
                          "T0101",
                          "N7",
                          "N0008",
                          "(C)",
                          "(U",
                          ";",
                          "/",
                          "#1=2",
                          "X#1",
                          "G65P9",
                          "M98P9",
                          "G43 H1",
                          "G99",
                          "M77",
                          "%",
                          "O5",
                          "E1",
                          "X",
                          "G1.5",
                          "G54.1P1",
                          "A1.",
                          "H2",
                          "G83 Z-1. R1. Q.1",
                          " ",
                          "\t",
                          "IF[#1EQ2]GOTO7",
                          "K1",
                          "+",
                          "X1.5.",
                          "G04X1."}},
                        {&sinumerik(), {"G0",    "G1",     "G2",
                                        "G91",   "G90",    "G70",
                                        "G71",   "X1",     "X-2.5",
                                        "Y3.25", "Z.5",    "z-.125",
                                        "I1",    "F100",   "S500",
                                        "M3",    "M5",     "M30",
                                        "T1",    "D1",     "N7",
                                        "; c",   "/",      "R1=2",
                                        "X=R1",  "L9",     "G54",
                                        "G500",  "M77",    "CR=5",
                                        "A1",    "U1",     "X",
                                        "G1.5",  "DIAMON", "MSG(\"a\")",
                                        " ",     "X1EX1",  "IF R1==2 GOTOF A",
                                        "A:",    "K1",     "+",
                                        "G4F1",  "SUPA",   "M1=3",
                                        "S2=5",  "X1.5."}}};
  std::mt19937 random(20);
  for (const Case& one : cases) {
    for (const ir::MachineKind kind : {ir::MachineKind::mill, ir::MachineKind::lathe}) {
      const ir::Control control = one.dialect->control(kind, ir::GSystem::a);
      for (int n = 0; n < 400; ++n) {
        std::string text;
        for (std::size_t line = 0, lines = random() % 12; line < lines; ++line) {
          // Mostly plain: the first parts of the list.
          for (std::size_t part = 0, parts = random() % 5; part < parts; ++part)
            text += one.parts[random() % (random() % 4 == 0 ? one.parts.size() : 22)] + (random() % 3 == 0 ? "" : " ");
          text += random() % 8 == 0 ? "\r\n" : random() % 20 == 0 ? "\n\r\r" : "\n";
        }
        expect_same(text, *one.dialect, control);
        if (HasFatalFailure()) return;
      }
    }
  }
}

std::string raster(std::size_t blocks, std::string_view eob) {
  std::string text = fmt::format("%{0}O0001{0}G21 G90 G94 G17 G40{0}F3000.{0}G00 X0. Y0. Z5.{0}", eob);
  for (std::size_t i = 0; i < blocks; ++i)
    text += fmt::format("G01 X{}.{:03} Y{}.5 Z-1.{:04}{}", i % 200, i % 1000, i / 200, i % 10000, eob);
  return text + fmt::format("M30{0}%{0}", eob);
}

// Longer than the buffer, so that lines lie across its end, in every form of a line's end.
TEST(Stream, LongProgramsInAllLineEnds) {
  const ir::Control control = fanuc().control(ir::MachineKind::mill, ir::GSystem::a);
  for (const std::string_view eob : {"\n", "\r\n", "\n\r\r", "\r"}) {
    const std::string text = raster(30000, eob);
    const std::string whole = test::run_whole(text, fanuc(), control, kMostBlocks).reported;
    for (const std::size_t piece : {std::size_t{4093}, text.size()}) {
      const test::Streamed streamed = test::run_stream(text, piece, fanuc(), control, kMostBlocks);
      ASSERT_TRUE(streamed.reported == whole) << fmt::format("{:?}", eob).substr(0, 20);
      EXPECT_EQ(streamed.was_whole, eob == "\r");  // without LF the reader is asked
    }
  }
}

// One block so many times, then the end.
class Repeated final : public ProgramText {
 public:
  explicit Repeated(std::size_t blocks) : left_(blocks * kBlock.size()) {}
  std::expected<std::size_t, std::string> read(std::span<char> into) override {
    std::size_t used = 0;
    for (; left_ > 0 && used < into.size(); --left_)
      into[used++] = kBlock[(kBlock.size() - left_ % kBlock.size()) % kBlock.size()];
    for (; left_ == 0 && end_ < kEnd.size() && used < into.size();) into[used++] = kEnd[end_++];
    return used;
  }
  std::expected<std::string, std::string> whole() override { return std::unexpected("never asked"); }

 private:
  static constexpr std::string_view kBlock = "G01 X12.3456 Y-7.25 Z-1.0625 F2500.\n";
  static constexpr std::string_view kEnd = "M30\n";
  std::size_t left_;
  std::size_t end_ = 0;
};

std::uint64_t requests_of(std::size_t blocks) {
  const ir::Control control = fanuc().control(ir::MachineKind::mill, ir::GSystem::a);
  Repeated text(blocks);
  NoMotions no_sink;
  const std::uint64_t before = requests;
  const StreamRun run = execute_stream(text, "t", fanuc(), control, nullptr, no_sink, {});
  EXPECT_EQ(run.result.blocks, blocks + 1);
  EXPECT_EQ(run.result.ended, interpreter::Ended::end);
  return requests - before;
}

TEST(Stream, AMillionBlocksTakeNoMoreMemoryThanAThousand) {
  constexpr std::uint64_t kConstant = 64;
  EXPECT_LE(requests_of(1'000'000), requests_of(1'000) + kConstant);
}

TEST(Stream, AFailedReadEndsTheRun) {
  class Broken final : public ProgramText {
   public:
    std::expected<std::size_t, std::string> read(std::span<char> into) override {
      if (asked_++ > 0) return std::unexpected("the disk is gone");
      std::copy_n("G01 X1. F1.\n", 12, into.data());
      return 12;
    }
    std::expected<std::string, std::string> whole() override { return std::unexpected("the disk is gone"); }

   private:
    int asked_ = 0;
  };
  Broken text;
  NoMotions no_sink;
  const ir::Control control = fanuc().control(ir::MachineKind::mill, ir::GSystem::a);
  const StreamRun run = execute_stream(text, "t", fanuc(), control, nullptr, no_sink, {});
  EXPECT_EQ(run.read_error, "the disk is gone");
  EXPECT_NE(run.result.ended, interpreter::Ended::end);
}

}  // namespace
}  // namespace dripfeed::compile

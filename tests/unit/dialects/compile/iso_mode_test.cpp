// ISO mode of a SINUMERIK: blocks between G291 and G290, and programs that are called there. The oracle is the Function
// Manual ISO Dialects (switching, subprograms, macro programs), and where a run is the same in both languages, the same
// program in Siemens mode.
#include <string>

#include "dialects/compile/dialect/stream.h"
#include "dialects/compile/translate/convert.h"
#include "tests/support/stream_runs.h"
#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

constexpr std::string_view kHead = "G17 G71 G90 G94 F500\nG0 X0 Y0 Z5\n";

ir::Control iso_mill() {
  ir::Control control = test::control("sinumerik-840d", ir::MachineKind::mill);
  control.semantics.power_on_known = true;
  return control;
}
ir::Control iso_lathe(ir::GSystem g_system) {
  ir::Control control = find_dialect("sinumerik-840d")->control(ir::MachineKind::lathe, g_system);
  control.semantics.power_on_known = true;
  return control;
}

Result after_head(std::string_view text, const Texts& called = {}) {
  return run(std::string(kHead) + std::string(text) + "M30\n", called);
}

// The moves without their lines.
std::string path(const Result& ran) {
  std::string out;
  const std::string all = moves(ran);
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = all.find('\n', begin);
    out += all.substr(all.find(' ', begin) + 1, end - all.find(' ', begin));
    begin = end + 1;
  }
  return out;
}

std::vector<text::Diagnostic> faults_of(const std::string& text, const ir::Control& control = iso_mill()) {
  const Dialect& dialect = *find_dialect("sinumerik-840d");
  ir::ReadResult read = dialect.read(text::Source("TEST.MPF", text), control);
  std::vector<text::Diagnostic> found = std::move(read.diagnostics);
  for (text::Diagnostic& d : dialect.validate(read.program, control, ir::Delivery::memory))
    found.push_back(std::move(d));
  return found;
}
bool has_alarm(const std::vector<text::Diagnostic>& found, std::string_view alarm) {
  return std::ranges::any_of(found, [&](const text::Diagnostic& d) { return d.alarm == alarm; });
}
// Alarms of the lines between the switches.
std::string alarm_in(const std::string& block) {
  const std::string head = "G17 G71 G90 G94 F100 T1 D1\nG0 X0 Y0 Z5\nG291\nG54 G90 G94 G17 G21\n";
  std::string alarms;
  for (const text::Diagnostic& d : faults_of(head + block + "\nG290\nM30\n"))
    if (d.severity == text::Severity::error) alarms += d.alarm + ' ';
  return alarms;
}

TEST(IsoMode, BlocksBetweenTheSwitchesAreRun) {
  const Result ran = after_head(
      "G291\n(G290 in a comment) G90 G0 X10. Y5. ; G290\nG81 Z-5. R2. F100.\nX20.\nG80\nG02 X30. Y15. R10. F200.\n"
      "G290\nG2 X40 Y25 CR=10\n");
  EXPECT_EQ(moves(ran),
            "2 rapid X0.0000 Y0.0000 Z5.0000\n"
            "4 rapid X10.0000 Y5.0000 Z5.0000\n"
            "5 rapid X10.0000 Y5.0000 Z2.0000\n"
            "5 linear X10.0000 Y5.0000 Z-5.0000 F100.0000/min\n"
            "5 rapid X10.0000 Y5.0000 Z5.0000\n"
            "6 rapid X20.0000 Y5.0000 Z5.0000\n"
            "6 rapid X20.0000 Y5.0000 Z2.0000\n"
            "6 linear X20.0000 Y5.0000 Z-5.0000 F100.0000/min\n"
            "6 rapid X20.0000 Y5.0000 Z5.0000\n"
            "8 arc-cw X30.0000 Y15.0000 Z5.0000 G17 I10.0000 J0.0000 K0.0000 F200.0000/min\n"
            "10 arc-cw X40.0000 Y25.0000 Z5.0000 G17 I10.0000 J0.0000 K0.0000 F200.0000/min\n");
  EXPECT_TRUE(std::ranges::all_of(ran.result.not_interpreted, &interpreter::NotInterpreted::effects_known));
  EXPECT_EQ(ran.result.blocks, 11U);
}

// "Switching": active offsets, planes and modes stay as they are.
TEST(IsoMode, ModesStayThroughTheSwitch) {
  EXPECT_EQ(path(after_head("G91 G1 X1\nG291\nX1.\nG20 X1.\nG290\nX1\n")),
            path(after_head("G91 G1 X1\nX1\nG700 X1\nX1\n")));
  EXPECT_EQ(path(after_head("TRANS X10\nG1 X1\nG291\nX2.\nG290\nX3\n")),
            path(after_head("TRANS X10\nG1 X1\nX2\nX3\n")));
}

// "Macro programs": PROC in its first block makes a called program one of Siemens mode, which reads what was passed in
// $C_X; a program of ISO mode goes to Siemens mode by G290 to do so.
TEST(IsoMode, MacrosReadTheirArguments) {
  const Texts called = {{"O0010", "PROC M0010\nDEF REAL XA\nXA=$C_X\nIF $C_Z_PROG==0\nG1 X=XA Y=$C_Y\nENDIF\nM17\n"},
                        {"O0011", "G290\nR1=$C_X+$C_Z_PROG\nG291\nG1 X5.\nM99\n"}};
  const Result ran = after_head("G291\nG65 P10 X55. Y44.\nG65 P11 X3. Z1.\nG290\nG1 Y=R1\n", called);
  EXPECT_EQ(path(ran),
            "rapid X0.0000 Y0.0000 Z5.0000\n"
            "linear X55.0000 Y44.0000 Z5.0000 F500.0000/min\n"
            "linear X5.0000 Y44.0000 Z5.0000 F500.0000/min\n"
            "linear X5.0000 Y4.0000 Z5.0000 F500.0000/min\n");
  // A letter is a letter, in whatever order they stand.
  const Texts one = {{"O0012", "PROC O0012\nR1=$C_I R2=$C_K R3=10+$C_D R4=10+$C_D_PROG\nM17\n"}};
  const Result letters = after_head("G291\nG65 P12 K3. I4.\nG290\n", one);
  EXPECT_EQ(letters.value("R1"), 4.0);
  EXPECT_EQ(letters.value("R2"), 3.0);
  EXPECT_EQ(letters.value("R3"), 10.0);
  EXPECT_EQ(letters.value("R4"), 10.0);
  // Outside of a macro nothing was passed.
  EXPECT_TRUE(after_head("R1=$C_X\n").names("$C_X"));
}

TEST(IsoMode, ModalMacrosFollowEachMove) {
  const Texts called = {{"O0010", "PROC M0010\nG91\nG0 Z=$C_Z\nG90\nM17\n"}};
  EXPECT_FALSE(after_head("G291\nG66 P10 Z-1.\nG0 X1.\nX2.\nG67\nG290\n", called)
                   .names("a modal cycle or call that continues in the control's other language"));
  EXPECT_EQ(path(after_head("G291\nG66 P10 Z-1.\nG0 X1.\nX2.\nG67\nX3.\nG290\n", called)),
            path(after_head("G0 X1\nZ4\nX2\nZ3\nX3\n")));
}

// "Subprograms": M98 with a number of passes, and ISOCALL from Siemens mode; M99 and M17 return.
TEST(IsoMode, SubprogramsAreCalledAndReturn) {
  const Texts called = {{"O0021", "G91 G1 X1. Y1.\nM98 P0022 L2\nG90\nM99\n"},
                        {"O0022", "G1 X3.\nM17\nG1 X99.\n"},
                        {"SUB", "%\nO7\nG0 X9. Y0.\nM98 P21\nM99\n%\n"}};
  const Result ran = after_head("G291\nM98 P21\nG290\nISOCALL \"SUB\"\nG0 X0\n", called);
  EXPECT_EQ(path(ran), path(after_head("G1 X1 Y1\nX4\nX7\nG0 X9 Y0\nG1 X10 Y1\nX13\nX16\nG0 X0\n")));
  EXPECT_EQ(ran.result.ended, interpreter::Ended::end);
  EXPECT_EQ(alarm_of(after_head("ISOCALL \"NOWHERE\"\n")), "14011");
  EXPECT_EQ(path(after_head("DEF STRING[20] NAME=\"SUB\"\nISOCALL NAME\n", called)),
            path(after_head("G0 X9 Y0\nG1 X10 Y1\nX13\nX16\n")));
}

// What ISO mode takes of Siemens mode: calls (Diagnostics Manual, alarm 12710). What they call begins in ISO mode, too.
TEST(IsoMode, CallsAreWrittenAsInSiemensModeToo) {
  const Texts called = {{"SUB", "G0 X9. Y0.\nM99\n"}, {"RUN", "PROC RUN(REAL XA)\nG0 X=XA\nM17\n"}};
  EXPECT_EQ(path(after_head("G291\nG0 X1.\nSUB\nY2.\nN9 RUN(4)\nCALL \"SUB\"\nY3.\nG290\nG0 X=1+1\n", called)),
            path(after_head("G0 X1\nX9 Y0\nY2\nX4\nX9 Y0\nY3\nX2\n")));
}

TEST(IsoMode, SwitchesThatBlockSkipLeavesOutAreReported) {
  const std::string_view name = "a switch of the language that block skip leaves out";
  EXPECT_FALSE(after_head("G291\nG0 X1.\n/G290\nG0 X2\n").names(name));
  EXPECT_TRUE(run_on(iso_mill(), std::string(kHead) + "G291\nG0 X1.\n/G290\nG0 X2\nM30\n", {}, {}, 100, 2).names(name));
}

TEST(IsoMode, SwitchesStandAlone) {
  EXPECT_TRUE(text::has_error(faults_of("G17 G71 G90 G94\nG291 G0 X1\nG290\nM30\n")));
  EXPECT_TRUE(text::has_error(faults_of("G17 G71 G90 G94\nX3 G291\nG290\nM30\n")));
  EXPECT_TRUE(text::has_error(faults_of("G17 G71 G90 G94\nG291\nG0 X1.\nG290 X5.\nG290\nM30\n")));
  EXPECT_EQ(path(after_head("N10 G291 ;c\ng0 x1.\nG291 (again)\nX2.\nN20 G290 (back)\nX=3\n")),
            path(after_head("G0 X1\nX2\nX3\n")));
  EXPECT_EQ(path(after_head("G291\nG0 X1.\n:20 G290\nX=3\n")), path(after_head("G0 X1\nX3\n")));
  // A text that is executed does not change the language of the blocks after it.
  EXPECT_TRUE(after_head("EXECSTRING(\"G291\")\nG0 X1\n").names("EXECSTRING"));
}

// Which frame lies in which is not followed: it is reported. A code that takes nothing back is no frame.
TEST(IsoMode, FramesOfBothLanguagesAreReported) {
  const std::string_view name = "a frame of one of the control's languages together with one of the other";
  EXPECT_EQ(path(after_head("ROT RPL=90\nG291\nG69 G50\nG0 X2. Y0.\nG290\n")),
            path(after_head("ROT RPL=90\nG0 X2 Y0\n")));
  EXPECT_TRUE(after_head("ROT RPL=90\nG291\nG68 X0. Y0. R90.\nG290\n").names(name));
  EXPECT_TRUE(after_head("TRANS X5\nG291\nG52 X10.\nG290\n").names(name));
  EXPECT_TRUE(after_head("G291\nG68 X0. Y0. R90.\nG290\nATRANS X1\n").names(name));
  EXPECT_TRUE(after_head("G291\nG68 X0. Y0. R90.\nG290\n$P_PFRAME=CTRANS(X,5)\n").names(name));
  const Result apart =
      after_head("TRANS X5\nG0 X1\nTRANS\nG291\nG68 X0. Y0. R90.\nX1. Y0.\nG69\nG290\nTRANS X5\nX1 Y0\n");
  EXPECT_FALSE(apart.names(name));
  EXPECT_EQ(path(apart), path(after_head("G0 X6\nX0 Y1\nX6 Y0\n")));
  EXPECT_TRUE(
      after_head("G291\nG16 X10. Y30.\nG290\n").names("polar words (G16) that go on in the control's other language"));
}

// The % of a tape ends nothing but the tape.
TEST(IsoMode, TapeMarksEndNoPart) {
  EXPECT_EQ(path(after_head("G291\n%\nO1(HEAD)\nG0 X1.\n%\nO0002 X2.\nG290\nX3\nG291\nX5.\nG290\n")),
            path(after_head("G0 X1\nX2\nX3\nX5\n")));
  const std::string text =
      "G17 G71 G90 G94\nR1=1\nIF R1>0 GOTOF NXT\nG291\nM30\nG290\nNXT: G0 X1 Y0\nG291\nG0 X2.\nG290\nM30\n";
  for (const text::Diagnostic& d : faults_of(text))
    EXPECT_TRUE(d.id != text::DiagnosticId::unreachable || d.span.begin < text.find("NXT: ")) << text::message_of(d);
}

// A file with its head begins in ISO mode where it is called there, and so does each of a stream on a machine that
// wakes it.
TEST(IsoMode, HeadsDoNotEndIt) {
  ir::Control counts = iso_mill();
  counts.semantics.iso_decimal_mode = ir::DecimalMode::least_increment;
  const Texts called = {{"O0010", "%_N_O0010_SPF\n;$PATH=/_N_SPF_DIR\nG0 X5000\nM99\n"}};
  EXPECT_TRUE(
      moves(run_on(counts, std::string(kHead) + "G291\nM98 P10\nG290\nM30\n", called)).contains("3 rapid X5.0000"));
  counts.semantics.starts_in_iso_mode = true;
  EXPECT_TRUE(run_on(counts, "%_N_MAIN_MPF\nG0 X0 Y3000 Z0\nM30\n").trace.contains("Y3.0000"));
}

// RET and M99 leave whole programs, whatever parts they have.
TEST(IsoMode, PartsAreLeftWithTheirPrograms) {
  const Texts called = {{"SUBA", "G291\nM98 P22\nG0 X8.\nG290\nX9\nM17\n"}, {"O0022", "G290\nRET(,,2)\n"}};
  EXPECT_EQ(path(after_head("SUBA\nX3\n", called)), path(after_head("X3\n")));
  const Result across = after_head("G291\nM99 P50\nG290\nN50 G0 X3\n");
  EXPECT_EQ(across.result.ended, interpreter::Ended::alarm);
  EXPECT_EQ(alarm_of(across), "");  // not one of the control's: it is the run that does not know
  EXPECT_TRUE(after_head("G291\nG0 X1.\nM30\nG290\n").trace.contains("5 end"));
}

// Called programs that stand in the same text: of those in Siemens mode PROC says so.
TEST(IsoMode, FilesOfOneStreamAreFound) {
  const std::string main = "%_N_MAIN_MPF\n" + std::string(kHead) + "G291\nM98 P12\nG290\nM30\n%_N_O0012_SPF\n";
  EXPECT_TRUE(run(main + "PROC O0012\nG0 X=1+1\nM17\n").trace.contains("rapid X2.0000"));
  const Texts other = {{"O0012", "G0 X9.\nM99\n"}};
  EXPECT_EQ(alarm_of(run(main + "G0 X1.\nM17\n", other)), "14011");
}

// One program may have thousands of parts, each as cheap as a call.
TEST(IsoMode, ManyPartsAreManyCalls) {
  std::string text(kHead);
  for (int n = 0; n < 20'000; ++n) text += "G291\nG1 X1.\nG290\nX2\n";
  const Result ran = run(text + "M30\n");
  EXPECT_EQ(ran.result.blocks, 80'003U);
  EXPECT_EQ(ran.result.ended, interpreter::Ended::end);
}

// A part of a program is no level of calls: the control takes 16.
TEST(IsoMode, PartsAreNoLevels) {
  Texts called;
  for (int n = 1; n <= 14; ++n) {
    const std::string name = "O00" + std::string(n < 10 ? "0" : "") + std::to_string(n);
    called.emplace(name, n == 14 ? "G1 X1.\nM99\n" : "M98 P" + std::to_string(n + 1) + "\nM99\n");
  }
  const Result ran = after_head("G291\nM98 P1\nG290\n", called);
  EXPECT_EQ(ran.result.ended, interpreter::Ended::end) << alarm_of(ran);
  EXPECT_TRUE(path(ran).contains("linear X1.0000"));
}

TEST(IsoMode, ProgramEndsWhereItsPartSaysSo) {
  EXPECT_EQ(path(after_head("G291\nG0 X1.\nM30\nG0 X2.\nG290\nG0 X3\n")), path(after_head("G0 X1\n")));
  // M30 of a subprogram returns on this control.
  EXPECT_EQ(path(after_head("ISOCALL \"SUB\"\nG0 X3\n", {{"SUB", "G0 X1.\nM30\n"}})), path(after_head("G0 X1\nX3\n")));
  // M99 of the main program starts it again, without end.
  EXPECT_TRUE(std::ranges::any_of(after_head("G291\nG0 X1.\nM99\nG290\n").result.diagnostics,
                                  [](const interpreter::RunDiagnostic& d) {
                                    return d.line == 5 && d.diagnostic.id == text::DiagnosticId::endless_loop;
                                  }));
  // M99 P of the main program goes to its own block.
  EXPECT_EQ(path(after_head("G291\nM99 P7\nG0 X2.\nN7 G0 X3.\nG290\n")), path(after_head("G0 X3\n")));
}

TEST(IsoMode, NumbersWithoutAPointCountAsTheMachineSays) {
  ir::Control counts = iso_mill();
  counts.semantics.iso_decimal_mode = ir::DecimalMode::least_increment;
  const std::string text = std::string(kHead) + "G291\nG0 X10\nX10.\nG290\nG0 X10 Y1\nM30\n";
  EXPECT_TRUE(moves(run_on(counts, text)).contains("4 rapid X0.0100"));
  EXPECT_TRUE(moves(run_on(counts, text)).contains("7 rapid X10.0000"));
  EXPECT_TRUE(moves(run_on(iso_mill(), text)).contains("4 rapid X10.0000"));
}

// ISO turning: U and W are increments in G-code system A, G90 is absolute in B; X stays a diameter.
TEST(IsoMode, LathesHaveTheirGCodeSystem) {
  const std::string head = "G18 G71 G90 G95 DIAMON\nG0 X50 Z5\nG291\n";
  const std::string end = "G290\nG0 X60 Z9\nM30\n";
  const std::string wanted = path(
      run(head.substr(0, head.size() - 5) + "G1 X40 Z0 F0.2\nX44 Z-3\nG0 X60 Z9\nM30\n", {}, ir::MachineKind::lathe));
  EXPECT_EQ(path(run_on(iso_lathe(ir::GSystem::a), head + "G99 G1 X40. Z0. F0.2\nU4. W-3.\n" + end)), wanted);
  EXPECT_EQ(path(run_on(iso_lathe(ir::GSystem::b), head + "G95 G90 G1 X40. Z0. F0.2\nG91 X4. Z-3.\nG90\n" + end)),
            wanted);
}

TEST(IsoMode, WhatIsNotCarriedOutIsReported) {
  const Result macro = after_head("G291\nG1 X#1\nIF[#1EQ0]GOTO5\nY1.\nN5\nG290\n");
  EXPECT_TRUE(macro.names("Custom Macro B in ISO mode"));
  EXPECT_NE(macro.motions.back().axes_unknown & 1U, 0U);
  const Result cycle = after_head("G291\nG81 X1. Z-1. R1. F100.\nG290\nG0 X5\n");
  EXPECT_TRUE(cycle.names("a modal cycle or call that continues in the control's other language"));
  EXPECT_FALSE(after_head("G291\nG81 X1. Z-1. R1. F100.\nG80\nG290\nG0 X5\n")
                   .names("a modal cycle or call that continues in the control's other language"));
}

// No one reads the part where there is no library: it is kept as written.
TEST(IsoMode, WithoutALibraryThePartIsReported) {
  const ir::Control control = iso_mill();
  const text::Source source("TEST.MPF", std::string(kHead) + "G291\nG0 X1.\nG290\nG0 Y1\nM30\n");
  const ir::ReadResult read = find_dialect(control.dialect)->read(source, control);
  Motions motions;
  const interpreter::RunResult ran = execute(read.program, control, nullptr, motions, {});
  ASSERT_FALSE(ran.not_interpreted.empty());
  EXPECT_EQ(ran.not_interpreted.front().name, "ISO MODE");
  EXPECT_FALSE(ran.not_interpreted.front().effects_known);
  EXPECT_NE(motions.all.back().axes_unknown & 1U, 0U);
}

std::string streamed(const ir::Control& control, const std::string& text, bool whole) {
  ProgramLibrary library(control, {});
  interpreter::RunNames names;
  interpreter::RunOptions options;
  options.names = &names;
  interpreter::TraceWriter writer(control, names);
  if (!whole) {
    Pieces pieces(text, 10);
    const StreamRun run =
        execute_stream(pieces, "TEST.MPF", *find_dialect(control.dialect), control, &library, writer, options);
    return describe(run.result, writer.text(), true);
  }
  const ir::ReadResult read = find_dialect(control.dialect)->read(text::Source("TEST.MPF", text), control);
  const interpreter::RunResult run = execute(read.program, control, &library, writer, options);
  return describe(run, writer.text(), true);
}

TEST(IsoMode, StreamingFindsTheSwitch) {
  const std::string text = "G0 X1 Y0 Z0\nG0 X2\nG291\nG81 X3. Z-1. R1. F100.\nG80\nG290\nG0 X4\nM30\n";
  EXPECT_EQ(streamed(iso_mill(), text, false), streamed(iso_mill(), text, true));
  // A machine whose power-on state is ISO mode has no block of Siemens mode first.
  ir::Control starts = iso_mill();
  starts.semantics.starts_in_iso_mode = true;
  const std::string iso = "O0001\nG21 G0 X1. Y0. Z0.\nG81 X3. Z-1. R1. F100.\nG80\nG290\nG0 X=2*2\nM30\n";
  EXPECT_EQ(streamed(starts, iso, false), streamed(starts, iso, true));
  EXPECT_TRUE(streamed(starts, iso, true).contains("3 linear X3.0000 Y0.0000 Z-1.0000"));
  EXPECT_TRUE(streamed(starts, iso, true).contains("6 rapid X4.0000"));
}

// Diagnostics Manual: 12710 what ISO mode does not know, 12720 and 12722 macro calls, 12740 modal ones.
TEST(IsoMode, FaultsHaveTheirAlarms) {
  EXPECT_EQ(alarm_in("TRANS X10"), "12710 ");
  EXPECT_EQ(alarm_in("X=10"), "12710 ");
  EXPECT_EQ(alarm_in("G65 X1."), "12720 ");
  EXPECT_EQ(alarm_in("G65 P1 G65 P2"), "12722 ");
  EXPECT_EQ(alarm_in("G66 P1\nG66 P2"), "12740 ");
  EXPECT_EQ(alarm_in("G81 X1. Z-1. R1. F100.\nG66 P1"), "12740 ");
  EXPECT_EQ(alarm_in("G66 P1\nG67\nG66 P2\nG67"), "");
  EXPECT_EQ(alarm_in("G81 X1. Z-1. R1. F100.\nG80\nG66 P1\nG67"), "");
  EXPECT_EQ(alarm_in("G65 P1 X1. (TRANS X10)"), "");
  ir::Control parallel = iso_mill();
  parallel.axes = "XYZU";
  EXPECT_TRUE(has_alarm(faults_of("G17 G71 G90 G94\nG291\nG17 X1. U1.\nG290\nM30\n", parallel), "12726"));
  EXPECT_FALSE(has_alarm(faults_of("G17 G71 G90 G94\nG291\nG17 U1. Y1.\nG290\nM30\n", parallel), "12726"));
  // In Siemens mode the same words are none.
  EXPECT_FALSE(has_alarm(faults_of("G17 G71 G90 G94\nTRANS X10\nM30\n"), "12710"));
}

TEST(IsoMode, PlacesAreThoseOfTheText) {
  const std::string text = "G17 G71 G90 G94\nG291\nG0 X1. Y2.\nTRANS X10\nG290\nM30\n";
  const std::vector<text::Diagnostic> found = faults_of(text);
  const auto fault = std::ranges::find(found, "12710", &text::Diagnostic::alarm);
  ASSERT_NE(fault, found.end());
  EXPECT_TRUE(fault->span.in(text).starts_with("T")) << fault->span.in(text);
}

// The blocks that a cycle names may be the last ones before the switch.
TEST(IsoMode, AShapeEndsWithItsPart) {
  const std::string head = "G18 G90 G71 G95 DIAMON F0.2\nT1 D1\nG97 S500 M3\nG0 X50 Z5\nG291\nG0 X42. Z2.\n";
  const std::string cycle = "G71 U2. R0.5\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 X20.\nG1 Z-10. F0.1\nN20 X42.\n";
  const ir::Control control = iso_lathe(ir::GSystem::a);
  const Result last = run_on(control, head + cycle + "G290\nG0 X60\nM30\n");
  const Result before = run_on(control, head + cycle + "S500\nG290\nG0 X60\nM30\n");
  EXPECT_EQ(last.result.ended, interpreter::Ended::end);
  EXPECT_EQ(path(last), path(before));
  EXPECT_GT(last.motions.size(), 20U);
}

TEST(IsoMode, ConvertingKeepsItOrMakesItBlocks) {
  const ir::Control control = iso_mill();
  const std::string text = std::string(kHead) + "G291\nG0 X1.\nG290\nISOCALL \"SUB\"\nM30\n";
  ConvertRequest request{.source = text::Source("TEST.MPF", text), .from = control, .to = control};
  EXPECT_EQ(convert(request).text, text);
  request.to = test::control("fanuc", ir::MachineKind::mill);
  ProgramLibrary library(control, [](std::string_view name) -> std::optional<text::Source> {
    if (name != "SUB") return std::nullopt;
    return text::Source("SUB", "G1 X7. F100.\nM99\n");
  });
  request.library = &library;
  request.mode = ConvertMode::explicit_blocks;
  const ConvertResult blocks = convert(request);
  EXPECT_TRUE(blocks.text.contains("X1.")) << messages_of(blocks.diagnostics, request.source);
  EXPECT_TRUE(blocks.text.contains("X7.")) << blocks.text;
}

}  // namespace
}  // namespace dripfeed::compile::test

// Seeded faults in sample programs of all four dialects, on mill and lathe: a work offset with the wrong sign, a travel
// that is exceeded by thousandths or more, feeds and speeds beyond the machine, tools that it does not have, inches for
// millimetres, centres of arcs that are off. Each is found at its line; the programs themselves, and those that just
// stay within the limit, have no finding at all.
#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "checks/envelope/envelope.h"
#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/execute.h"
#include "dialects/text/number.h"

namespace dripfeed {
namespace {

using text::DiagnosticId;

struct Sample {
  std::string name;
  std::string dialect;
  ir::MachineKind kind = ir::MachineKind::mill;
  std::vector<std::string> lines;

  // The line with that beginning, 1-based.
  [[nodiscard]] std::uint32_t line_of(std::string_view beginning) const {
    const auto found = std::ranges::find_if(lines, [&](const std::string& one) { return one.starts_with(beginning); });
    EXPECT_NE(found, lines.end()) << name << ": " << beginning;
    return static_cast<std::uint32_t>(found - lines.begin()) + 1;
  }
  [[nodiscard]] Sample with(std::string_view line, std::string text) const {
    Sample changed = *this;
    changed.lines.at(line_of(line) - 1) = std::move(text);
    return changed;
  }
};

// Places: T tool change, P approach, L lift, C first cut, X long cut, A arc.
std::vector<Sample> mills() {
  const std::vector<std::string> path = {"G0 X0. Y0. S5000 M3",
                                         "G43 H1 Z50.",
                                         "Z2.",
                                         "G1 Z-5. F300.",
                                         "X100. F1200.",
                                         "G2 X120. Y-20. I0. J-20.",
                                         "G1 Y-80.",
                                         "G2 X100. Y-100. I-20. J0.",
                                         "G1 X0.",
                                         "Y0.",
                                         "G0 Z60.",
                                         "M5"};
  std::vector<Sample> all;
  for (const char* dialect : {"fanuc", "mazak", "mitsubishi-m80"}) {
    Sample one{std::string(dialect) + " mill", dialect, ir::MachineKind::mill, {}};
    one.lines = {"%", "O1", "G21 G17 G90 G94 G40 G49 G80", "T1 M6", "G54"};
    one.lines.insert(one.lines.end(), path.begin(), path.end());
    one.lines.insert(one.lines.end(), {"M30", "%"});
    all.push_back(one);
  }
  Sample sinumerik{"sinumerik mill", "sinumerik-840d", ir::MachineKind::mill, {}};
  sinumerik.lines = {"G71 G17 G90 G94 G40", "T1 M6", "G54"};
  sinumerik.lines.insert(sinumerik.lines.end(), path.begin(), path.end());
  sinumerik.lines.push_back("M30");
  sinumerik.lines.at(sinumerik.line_of("G43") - 1) = "D1 Z50.";
  all.push_back(sinumerik);
  return all;
}

std::vector<Sample> lathes() {
  const std::vector<std::string> path = {
      "G0 X80. Z5.", "G1 Z-50. F0.25", "G2 X100. Z-60. I10. K0.", "G1 X120.", "G0 Z0.", "G1 X10. F0.2", "G0 Z60.",
      "M5"};
  std::vector<Sample> all;
  for (const char* dialect : {"fanuc", "mazak", "mitsubishi-m80"}) {
    Sample one{std::string(dialect) + " lathe", dialect, ir::MachineKind::lathe, {}};
    one.lines = {"%", "O2", "G21 G18 G40 G99", "T0101", "G54", "G50 S2500", "G96 S180 M3"};
    one.lines.insert(one.lines.end(), path.begin(), path.end());
    one.lines.insert(one.lines.end(), {"M30", "%"});
    all.push_back(one);
  }
  Sample sinumerik{"sinumerik lathe", "sinumerik-840d", ir::MachineKind::lathe, {}};
  sinumerik.lines = {"G71 G18 G90 G40 DIAMON", "T1 D1", "G54", "LIMS=2500", "G96 S180 M3"};
  sinumerik.lines.insert(sinumerik.lines.end(), path.begin(), path.end());
  sinumerik.lines.push_back("M30");
  all.push_back(sinumerik);
  return all;
}

checks::Machine machine_of(ir::MachineKind kind) {
  checks::Machine machine;
  machine.kind = kind;
  checks::WorkOffset g54{.number = 1};
  if (kind == ir::MachineKind::mill) {
    machine.axes = {{.axis = ir::Axis::x, .min = 0, .max = 800},
                    {.axis = ir::Axis::y, .min = 0, .max = 500},
                    {.axis = ir::Axis::z, .min = -500, .max = 0}};
    machine.tools = {{.number = 1, .offset = 1, .diameter_mm = 10, .length_mm = 100}};
    g54.zero[0] = 200;
    g54.zero[1] = 200;
    g54.zero[2] = -300;
  } else {
    machine.axes = {{.axis = ir::Axis::x, .is_diameter = true, .min = 0, .max = 200},
                    {.axis = ir::Axis::z, .min = -700, .max = 0}};
    machine.tools = {
        {.number = 1, .offset = 1, .nose_radius_mm = 0.8, .tip = 3, .length_x_mm = 30.0, .length_z_mm = 20.0}};
    g54.zero[0] = 10;
    g54.zero[2] = -400;
  }
  machine.work_offsets = {g54};
  machine.feed_limit_mm_min = 5000;
  machine.spindle_max_rpm = kind == ir::MachineKind::mill ? 8000 : 3000;
  return machine;
}

struct Found {
  DiagnosticId id;
  std::uint32_t line;
};

// What running and the envelope say, notes left out.
std::vector<Found> findings_of(const Sample& sample, const checks::Machine& machine) {
  const compile::Dialect* dialect = compile::find_dialect(sample.dialect);
  const ir::Control control = dialect->control(sample.kind, ir::GSystem::a);
  std::string text;
  for (const std::string& line : sample.lines) text += line + "\n";
  const ir::ReadResult read = dialect->read(text::Source(sample.name, text), control);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << sample.name << "\n" << text;
  envelope::Envelope check({.machine = machine,
                            .arc_tolerance_mm = control.semantics.arc_tolerance_mm,
                            .part_size_mm = 120,
                            .d_selects_edge = control.semantics.d_selects_edge});
  const auto run = compile::execute(read.program, control, nullptr, check, {});
  std::vector<Found> found;
  for (const interpreter::RunDiagnostic& one : run.diagnostics)
    if (one.diagnostic.severity == text::Severity::error) found.push_back({one.diagnostic.id, one.line});
  const envelope::Report report = check.finish();
  for (const checks::Finding& one : report.findings.kept())
    if (one.severity != text::Severity::note) found.push_back({one.id, one.place.line});
  return found;
}

std::string listed(const std::vector<Found>& found) {
  std::string text;
  for (const Found& one : found) text += std::string(text::row_of(one.id).name) + ":" + std::to_string(one.line) + " ";
  return text;
}

// The first of that kind is at that line.
void expect_at(const Sample& sample, const checks::Machine& machine, DiagnosticId id, std::uint32_t line) {
  const std::vector<Found> found = findings_of(sample, machine);
  const auto first = std::ranges::find(found, id, &Found::id);
  ASSERT_NE(first, found.end()) << sample.name << ": " << text::row_of(id).name << "; " << listed(found);
  EXPECT_EQ(first->line, line) << sample.name << ": " << text::row_of(id).name << "; " << listed(found);
}
void expect_clean(const Sample& sample, const checks::Machine& machine) {
  const std::vector<Found> found = findings_of(sample, machine);
  EXPECT_TRUE(found.empty()) << sample.name << ": " << listed(found);
}

std::string word(const char* letter, double value) {
  std::string out = letter;
  text::append_word_number(out, value, 4, false);
  return out;
}

class Faults : public ::testing::Test {
 protected:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  // From a thousandth to much, all orders alike; four decimals.
  double excess(double most) { return std::round(std::exp(between(std::log(0.0011), std::log(most))) * 1e4) / 1e4; }
  void each(const std::vector<Sample>& samples,
            const std::function<void(const Sample&, const checks::Machine&)>& test) {
    constexpr int kSeeds = 5;
    for (int i = 0; i < kSeeds; ++i)
      for (const Sample& sample : samples) test(sample, machine_of(sample.kind));
  }

  std::mt19937 random_{20};
};

TEST_F(Faults, NoneInTheGoodOnes) {
  for (const Sample& sample : mills()) expect_clean(sample, machine_of(sample.kind));
  for (const Sample& sample : lathes()) expect_clean(sample, machine_of(sample.kind));
}

TEST_F(Faults, AnOffsetWithTheWrongSign) {
  for (const Sample& sample : mills()) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      checks::Machine machine = machine_of(sample.kind);
      machine.work_offsets[0].zero[axis] = -*machine.work_offsets[0].zero[axis];
      const std::uint32_t line =
          axis == 2 ? sample.line_of(sample.dialect == "sinumerik-840d" ? "D1 Z50" : "G43") : sample.line_of("G0 X0.");
      expect_at(sample, machine, DiagnosticId::travel_exceeded, line);
    }
  }
  for (const Sample& sample : lathes()) {
    checks::Machine machine = machine_of(sample.kind);
    machine.work_offsets[0].zero[2] = 400;
    expect_at(sample, machine, DiagnosticId::travel_exceeded, sample.line_of("G0 X80."));
  }
}

TEST_F(Faults, ATravelThatIsExceeded) {
  each(mills(), [&](const Sample& sample, const checks::Machine& machine) {
    const std::uint32_t approach = sample.line_of("G0 X0.");
    const auto approach_by = [&](double x, double y) {
      return sample.with("G0 X0.", "G0 " + word("X", x) + " " + word("Y", y) + " S5000 M3").with("Z2.", "X0. Y0. Z2.");
    };
    expect_clean(approach_by(600, 300), machine);
    expect_at(approach_by(600 + excess(50), 300), machine, DiagnosticId::travel_exceeded, approach);
    expect_at(approach_by(0, -200 - excess(50)), machine, DiagnosticId::travel_exceeded, approach);
    expect_clean(sample.with("G0 Z60.", "G0 Z200."), machine);
    expect_at(sample.with("G0 Z60.", "G0 " + word("Z", 200 + excess(50))), machine, DiagnosticId::travel_exceeded,
              sample.line_of("G0 Z60."));
  });
  each(lathes(), [&](const Sample& sample, const checks::Machine& machine) {
    const auto out_to = [&](double x, double z) {
      return sample.with("G0 Z60.", "G0 " + word("X", x) + " " + word("Z", z));
    };
    expect_clean(out_to(320, 380), machine);
    expect_at(out_to(320 + 2 * excess(50), 60), machine, DiagnosticId::travel_exceeded, sample.line_of("G0 Z60."));
    expect_at(out_to(100, 380 + excess(50)), machine, DiagnosticId::travel_exceeded, sample.line_of("G0 Z60."));
  });
}

TEST_F(Faults, AToolThatIsLongerThanTheProgramThinks) {
  each(mills(), [&](const Sample& sample, checks::Machine machine) {
    machine.tools[0].length_mm = 240;  // the lift to 60 ends at the top
    expect_clean(sample, machine);
    machine.tools[0].length_mm = 240 + excess(9);
    expect_at(sample, machine, DiagnosticId::travel_exceeded, sample.line_of("G0 Z60."));
    machine.tools[0].length_mm.reset();
    EXPECT_TRUE(findings_of(sample, machine).empty()) << "nothing is claimed of a tool that is not known";
  });
}

TEST_F(Faults, AnArcThatReachesFartherThanItsEnds) {
  each(mills(), [&](const Sample& sample, checks::Machine machine) {
    machine.axes[0].max = 320;  // x 120, where the second arc begins and the first one ends
    expect_clean(sample, machine);
    const Sample round = sample.with("G1 Y-80.", "G2 X120. Y-80. I0. J-30.");  // its side is at 120 + 30
    machine.axes[0].max = 350;
    expect_clean(round, machine);
    machine.axes[0].max = 350 - excess(20);
    expect_at(round, machine, DiagnosticId::travel_exceeded, sample.line_of("G1 Y-80."));
  });
}

TEST_F(Faults, FeedsAndSpeedsBeyondTheMachine) {
  each(mills(), [&](const Sample& sample, const checks::Machine& machine) {
    expect_clean(sample.with("X100. F1200.", "X100. F5000."), machine);
    expect_at(sample.with("X100. F1200.", "X100. " + word("F", 5000 + excess(9000))), machine,
              DiagnosticId::feed_too_high, sample.line_of("X100. F1200."));
    expect_clean(sample.with("G0 X0.", "G0 X0. Y0. S8000 M3"), machine);
    expect_at(sample.with("G0 X0.", "G0 X0. Y0. S" + std::to_string(8001 + static_cast<int>(excess(9000))) + " M3"),
              machine, DiagnosticId::spindle_too_fast, sample.line_of("G0 X0."));
    expect_at(sample.with("Z2.", "Z2. M5"), machine, DiagnosticId::spindle_not_turning, sample.line_of("G1 Z-5."));
  });
}

// At 180 m/min diameter 10 asks for 5730 turns: what is programmed as their limit counts, and without one the
// machine's.
TEST_F(Faults, SurfaceSpeedWithoutALimit) {
  for (const Sample& sample : lathes()) {
    const bool sinumerik = sample.dialect == "sinumerik-840d";
    const std::string limit = sinumerik ? "LIMS=2500" : "G50 S2500";
    const checks::Machine machine = machine_of(sample.kind);
    const std::uint32_t facing = sample.line_of("G1 X10.");
    expect_clean(sample.with(limit, sinumerik ? "LIMS=3000" : "G50 S3000"), machine);
    expect_at(sample.with(limit, sinumerik ? "LIMS=3500" : "G50 S3500"), machine, DiagnosticId::spindle_too_fast,
              facing);
    expect_at(sample.with(limit, "M8"), machine, DiagnosticId::surface_speed_unlimited, facing);
    const Sample slow = sample.with(limit, "M8").with("G96 S180", "G96 S90 M3");  // 2865 turns at diameter 10
    expect_clean(slow, machine);
    // 2 mm a turn are 5000 mm/min at the limit.
    expect_clean(sample.with("G1 X10.", "G1 X10. F2."), machine);
    expect_at(sample.with("G1 X10.", "G1 X10. " + word("F", 2 + excess(100))), machine, DiagnosticId::feed_too_high,
              facing);
  }
}

TEST_F(Faults, ToolsThatTheMachineDoesNotHave) {
  for (const Sample& sample : mills()) {
    const checks::Machine machine = machine_of(sample.kind);
    expect_at(sample.with("T1", "T9 M6"), machine, DiagnosticId::tool_missing, sample.line_of("T1"));
  }
  for (const Sample& sample : lathes()) {
    const bool sinumerik = sample.dialect == "sinumerik-840d";
    expect_at(sample.with(sinumerik ? "T1" : "T0101", sinumerik ? "T4 D1" : "T0404"), machine_of(sample.kind),
              DiagnosticId::tool_missing, sample.line_of(sinumerik ? "T1" : "T0101"));
  }
}

TEST_F(Faults, InchesForMillimetres) {
  for (const Sample& sample : mills()) {
    const bool sinumerik = sample.dialect == "sinumerik-840d";
    const Sample inches =
        sample.with(sinumerik ? "G71" : "G21", sinumerik ? "G700 G17 G90 G94 G40" : "G20 G17 G90 G94 G40 G49 G80");
    const checks::Machine machine = machine_of(sample.kind);
    expect_at(inches, machine, DiagnosticId::travel_exceeded, sample.line_of(sinumerik ? "D1 Z50" : "G43"));
    expect_at(inches, machine, DiagnosticId::feed_too_high, sample.line_of("G1 Z-5."));
    expect_at(inches, machine, DiagnosticId::unit_suspicion, sample.line_of("G2 X120."));
  }
}

TEST_F(Faults, MillimetresForInches) {
  for (const Sample& sample : mills()) {
    Sample small = sample;  // the program of a part in inches, under G21
    for (auto [from, to] : {std::pair{"X100. F", "X3.937 F47."},
                            {"G2 X120.", "X4.7244 Y-0.7874"},
                            {"G1 Y-80.", "Y-3.1496"},
                            {"G2 X100. Y-100.", "X3.937 Y-3.937"}})
      small = small.with(from, to);
    expect_at(small, machine_of(sample.kind), DiagnosticId::unit_suspicion, sample.line_of("G1 Z-5."));
  }
}

TEST_F(Faults, ACentreThatIsOff) {
  each(mills(), [&](const Sample& sample, const checks::Machine& machine) {
    const std::uint32_t arc = sample.line_of("G2 X120.");
    expect_clean(sample.with("G2 X120.", "G2 X120. Y-20. I0.004 J-20."), machine);
    const double off = 0.03 + excess(5);
    expect_at(sample.with("G2 X120.", "G2 X120. Y-20. I0. " + word("J", -20 - off)), machine,
              DiagnosticId::arc_radius_mismatch, arc);
  });
}

}  // namespace
}  // namespace dripfeed

// 200 seeded faults in plain programs as people write them, turning and milling, for all four controls: a word of the
// text is changed, and the fault must be found at the line where the harm is done, with its depth. Which line and how
// deep is written down in the table by hand, from the part's drawing. The programs as they are must be clean.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "checks/gouge/gouge.h"
#include "checks/gouge/milling.h"
#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/render/render.h"
#include "dialects/text/number.h"

namespace dripfeed {
namespace {

constexpr const char* kFolder = DRIPFEED_SOURCE_DIR "/tests/samples/gouge/";

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}
std::string read(const std::string& name) { return read_file(kFolder + name); }

struct Program {
  std::string file;
  std::string dialect;
  bool turns = false;
  std::string text = read(file);
};

std::vector<Program> programs() {
  return {{"fanuc_pocket.nc", "fanuc"},
          {"fanuc_shaft.nc", "fanuc", true},
          {"mazak_pocket.eia", "mazak"},
          {"mazak_shaft.eia", "mazak", true},
          {"mitsubishi-m80_pocket.nc", "mitsubishi-m80"},
          {"mitsubishi-m80_shaft.nc", "mitsubishi-m80", true},
          {"sinumerik-840d_pocket.mpf", "sinumerik-840d"},
          {"sinumerik-840d_shaft.mpf", "sinumerik-840d", true}};
}

// 1-based, of the block with that number.
std::uint32_t line_of(const std::string& text, const std::string& block) {
  const std::size_t at = ("\n" + text).find("\n" + block + " ");
  EXPECT_NE(at, std::string::npos) << block;
  return 1 + static_cast<std::uint32_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

// The word of that block is written again.
std::string with_word(std::string text, const std::string& block, const std::string& word, const std::string& changed) {
  const std::size_t line = ("\n" + text).find("\n" + block + " ");
  const std::size_t at = text.find(word, line);
  EXPECT_LT(at, text.find('\n', line)) << block << " has no " << word;
  text.replace(at, word.size(), changed);
  return text;
}

// The tool that a wrong number calls for.
struct OtherTool {
  double diameter_mm = 0.0;
};

gouge::Report check(const Program& program, const std::string& text, OtherTool other = {}) {
  static const std::map<bool, family::Geometry> kParts = {
      {false, compile::family_geometry(text::Source("pocket", read("pocket.family")), {}).geometry},
      {true, compile::family_geometry(text::Source("shaft", read("shaft.family")), {}).geometry}};
  const family::Geometry& part = kParts.at(program.turns);
  const compile::Dialect* dialect = compile::find_dialect(program.dialect);
  const ir::Control control =
      dialect->control(program.turns ? ir::MachineKind::lathe : ir::MachineKind::mill, ir::GSystem::a);
  const text::Source source(program.file, text);
  const ir::ReadResult read = dialect->read(source, control);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << program.file;
  const auto run_into = [&](ir::MotionSink& sink) {
    const auto run = compile::execute(read.program, control, nullptr, sink, {});
    EXPECT_EQ(run.ended, interpreter::Ended::end) << program.file;
    EXPECT_TRUE(run.not_interpreted.empty()) << program.file << ": " << run.not_interpreted.front().name;
  };
  if (program.turns) {
    gouge::Settings settings;
    const auto& bar = std::get<family::CylinderStock>(*part.stock);
    settings.stock = gouge::Cylinder{bar.diameter_mm, bar.z_mm.low, bar.z_mm.high};
    settings.nominal = part.nominal;
    settings.tools = {{.number = 3, .offset = 3, .nose_radius_mm = 0.8, .tip = 3}};
    gouge::Gouge turning(settings);
    run_into(turning);
    return turning.finish();
  }
  gouge::MillingSettings settings;
  const auto& box = std::get<family::BoxStock>(*part.stock);
  settings.stock = gouge::Blank{box.x_mm, box.y_mm, box.z_mm};
  settings.nominal = part.surfaces;
  settings.tools = {{.number = 4, .offset = 4, .diameter_mm = 12},
                    {.number = 5, .offset = 5, .diameter_mm = other.diameter_mm}};
  const bool has_edges = control.semantics.d_selects_edge;
  settings.comp_radius = has_edges ? gouge::CompRadius::of_tool : gouge::CompRadius::of_number;
  settings.outer_corner = has_edges ? gouge::OuterCorner::arc : gouge::OuterCorner::straight;
  gouge::Milling milling(settings);
  run_into(milling);
  return milling.finish();
}

enum class For : std::uint8_t { turning, milling, milling_with_registers, milling_with_edges };

// One word of one block, written again with a value of the range; then the harm's block and depth.
struct Fault {
  const char* what;
  For where;
  const char* block;
  const char* word;
  std::function<std::string(double)> changed;
  double low;
  double high;
  const char* found_at;
  std::function<double(double)> depth_mm;
  std::function<double(double)> other_diameter_mm = [](double) { return 12.0; };
};

std::string number(double value) { return text::format_fixed(value, 3); }
double itself(double value) { return value; }
// Of a circle of radius r over a chord whose half has this square.
double sagitta(double r, double half_square) { return r - std::sqrt(r * r - half_square); }

// The pocket is 10 deep in layers of 5, its corners have a radius of 8 mm, the mill one of 6; the slot is 6 deep and 16
// wide. The bar is turned to 53, with a groove to 47 at z -25, then to its contour with a fillet of 10 mm whose chord
// is 2·sqrt(10) long; tolerance 0.05 throughout. Wrong in x by more than sqrt(2.05² - 2²) the mill would reach into the
// corner already at the end of the side before it.
const std::vector<Fault>& faults() {
  static const std::vector<Fault> kFaults = {
      {"rapid lowered into the block", For::milling, "N60", "Z5.", [](double v) { return "Z-" + number(v); }, 0.5, 4,
       "N60", itself},
      {"retract shortened: across the part at depth", For::milling, "N620", "Z5.",
       [](double v) { return "Z-" + number(v); }, 0.5, 4, "N630", itself},
      {"offset wrong in z: the floor", For::milling, "N25", "Z0.", [](double v) { return "Z-" + number(v); }, 0.15, 1,
       "N370", itself},
      {"offset wrong in x: the wall", For::milling, "N25", "X0.", [](double v) { return "X" + number(v); }, 0.35, 0.44,
       "N220", [](double) { return 5.0; }},
      {"corner radius wrong", For::milling, "N220", "R8.", [](double v) { return "R" + number(v); }, 6.2, 7, "N220",
       [](double) { return 5.0; }},
      {"radius of the wrong register", For::milling_with_registers, "N190", "D4", [](double) { return "D5"; }, 0.3, 1,
       "N200", [](double) { return 5.0; }, [](double v) { return 12 - 2 * v; }},
      {"larger mill than the register says", For::milling_with_registers, "N30", "T4", [](double) { return "T5"; }, 0.3,
       0.6, "N200", [](double) { return 5.0; }, [](double v) { return 12 + 2 * v; }},
      {"larger mill, compensated but in the slot", For::milling_with_edges, "N30", "T4", [](double) { return "T5"; },
       0.3, 0.6, "N650", [](double) { return 6.0; }, [](double v) { return 12 + 2 * v; }},
      {"rapid lowered into the bar", For::turning, "N100", "X54.", [](double v) { return "X" + number(53 - 2 * v); },
       0.5, 2.4, "N100", itself},
      {"retract shortened: along the bar at depth", For::turning, "N120", "X62.",
       [](double v) { return "X" + number(53 - 2 * v); }, 0.5, 2.4, "N130", itself},
      {"offset wrong in x: the last cut", For::turning, "N25", "X0.", [](double v) { return "X-" + number(2 * v); },
       0.1, 0.4, "N230", itself},
      {"radius of the fillet wrong", For::turning, "N240", "R10.", [](double v) { return "R" + number(v); }, 4, 7,
       "N240", [](double v) { return sagitta(v, 10) - sagitta(10, 10); }},
  };
  return kFaults;
}

bool suits(const Fault& fault, const Program& program) {
  if (fault.where == For::turning) return program.turns;
  const bool has_edges = program.dialect == "sinumerik-840d";
  return !program.turns && (fault.where == For::milling || (fault.where == For::milling_with_edges) == has_edges);
}

// SINUMERIK writes a radius as CR=.
std::string in_dialect(const Program& program, std::string word) {
  if (program.dialect == "sinumerik-840d" && word.starts_with('R')) word.insert(0, "C").insert(2, "=");
  return word;
}

TEST(GougePrograms, TheGoodOnesAreClean) {
  for (const Program& program : programs()) {
    const gouge::Report report = check(program, program.text, {.diameter_mm = 12});
    EXPECT_TRUE(report.findings.empty()) << program.file << ": " << report.findings.kept().front().text << " at line "
                                         << report.findings.kept().front().place.line;
    EXPECT_GE(report.rapids, 5U) << program.file;
    EXPECT_GE(report.cuts, 9U) << program.file;
    for (const checks::NotChecked& one : report.not_checked.list()) {
      EXPECT_TRUE(one.text.starts_with("the rapid speeds") || one.text.starts_with("a move starts at a position"))
          << program.file << ": " << one.text;
    }
  }
}

// The samples that have no drawing, in a block or a bar around all that they do: their rapids touch nothing.
TEST(GougePrograms, NoRapidOfTheOtherSamplesTouchesTheirStock) {
  const std::map<std::string, bool> turned = {{"grooves.nc", true}, {"shaft.mpf", true}};
  int found = 0;
  for (const compile::Dialect& dialect : compile::dialects()) {
    for (const auto& entry : std::filesystem::directory_iterator(fmt::format("{}/../{}", kFolder, dialect.name))) {
      const std::string name = entry.path().filename();
      const bool turns = turned.contains(name);
      const ir::Control control = dialect.control(turns ? ir::MachineKind::lathe : ir::MachineKind::mill, {});
      const ir::ReadResult read = dialect.read(text::Source(name, read_file(entry.path())), control);
      gouge::Settings bar;
      bar.stock = gouge::Cylinder{60, -70, 0};
      bar.tools = {{.number = 3, .offset = 3, .nose_radius_mm = 0.4, .tip = 3}};
      gouge::MillingSettings block;
      block.stock = gouge::Blank{{-70, 110}, {-70, 70}, {-40, 0}};
      for (int tool = 1; tool <= 12; ++tool) block.tools.push_back({.number = tool, .diameter_mm = 8});
      gouge::Gouge turning(bar);
      gouge::Milling milling(block);
      ir::MotionSink& sink = turns ? static_cast<ir::MotionSink&>(turning) : milling;
      EXPECT_EQ(compile::execute(read.program, control, nullptr, sink, {}).ended, interpreter::Ended::end) << name;
      const gouge::Report report = turns ? turning.finish() : milling.finish();
      EXPECT_TRUE(report.findings.empty()) << name << ": " << report.findings.kept().front().text;
      EXPECT_GT(report.rapids, 1U) << name;
      EXPECT_GT(report.cuts, 3U) << name;
      ++found;
    }
  }
  EXPECT_GE(found, 15);
}

TEST(GougePrograms, TwoHundredSeededFaultsAreFoundAtTheirLineWithTheirDepth) {
  std::mt19937 random(2026);
  const std::vector<Program> all = programs();
  std::map<std::string, int> counts;
  int seeded = 0;
  for (std::size_t round = 0; seeded < 200; ++round) {
    const Program& program = all[round % all.size()];
    const Fault& fault = faults()[round / all.size() % faults().size()];
    if (!suits(fault, program)) continue;
    const double value = std::uniform_real_distribution<double>(fault.low, fault.high)(random);
    const std::string text = with_word(program.text, fault.block, in_dialect(program, fault.word),
                                       in_dialect(program, fault.changed(value)));
    const gouge::Report report = check(program, text, {.diameter_mm = fault.other_diameter_mm(value)});
    ++seeded;
    ++counts[program.dialect];
    const std::string reported = program.file + ", " + fault.what + " by " + number(value);
    ASSERT_FALSE(report.findings.kept().empty()) << reported << ": nothing found";
    const checks::Finding& first = report.findings.kept().front();
    EXPECT_EQ(first.severity, text::Severity::error) << reported;
    EXPECT_EQ(first.place.line, line_of(program.text, fault.found_at)) << reported << ": " << first.text;
    EXPECT_NEAR(first.value, fault.depth_mm(value), 0.002) << reported << ": " << first.text;
  }
  for (const auto& [dialect, count] : counts) EXPECT_GE(count, 30) << dialect;
}

}  // namespace
}  // namespace dripfeed

// Programs of all dialects made at random: at every line where a restart is given, its run is the tail of the whole
// run, compared here by other means than the restart's own proof; where the generator knows that a line stands inside
// of something, it is refused.
#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/compile/restart/restart.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

class Shop {
 public:
  Shop(std::string dialect, ir::MachineKind kind, std::uint32_t seed) : dialect_(std::move(dialect)), random_(seed) {
    sinumerik_ = dialect_.starts_with("sinumerik");
    if (!sinumerik_) add("%");
    if (!sinumerik_) add("O0001 (RANDOM)");
    head_ = lines_.size();
    kind == ir::MachineKind::mill ? mill() : lathe();
    add(sinumerik_ ? "M30" : "M30");
    if (!sinumerik_) add("%");
  }
  [[nodiscard]] std::string text() const { return fmt::format("{}\n", fmt::join(lines_, "\n")); }
  [[nodiscard]] std::size_t line_count() const { return lines_.size(); }
  // The line begins in a cycle, compensation, a loop, or is an arc or a thread.
  [[nodiscard]] bool is_inside(std::uint32_t line) const { return inside_.contains(line) || line <= head_; }

 private:
  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool chance(int percent) { return number(1, 100) <= percent; }
  std::string length(int low, int high) {
    const int thousandths = number(low * 1000, high * 1000);
    return fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", std::abs(thousandths) / 1000,
                       std::abs(thousandths) % 1000);
  }
  void add(const std::string& line, bool inside = false) {
    lines_.push_back(line);
    if (inside) inside_.insert(static_cast<std::uint32_t>(lines_.size()));
  }
  std::string xy() { return "X" + length(-80, 80) + (chance(80) ? " Y" + length(-80, 80) : ""); }
  std::string variable() { return sinumerik_ ? "R5" : "#105"; }

  void mill() {
    add(sinumerik_ ? "G71" : "G21");
    add(sinumerik_ ? "G17 G40 G90 G94" : "G17 G40 G49 G80 G90 G94");
    for (int tool = 1; tool <= number(1, 3); ++tool) {
      if (sinumerik_) {
        add("SUPA G0 Z400 D0");
        add(fmt::format("T{}", tool));
        add("M6");
        add("D1");
      } else {
        add("G91 G28 Z0.");
        add("G90");
        add(fmt::format("T{} M06", tool));
      }
      add(fmt::format("G{}", number(54, 57)));
      add(fmt::format("S{} M03", number(5, 80) * 100));
      add("G00 X" + length(-80, 80) + " Y" + length(-80, 80));
      add(sinumerik_ ? "G0 Z50" : fmt::format("G43 H{} Z50.", tool));
      if (chance(60)) add("M08");
      add(fmt::format("G01 Z{} F{}", length(-9, -1), number(50, 900)));
      for (int i = number(6, 18); i > 0; --i) cut();
      add("G00 Z50.");
      if (chance(60)) add("M09");
    }
    add("M05");
  }

  void cut() {
    switch (number(0, 8)) {
      case 0: return add((chance(50) ? "G01 " : "") + xy());
      case 1: return add("G01 " + xy() + fmt::format(" F{}", number(50, 900)));
      case 2: return add("G00 Z" + length(1, 9)), add("G00 " + xy()), add("G01 Z" + length(-9, -1));
      case 3:
        return add("G02 X" + length(-80, 80) + " Y" + length(-80, 80) + (sinumerik_ ? " CR=200" : " R200."), true),
               add("G01 " + xy());
      case 4:
        add("G91");
        add("G01 X" + length(-3, 3));
        return add("G90");
      case 5:
        add("G00 Z5.");
        add(fmt::format("G41 {}G01 {} F300", sinumerik_ ? "" : "D11 ", "X" + length(-80, 80)));
        for (int i = number(1, 3); i > 0; --i) add("X" + length(-80, 80) + " Y" + length(-80, 80), true);
        return add("G40 G00 " + xy(), true), add("G01 Z" + length(-9, -1));
      case 6:
        add("G00 Z5.");
        if (sinumerik_) {
          add("MCALL CYCLE81(10,0,2,-8)");
          for (int i = number(1, 3); i > 0; --i) add(xy(), true);
          add("MCALL", true);
        } else {
          add("G99 G81 " + xy() + " Z-8. R2. F120.");
          for (int i = number(1, 3); i > 0; --i) add(xy(), true);
          add("G80", true);
        }
        return add("G01 Z" + length(-9, -1) + " F200");
      case 7: add(variable() + "=" + length(1, 60)); return add(sinumerik_ ? "G01 X=R5" : "G01 X#105");
      default:
        add(variable() + "=0.");
        add(sinumerik_ ? "WHILE R5<3" : "WHILE[#105LT3]DO1", true);
        add(sinumerik_ ? "G01 X=R5*2" : "G01 X[#105*2]", true);
        add(sinumerik_ ? "R5=R5+1" : "#105=#105+1", true);
        return add(sinumerik_ ? "ENDWHILE" : "END1", true);
    }
  }

  void lathe() {
    if (sinumerik_)
      add("G71"), add("G18 G40 G90 G95 DIAMON");
    else
      add("G21 G40 G99");
    for (int tool = 1; tool <= number(1, 3); ++tool) {
      if (sinumerik_) {
        add("SUPA G0 X300 D0");
        add("SUPA G0 Z400");
        add(fmt::format("T{} D1", tool));
        add("G54");
        add(fmt::format("G96 S{} LIMS=2500 M4", number(80, 250)));
      } else {
        add("G28 U0. W0.");
        add(fmt::format("T0{}0{}", tool, tool));
        add("G50 S2500");
        add(fmt::format("G96 S{} M03", number(80, 250)));
      }
      const bool bore = chance(30);
      bore ? add("G00 X18. Z3.") : add("G00 X104. Z3.");
      if (chance(50)) add("M08");
      for (int i = number(2, 6); i > 0; --i) {
        add("G00 X" + (bore ? length(20, 40) : length(40, 100)));
        add(fmt::format("G01 Z{} F0.{}", length(-60, -5), number(1, 4)));
        if (chance(40)) add("X" + (bore ? length(20, 40) : length(60, 100)) + " Z" + length(-90, -61));
        if (!bore && chance(30)) add("G02 X" + length(100, 103) + " Z-95." + (sinumerik_ ? " CR=90" : " R90."), true);
        add(bore ? "G00 X18." : "G00 X104.");
        add("G00 Z3.");
      }
      if (!sinumerik_ && chance(40)) {
        add("G97 S600");
        add("G92 X90. Z-20. F1.5");
        add("X89.", true);
        add("G00 X104. Z3.", true);
      }
    }
    add("M05");
  }

  std::string dialect_;
  std::mt19937 random_;
  bool sinumerik_ = false;
  std::size_t head_ = 0;
  std::vector<std::string> lines_;
  std::set<std::uint32_t> inside_;
};

bool is_near(double a, double b) { return std::abs(a - b) < 0.0015; }

// The moves of `line` and after it, in a program without calls.
std::vector<ir::Motion> moves_from(const std::vector<ir::Motion>& motions, std::uint32_t line) {
  std::vector<ir::Motion> out;
  for (const ir::Motion& m : motions)
    if (ir::is_move(m.kind) && (m.place.program != 0 || m.place.line >= line)) out.push_back(m);
  return out;
}

void expect_tail(const std::vector<ir::Motion>& whole, const std::vector<ir::Motion>& rest, const std::string& what) {
  ASSERT_EQ(whole.size(), rest.size()) << what;
  std::uint16_t placed = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const ir::Motion& a = whole[i];
    const ir::Motion& b = rest[i];
    ASSERT_EQ(a.kind, b.kind) << what;
    placed |= b.axes_commanded;
    const bool cuts = a.kind != ir::MotionKind::rapid;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const unsigned bit = 1U << axis;
      const bool end = (placed & bit) == 0 || is_near(a.end[axis], b.end[axis]);
      const bool start = !cuts || (a.axes_unknown & bit) != 0 || is_near(a.start[axis], b.start[axis]);
      ASSERT_TRUE(end && start) << what << " move " << i;
    }
    if (!cuts) continue;
    ASSERT_EQ(a.feed_mode, b.feed_mode) << what;
    ASSERT_TRUE(is_near(a.feed, b.feed)) << what;
    ASSERT_EQ(a.spindle, b.spindle) << what;
    ASSERT_TRUE(is_near(a.spindle_rpm, b.spindle_rpm)) << what;
    ASSERT_EQ(a.coolant, b.coolant) << what;
    ASSERT_EQ(a.comp, b.comp) << what;
    ASSERT_EQ(a.length_offset_number, b.length_offset_number) << what;
  }
}

// Of a mill: nothing moves across before the tool axis is clear, and it comes down last.
void expect_safe_approach(const std::vector<ir::Motion>& motions, std::uint32_t rest_line, const std::string& what) {
  bool down = false;
  for (const ir::Motion& m : motions) {
    if (!ir::is_move(m.kind) || m.place.line >= rest_line) continue;
    const bool across = (m.axes_commanded & 3U) != 0;
    EXPECT_FALSE(across && down) << what;
    EXPECT_TRUE(!across || m.kind == ir::MotionKind::rapid) << what;
    down = down || ((m.axes_commanded & 4U) != 0 && !m.machine_coordinates);
  }
}

struct Config {
  const char* dialect;
  ir::MachineKind kind;
};
constexpr Config kConfigs[] = {
    {"fanuc", ir::MachineKind::mill},          {"fanuc", ir::MachineKind::lathe},
    {"haas", ir::MachineKind::mill},           {"mazak", ir::MachineKind::mill},
    {"mitsubishi-m80", ir::MachineKind::mill}, {"mitsubishi-m80", ir::MachineKind::lathe},
    {"sinumerik-840d", ir::MachineKind::mill}, {"sinumerik-840d", ir::MachineKind::lathe},
};

TEST(RestartRandom, TheRestIsTheTailOfTheWholeRun) {
  for (const Config& config : kConfigs) {
    int given = 0;
    int outside = 0;
    for (std::uint32_t seed = 1; seed <= 12; ++seed) {
      const Shop shop(config.dialect, config.kind, seed);
      const ir::Control machine = control(config.dialect, config.kind);
      const std::vector<ir::Motion> whole = run_text(shop.text(), machine).motions;
      for (std::uint32_t line = 1; line <= shop.line_count(); ++line) {
        const Restart made = restart_at({.source = text::Source("p", shop.text()), .control = machine, .line = line});
        const std::string what = fmt::format("{} {} seed {} line {}\n{}\n---\n{}", config.dialect,
                                             ir::name_of(config.kind), seed, line, shop.text(), made.text);
        EXPECT_NE(made.text.empty(), made.diagnostics.empty()) << what;
        if (shop.is_inside(line)) {
          EXPECT_TRUE(made.text.empty()) << what;
          continue;
        }
        ++outside;
        if (made.text.empty()) {
          for (const std::uint32_t safe : {made.safe_before, made.safe_after})
            EXPECT_TRUE(safe == 0 || !shop.is_inside(safe)) << what;
          continue;
        }
        ++given;
        const std::vector<ir::Motion> rest = run_text(made.text, machine).motions;
        expect_tail(moves_from(whole, line), moves_from(rest, made.rest_line), what);
        if (config.kind == ir::MachineKind::mill) expect_safe_approach(rest, made.rest_line, what);
        if (HasFatalFailure()) return;
      }
    }
    RecordProperty(fmt::format("{}-{}", config.dialect, ir::name_of(config.kind)),
                   fmt::format("{}/{}", given, outside));
    fmt::print("{} {}: {} of {}\n", config.dialect, ir::name_of(config.kind), given, outside);
    EXPECT_GT(given, outside / 2) << config.dialect << " " << ir::name_of(config.kind);
  }
}

}  // namespace
}  // namespace dripfeed::compile::test

// 200 seeded faults in the shipped families' programs, turning and milling, on two controls: a rapid that is lowered, a
// retract that is shortened, a wrong offset of the work, a wrong radius of nose or cutter. Each is found, at the line
// where the harm is done; the programs without faults are clean. What a fault must do is decided here by the moves
// alone, before and after it.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "checks/gouge/gouge.h"
#include "checks/gouge/milling.h"
#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/render/render.h"

namespace dripfeed {
namespace {

text::Source source_of(const std::string& name) {
  std::ifstream file(std::string(DRIPFEED_SOURCE_DIR) + "/deploy/families/" + name + ".family");
  std::ostringstream text;
  text << file.rdbuf();
  return {name, text.str()};
}

class Kept final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion> motions) override { all.insert(all.end(), motions.begin(), motions.end()); }
  std::vector<ir::Motion> all;
};

struct Part {
  std::string name;
  family::Geometry geometry;
  bool turns = false;
  bool x_is_diameter = false;
  std::vector<ir::Motion> motions;
};

Part part_of(const std::string& name, const std::string& dialect, const std::vector<family::Override>& values = {}) {
  const text::Source family = source_of(name);
  const compile::Dialect* target = compile::find_dialect(dialect);
  const ir::MachineKind kind = compile::describe_family(family).machine;
  const ir::Control control = target->control(kind, ir::GSystem::a);
  const compile::RenderResult rendered = compile::render({.family = family,
                                                          .values = values,
                                                          .target = control,
                                                          .mode = compile::RenderMode::explicit_blocks,
                                                          .delivery = ir::Delivery::memory,
                                                          .program_name = {},
                                                          .heading = {}});
  EXPECT_FALSE(text::has_error(rendered.diagnostics)) << name;
  const ir::ReadResult read = target->read(text::Source(name, rendered.text), control);
  Kept kept;
  const auto run = compile::execute(read.program, control, nullptr, kept, {});
  EXPECT_EQ(run.ended, interpreter::Ended::end) << name;
  return {name + " " + dialect, rendered.geometry, kind != ir::MachineKind::mill,
          control.semantics.power_on_diameter != ir::DiameterMode::radius, std::move(kept.all)};
}

std::vector<checks::Tool> tools_of(const family::Geometry& geometry) {
  std::vector<checks::Tool> tools;
  for (const family::ToolShape& one : geometry.tools) {
    tools.push_back({.number = one.number,
                     .offset = one.number,
                     .nose_radius_mm = one.nose_radius_mm,
                     .tip = one.tip,
                     .diameter_mm = one.diameter_mm,
                     .length_mm = 0.0,
                     .corner_radius_mm = one.corner_radius_mm});
  }
  return tools;
}

gouge::Report check(const Part& part, const std::vector<ir::Motion>& motions, std::vector<checks::Tool> tools) {
  if (part.turns) {
    gouge::Settings settings;
    const auto& bar = std::get<family::CylinderStock>(*part.geometry.stock);
    settings.stock = gouge::Cylinder{bar.diameter_mm, bar.z_mm.low, bar.z_mm.high};
    settings.nominal = part.geometry.nominal;
    settings.x_is_diameter = part.x_is_diameter;
    settings.tools = std::move(tools);
    gouge::Gouge gouge(settings);
    gouge.consume(motions);
    return gouge.finish();
  }
  gouge::MillingSettings settings;
  const auto& box = std::get<family::BoxStock>(*part.geometry.stock);
  settings.stock = gouge::Blank{box.x_mm, box.y_mm, box.z_mm};
  settings.nominal = part.geometry.surfaces;
  settings.tools = std::move(tools);
  gouge::Milling gouge(settings);
  gouge.consume(motions);
  return gouge.finish();
}

bool found_at(const gouge::Report& report, std::uint32_t line) {
  return std::ranges::any_of(report.findings.kept(), [line](const checks::Finding& one) {
    return one.severity == text::Severity::error && one.place.line == line;
  });
}

bool is_rapid(const ir::Motion& motion) { return motion.kind == ir::MotionKind::rapid; }

struct Fault {
  std::string what;
  std::vector<ir::Motion> motions;
  std::vector<checks::Tool> tools;
  std::uint32_t line = 0;
};

// From one move on, the places of all moves along `axis` are shifted: what a wrong offset or zero does.
void shift_from(std::vector<ir::Motion>& motions, std::size_t from, std::size_t axis, double by) {
  for (std::size_t i = from; i < motions.size(); ++i) {
    if (!ir::is_move(motions[i].kind)) continue;
    if (i > from) motions[i].start[axis] += by;
    motions[i].end[axis] += by;
  }
}

// The end of one move is put elsewhere; the next begins there.
void move_end(std::vector<ir::Motion>& motions, std::size_t at, std::size_t axis, double value) {
  motions[at].end[axis] = value;
  for (std::size_t i = at + 1; i < motions.size(); ++i) {
    if (!ir::is_move(motions[i].kind)) continue;
    motions[i].start[axis] = value;
    if ((motions[i].axes_commanded >> axis & 1U) != 0) return;  // it goes on from its own word
    motions[i].end[axis] = value;
  }
}

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;

class Faults {
 public:
  explicit Faults(const Part& part) : part_(part) {}

  // A rapid ends below all that is cut; its path leads through material that stays.
  Fault lowered_rapid(std::mt19937& random) {
    const double deep = std::uniform_real_distribution<double>(0.5, 3.0)(random);
    const std::size_t axis = part_.turns ? kX : kZ;
    const double end = floor() - (part_.turns ? 2 * deep : deep);
    std::vector<std::size_t> candidates;
    for (std::size_t i = 1; i < part_.motions.size(); ++i) {
      ir::Motion m = part_.motions[i];
      m.end[axis] = end;
      if (is_rapid(m) && (m.axes_unknown & (part_.turns ? 5U : 7U)) == 0 && meets_part(m)) candidates.push_back(i);
    }
    EXPECT_FALSE(candidates.empty()) << part_.name;
    const std::size_t at = candidates[std::uniform_int_distribution<std::size_t>(0, candidates.size() - 1)(random)];
    Fault fault{"lowered rapid", part_.motions, tools_of(part_.geometry), part_.motions[at].place.line};
    move_end(fault.motions, at, axis, end);
    return fault;
  }
  // The rapid that follows a retract runs at the depth of the last cut, and passes over uncut material.
  Fault shortened_retract(std::mt19937& random) {
    std::vector<std::size_t> candidates;
    for (std::size_t i = 1; i + 1 < part_.motions.size(); ++i) {
      if (part_.turns && is_rapid(part_.motions[i]) && is_rapid(part_.motions[i - 1])) candidates.push_back(i);
      if (!part_.turns && is_rapid(part_.motions[i])) candidates.push_back(i);
    }
    const std::size_t at = candidates[std::uniform_int_distribution<std::size_t>(0, candidates.size() - 1)(random)];
    Fault fault{"shortened retract", part_.motions, tools_of(part_.geometry), part_.motions[at].place.line};
    // Put in front of it: the tool stands in the material's height next to the part, and runs across at that height.
    ir::Motion& across = fault.motions[at];
    across.axes_unknown = 0;
    const double deep = std::uniform_real_distribution<double>(1.0, 4.0)(random);
    if (part_.turns) {
      const auto& bar = std::get<family::CylinderStock>(*part_.geometry.stock);
      across.start[kX] = across.end[kX] = floor() - 2 * deep;
      across.start[kZ] = bar.z_mm.high + 5;
      across.end[kZ] = bar.z_mm.low + 0.2 * bar.z_mm.width();
    } else {
      const auto& box = std::get<family::BoxStock>(*part_.geometry.stock);
      across.start = {box.x_mm.low - 50, 0, -deep};
      across.end = {box.x_mm.high + 50, 0, -deep};
    }
    return fault;
  }
  // All moves are too deep by more than the tolerance.
  Fault wrong_offset(std::mt19937& random) {
    Fault fault{"wrong offset", part_.motions, tools_of(part_.geometry), 0};
    const double deep = std::uniform_real_distribution<double>(0.15, 0.4)(random);
    shift_from(fault.motions, 0, part_.turns ? kX : kZ, part_.turns ? -2 * deep : -deep);
    fault.line = first_below(fault);
    return fault;
  }
  // The tool in the spindle is larger than the program was made for; the nose larger, and not compensated.
  Fault wrong_radius(std::mt19937& random) {
    Fault fault{"wrong radius", part_.motions, tools_of(part_.geometry), 0};
    const double larger = std::uniform_real_distribution<double>(1.0, 2.5)(random);
    for (checks::Tool& tool : fault.tools) {
      if (part_.turns) {
        tool.nose_radius_mm += larger;
        tool.tip = 0;  // taken for its centre: the nose is deeper by its radius
      } else {
        tool.diameter_mm += larger;
      }
    }
    if (part_.turns) {
      for (ir::Motion& motion : fault.motions) motion.comp = ir::CompSide::off;
    }
    fault.line = first_below(fault);
    return fault;
  }

 private:
  // Turning: deeper than the nominal, which stays; milling: over the block and below all that is cut.
  [[nodiscard]] bool meets_part(const ir::Motion& m) const {
    for (int i = 0; i <= 100; ++i) {
      const auto at = [&](std::size_t axis) { return m.start[axis] + i / 100.0 * (m.end[axis] - m.start[axis]); };
      if (part_.turns) {
        const curves::ProfilePiece* piece = inner_piece(at(kZ));
        if (piece != nullptr && 0.5 * at(kX) < piece->curve.at(at(kZ)).x - 0.1) return true;
      } else {
        const auto& box = std::get<family::BoxStock>(*part_.geometry.stock);
        if (box.x_mm.contains(at(0)) && box.y_mm.contains(at(1)) && at(kZ) < floor() - 0.1) return true;
      }
    }
    return false;
  }
  // Of the nominal, not at its very ends.
  [[nodiscard]] const curves::ProfilePiece* inner_piece(double z) const {
    const curves::Range whole = part_.geometry.nominal.z();
    return z > whole.low + 0.1 && z < whole.high - 0.1 ? curves::piece_at(part_.geometry.nominal, z) : nullptr;
  }
  // Lowest place of all cuts, as programmed.
  [[nodiscard]] double floor() const {
    double lowest = 1e300;
    for (const ir::Motion& m : part_.motions) {
      if (ir::is_move(m.kind) && !is_rapid(m)) lowest = std::min(lowest, m.end[part_.turns ? kX : kZ]);
    }
    return lowest;
  }
  // The first cut whose surface lies below the nominal, by moves and nominal alone: turning by the distance of the
  // nose's lowest point from the nominal's x at dense places; milling by places under the cutter.
  [[nodiscard]] std::uint32_t first_below(const Fault& fault) const {
    double radius = 0.0;  // of a mill, or of a nose that is led by its centre
    for (const ir::Motion& m : fault.motions) {
      if (m.kind == ir::MotionKind::tool) {
        for (const checks::Tool& tool : fault.tools) {
          if (tool.number != m.number) continue;
          radius = part_.turns ? (tool.tip == 0 ? tool.nose_radius_mm : 0.0) : 0.5 * tool.diameter_mm;
        }
      }
      if (!ir::is_move(m.kind) || is_rapid(m)) continue;
      for (int i = 0; i <= 200; ++i) {
        if (part_.turns ? turns_below(m, i / 200.0, radius) : mills_below(m, i / 200.0, radius)) return m.place.line;
      }
    }
    ADD_FAILURE() << part_.name << " " << fault.what << " cuts nowhere below";
    return 0;
  }
  [[nodiscard]] bool turns_below(const ir::Motion& m, double t, double radius) const {
    const double z = m.start[kZ] + t * (m.end[kZ] - m.start[kZ]);
    const double x = 0.5 * (m.start[kX] + t * (m.end[kX] - m.start[kX]));
    const bool centre = m.comp == ir::CompSide::off;
    const curves::ProfilePiece* piece = inner_piece(z);
    return piece != nullptr && x - (centre ? radius : 0.0) < piece->curve.at(z).x - piece->tolerance - 0.02;
  }
  [[nodiscard]] bool mills_below(const ir::Motion& m, double t, double radius) const {
    std::array<double, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) at[i] = m.start[i] + t * (m.end[i] - m.start[i]);
    if (m.kind != ir::MotionKind::linear) {
      const double angle = 2 * M_PI * t + std::atan2(-m.center[1], -m.center[0]);
      const double around = std::hypot(m.center[0], m.center[1]);
      at[0] = m.start[0] + m.center[0] + around * std::cos(angle);
      at[1] = m.start[1] + m.center[1] + around * std::sin(angle);
    }
    for (int k = 0; k < 32; ++k) {
      const double angle = 2 * M_PI * k / 32;
      for (const double r : {0.0, radius - 1e-6}) {
        const auto place =
            curves::surface_at(part_.geometry.surfaces, at[0] + r * std::cos(angle), at[1] + r * std::sin(angle));
        if (place && at[2] < place->z - place->tolerance - 0.02) return true;
      }
    }
    return false;
  }

  const Part& part_;
};

std::vector<Part> parts() {
  std::vector<Part> all;
  for (const char* dialect : {"fanuc", "sinumerik-840d"}) {
    all.push_back(part_of("hyperbolic-roll", dialect));
    all.push_back(part_of("stepped-shaft", dialect));
    all.push_back(part_of("round-pocket", dialect));
    all.push_back(part_of("round-pocket", dialect, {{"pocket_depth", "5 mm"}, {"pocket_diameter", "80 mm"}}));
    all.push_back(part_of("nurbs-profile", dialect));
  }
  return all;
}

TEST(GougeFaults, GoodProgramsAreClean) {
  std::vector<Part> all = parts();
  all.push_back(part_of("island-pocket", "fanuc"));
  all.push_back(part_of("engrave-text", "sinumerik-840d"));
  for (const Part& part : all) {
    const gouge::Report report = check(part, part.motions, tools_of(part.geometry));
    EXPECT_FALSE(report.findings.has(text::Severity::error))
        << part.name << ": " << report.findings.kept().front().text << " at line "
        << report.findings.kept().front().place.line;
    EXPECT_GT(report.rapids, 0U);
    EXPECT_GT(report.cuts, 0U);
  }
}

TEST(GougeFaults, TwoHundredSeededOnesAreFoundAtTheirLine) {
  const std::vector<Part> all = parts();
  std::mt19937 random(20260);
  int seeded = 0;
  for (int round = 0; seeded < 200; ++round) {
    const Part& part = all[static_cast<std::size_t>(round) % all.size()];
    Faults faults(part);
    const bool judged = part.turns ? !part.geometry.nominal.empty() : !part.geometry.surfaces.empty();
    const int kind = (round / static_cast<int>(all.size())) % 4;
    if (kind >= 2 && !judged) continue;  // without a nominal surface no cut is too deep
    const Fault fault = kind == 0   ? faults.lowered_rapid(random)
                        : kind == 1 ? faults.shortened_retract(random)
                        : kind == 2 ? faults.wrong_offset(random)
                                    : faults.wrong_radius(random);
    ++seeded;
    const gouge::Report report = check(part, fault.motions, fault.tools);
    EXPECT_TRUE(found_at(report, fault.line))
        << part.name << ", " << fault.what << " at line " << fault.line << "; found "
        << (report.findings.kept().empty() ? std::string("nothing")
                                           : report.findings.kept().front().text + " at line " +
                                                 std::to_string(report.findings.kept().front().place.line));
  }
  EXPECT_EQ(seeded, 200);
}

}  // namespace
}  // namespace dripfeed

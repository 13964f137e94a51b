// The facts against the interpreter: programs made from a seed are run with several inputs and switches, and at each
// message the run's state is compared with what the facts claim there. A fact may say nothing; what it says must hold
// in every run. Without branches it must also say something.
//
// FACTS_STATEMENTS in the environment: how many statements each test makes.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/facts/facts.h"
#include "tests/unit/dialects/compile/facts_programs.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

using facts::Mode;
using facts::Number;
using ir::Function;

Function spindle_of(ir::SpindleState state) {
  if (state == ir::SpindleState::stopped) return Function::spindle_stop;
  return state == ir::SpindleState::clockwise ? Function::spindle_cw : Function::spindle_ccw;
}
Function coolant_of(ir::CoolantState state) {
  if (state == ir::CoolantState::off) return Function::coolant_off;
  return state == ir::CoolantState::mist ? Function::coolant_mist : Function::coolant_flood;
}
Function plane_of(ir::Plane plane) {
  if (plane == ir::Plane::xy) return Function::plane_xy;
  return plane == ir::Plane::zx ? Function::plane_zx : Function::plane_yz;
}
Function feed_of(ir::FeedMode mode) {
  if (mode == ir::FeedMode::per_min) return Function::feed_per_min;
  return mode == ir::FeedMode::per_rev ? Function::feed_per_rev : Function::feed_inverse_time;
}

// Holds a run against the facts.
class Judge {
 public:
  Judge(const ir::Program& program, const ir::Control& control)
      : program_(program), control_(control), resolved_(program, control) {
    for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
      const ir::StatementKind kind = program.statements[i].kind;
      if (kind == ir::StatementKind::message || kind == ir::StatementKind::alarm || kind == ir::StatementKind::assign)
        by_line_.try_emplace(program.statements[i].line, i);
      if (kind == ir::StatementKind::block) blocks_.try_emplace(program.statements[i].line, i);
    }
  }

  void take(const std::vector<ir::Motion>& motions) {
    std::int32_t tool = -1;
    for (const ir::Motion& m : motions) {
      if (m.kind == ir::MotionKind::offset) offset_ = m.number;
      if (m.kind == ir::MotionKind::tool) tool = m.number;
      if (m.kind == ir::MotionKind::message) snapshot(m, tool);
      if (m.kind == ir::MotionKind::rapid || m.kind == ir::MotionKind::linear) move(m);
    }
    offset_ = -1;
  }

  std::vector<std::string> faults;
  std::size_t claims = 0;     // of facts that were certain
  std::size_t unclaimed = 0;  // … that were not

 private:
  template <class T>
  void compare(std::string_view what, const facts::Known<T>& fact, const T& seen, const ir::Motion& m) {
    if (!fact.is_certain()) {
      ++unclaimed;
      return;
    }
    ++claims;
    bool same = fact.value == seen;
    if constexpr (std::is_same_v<T, double>) same = std::abs(fact.value - seen) < 1e-6;
    if (!same) faults.push_back(fmt::format("line {}: {} is otherwise", m.place.line, what));
  }
  void compare_word(std::string_view what, const facts::Known<facts::Written>& fact, double seen, const ir::Motion& m) {
    const facts::Written* word = fact.certain();
    facts::Known<double> number;
    if (word != nullptr && word->is_number) number.set(word->number, fact.origin);
    compare(what, number, seen, m);
  }
  void mode(std::string_view what, const facts::Facts& facts, Mode mode, Function seen, const ir::Motion& m) {
    facts::Known<facts::Setting> fact = facts[mode];
    fact.value.argument = 0;
    compare(what, fact, facts::Setting{.function = seen}, m);
  }

  void snapshot(const ir::Motion& m, std::int32_t tool) {
    const auto found = by_line_.find(m.place.line);
    if (found == by_line_.end()) return;
    const facts::Facts* facts = resolved_.before(found->second);
    if (facts == nullptr) {
      faults.push_back(fmt::format("line {}: no path leads there, and a run did", m.place.line));
      return;
    }
    mode("the plane", *facts, Mode::plane, plane_of(m.plane), m);
    mode("the feed mode", *facts, Mode::feed, feed_of(m.feed_mode), m);
    mode("the spindle", *facts, Mode::spindle, spindle_of(m.spindle), m);
    mode("the coolant", *facts, Mode::coolant, coolant_of(m.coolant), m);
    if (m.surface_speed_m_min > 0.0) mode("G96", *facts, Mode::surface_speed, Function::surface_speed_on, m);
    const bool has_length =
        m.length_offset != ir::LengthOffset::off && (m.length_offset_number != 0 || control_.semantics.d_selects_edge);
    const facts::ToolLength length = facts::tool_length(*facts);
    if (length != facts::ToolLength::unknown && (length == facts::ToolLength::on) != has_length)
      faults.push_back(fmt::format("line {}: the tool length is otherwise", m.place.line));
    if (offset_ >= 0) {
      const facts::Known<facts::Setting>& offset = (*facts)[Mode::work_offset];
      const std::int32_t claimed =
          offset.value.function == Function::extended_offset ? 100 + offset.value.argument : offset.value.argument;
      if (offset.is_certain() && claimed != offset_)
        faults.push_back(fmt::format("line {}: the work offset is otherwise", m.place.line));
    }
    if (tool >= 0) compare_word("the tool", (*facts)[facts::Kept::tool], static_cast<double>(tool), m);
    positions(*facts, m);
  }

  void feed(const facts::Facts& facts, const ir::Motion& m) {
    const facts::Setting* unit = facts[Mode::unit].certain();
    const facts::Written* word = facts[facts::Kept::feed].certain();
    if (!control_.semantics.arc_radius_is_r) return;  // SINUMERIK's feeds may be in another unit than lengths (G70)
    const bool is_plain = word != nullptr && word->is_number && word->number != 0.0 && word->has_point;
    if (unit == nullptr || !is_plain) return;
    const double mm = unit->function == Function::unit_inch ? 25.4 : 1.0;
    compare_word("the feed", facts[facts::Kept::feed], m.feed / mm, m);
  }
  void positions(const facts::Facts& facts, const ir::Motion& m) {
    const facts::Setting* unit = facts[Mode::unit].certain();
    if (unit == nullptr) return;
    const double mm = unit->function == Function::unit_inch ? 25.4 : 1.0;
    for (const auto& [number, axis] : {std::pair(Number::x, 0U), std::pair(Number::y, 1U), std::pair(Number::z, 2U)}) {
      if (!facts[number].is_certain()) continue;
      const double factor = number == Number::x ? x_factor(facts) : 1.0;
      if (factor == 0.0 || shifted_) continue;
      if (((m.axes_unknown >> axis) & 1U) != 0)
        faults.push_back(fmt::format("line {}: the position of {} is not known to the run", m.place.line, "XYZ"[axis]));
      else
        compare(fmt::format("the position of {}", "XYZ"[axis]), facts[number], m.end[axis] / mm / factor, m);
    }
  }
  // What a run's X, always a diameter on a lathe, is of the program's; 0 where that is not known.
  double x_factor(const facts::Facts& facts) const {
    if (control_.kind == ir::MachineKind::mill || !control_.semantics.feed_code_ends_surface_speed) return 1.0;
    const facts::Setting* diameter = facts[Mode::diameter].certain();
    if (diameter == nullptr || diameter->function == Function::diameter_absolute_only) return 0.0;
    return diameter->function == Function::diameter_off ? 2.0 : 1.0;
  }

  void move(const ir::Motion& m) {
    const auto found = blocks_.find(m.place.line);
    if (found == blocks_.end() || m.machine_coordinates) return;
    const ir::Statement& s = program_.statements[found->second];
    if (facts::has_own_words(program_, program_.blocks[s.payload])) return;
    const std::optional<facts::Facts> facts = resolved_.at(found->second);
    if (!facts || !(*facts)[Mode::cycle].is({.function = Function::cycle_off})) return;
    if ((*facts)[Mode::modal_call].is({}) == false) return;  // the call's moves may have the block's line
    if (!(*facts)[Mode::transformation].is({})) return;      // the machine's axes move in pieces
    if (m.kind == ir::MotionKind::linear) feed(*facts, m);
    mode("the motion", *facts, Mode::motion, m.kind == ir::MotionKind::rapid ? Function::rapid : Function::linear, m);
  }

  const ir::Program& program_;
  const ir::Control& control_;
  facts::Resolved resolved_;
  std::map<std::uint32_t, std::uint32_t> by_line_;
  std::map<std::uint32_t, std::uint32_t> blocks_;
  std::int32_t offset_ = -1;

 public:
  bool shifted_ = false;  // frames or shifts in the program: its coordinates are not the work offset's
};

bool has_frames(const ir::Program& program) {
  return std::ranges::any_of(program.codes, [](const ir::Code& c) {
    return c.group == ir::ModalGroup::frame || c.function == Function::local_shift ||
           c.function == Function::set_coordinates || c.function == Function::rotate;
  });
}

std::size_t wanted_statements() {
  const char* text = std::getenv("FACTS_STATEMENTS");
  return text == nullptr ? 20'000 : std::strtoull(text, nullptr, 10);
}

struct Totals {
  std::size_t statements = 0;
  std::size_t runs = 0;
  std::size_t claims = 0;
  std::size_t unclaimed = 0;
};

void judge(const Spelling& spelling, const std::string& text, std::uint32_t seed, Totals& totals) {
  const ir::Control machine = control(std::string(spelling.dialect), spelling.kind);
  const text::Source source("program", text);
  const ir::ReadResult read = find_dialect(machine.dialect)->read(source, machine);
  totals.statements += read.program.statements.size();
  Judge judge(read.program, machine);
  judge.shifted_ = has_frames(read.program);
  for (std::uint32_t run = 0; run < 3; ++run) {
    interpreter::RunOptions options;
    options.limits.blocks = 100'000;
    options.skip_switches = (seed + run) % 2 == 0 ? 2U : 0U;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const double value = (seed / (i + 1) + run * (i + 1)) % 4;
      options.initial_values.push_back({.bank = spelling.has_names ? ir::Bank::r : ir::Bank::hash,
                                        .number = (spelling.has_names ? 1 : 101) + i,
                                        .value = value});
    }
    options.initial_values.push_back({.bank = ir::Bank::hash, .number = 130, .value = 91.0});
    Motions motions;
    ProgramLibrary standard(machine, [](std::string_view) { return std::nullopt; });
    (void)execute(read.program, machine, &standard, motions, options);
    judge.take(motions.all);
    ++totals.runs;
  }
  totals.claims += judge.claims;
  totals.unclaimed += judge.unclaimed;
  ASSERT_TRUE(judge.faults.empty()) << "seed " << seed << " of " << spelling.dialect << ": " << judge.faults.front()
                                    << "\n"
                                    << text;
}

class FactsOracle : public testing::TestWithParam<std::size_t> {};

TEST_P(FactsOracle, SayWhatTheRunDoesWithoutBranches) {
  const Spelling& spelling = spellings()[GetParam()];
  Totals totals;
  for (std::uint32_t seed = 1; totals.statements < wanted_statements() / 4; ++seed) {
    judge(spelling, Generator(spelling, seed).straight(60), seed, totals);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(totals.claims, totals.unclaimed) << "facts that say nothing are no facts";
  RecordProperty("claims", std::to_string(totals.claims));
}

TEST_P(FactsOracle, ClaimNothingThatARunContradicts) {
  const Spelling& spelling = spellings()[GetParam()];
  Totals totals;
  for (std::uint32_t seed = 1; totals.statements < wanted_statements(); ++seed) {
    judge(spelling, Generator(spelling, seed).branching(60), seed, totals);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(totals.claims, totals.unclaimed / 4);
  RecordProperty("claims", std::to_string(totals.claims));
}

INSTANTIATE_TEST_SUITE_P(Controls, FactsOracle, testing::Values(0U, 1U, 2U, 3U));

}  // namespace
}  // namespace dripfeed::compile::test

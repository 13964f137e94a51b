// A worklist over the places where control-flow paths join (leaders); between them the statements follow each other, so
// that only the leaders' facts are kept. Facts only ever get weaker, so the list runs empty.
#include "dialects/facts/resolved.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "dialects/facts/called_cycle_effects.h"
#include "dialects/facts/calls.h"
#include "dialects/facts/kept_words.h"
#include "dialects/ir/sections.h"

namespace dripfeed::facts {

namespace {

using ir::Function;
using ir::StatementKind;

// What PROC … SAVE gives back when it returns. (PGA, "Subprogram with SAVE".)
constexpr std::array kSaved = {Mode::feed,        Mode::surface_speed, Mode::unit,   Mode::distance,
                               Mode::plane,       Mode::diameter,      Mode::motion, Mode::compensation,
                               Mode::work_offset, Mode::return_level,  Mode::path};

// Function::none means here that nothing of the kind is in effect.
constexpr std::array kMayBeOff = {Mode::frame, Mode::modal_call, Mode::transformation, Mode::thread_data,
                                  Mode::peck_data};

void overwrite(Facts& facts, const FactSet& which, const Facts& with) {
  for (std::size_t i = 0; i < kModes; ++i)
    if (which[i]) facts.modes[i] = with.modes[i];
  for (std::size_t i = 0; i < kNumbers; ++i)
    if (which[kModes + i]) facts.numbers[i] = with.numbers[i];
  for (std::size_t i = 0; i < kKept; ++i)
    if (which[kModes + kNumbers + i]) facts.kept[i] = with.kept[i];
}

void forget(Facts& facts, const FactSet& which, std::uint32_t changer) {
  for (std::size_t i = 0; i < kModes; ++i)
    if (which[i]) facts.modes[i].forget(changer);
  // By a program of this text these may be on, and positions are other ones then.
  for (const Mode mode : {Mode::letters, Mode::transformation})
    if (which[index_of(mode)]) facts[mode].more = true;
  for (std::size_t i = 0; i < kNumbers; ++i)
    if (which[kModes + i]) facts.numbers[i].forget(changer);
  for (std::size_t i = 0; i < kKept; ++i)
    if (which[kModes + kNumbers + i]) facts.kept[i].forget(changer);
}

}  // namespace

Resolved::Resolved(const ir::Program& program, const ir::Control& control, ToolChange change)
    : program_(program),
      control_(control),
      graph_(program),
      effects_(program, control, change),
      shapes_(shapes_of(program)),
      part_of_call_(program.statements.size(), ir::kNoIndex),
      is_leader_(program.statements.size() + 1, false) {
  find_parts();
  find_calls();
  find_touched();
  find_leaders();
  flow();
}

// --- the answers

const Facts* Resolved::before(std::uint32_t statement) const {
  if (statement == cursor_) return &cursor_facts_;
  const auto after = std::ranges::upper_bound(leaders_, statement);
  if (after == leaders_.begin()) return nullptr;
  const auto leader = static_cast<std::size_t>(after - leaders_.begin()) - 1;
  if (!at_leaders_[leader].has_value()) return nullptr;
  const bool goes_on = cursor_ != ir::kNoIndex && leaders_[leader] <= cursor_ && cursor_ <= statement;
  if (!goes_on) {
    cursor_ = leaders_[leader];
    cursor_facts_ = *at_leaders_[leader];
  }
  for (; cursor_ < statement; ++cursor_) {
    effects_.apply(cursor_, cursor_facts_);
    step_over_modal_calls(cursor_, cursor_facts_);
  }
  return &cursor_facts_;
}

std::optional<Setting> Resolved::certain(Mode mode, std::uint32_t statement) const {
  const Facts* facts = before(statement);
  const Setting* setting = facts == nullptr ? nullptr : (*facts)[mode].certain();
  return setting == nullptr ? std::nullopt : std::optional(*setting);
}

std::optional<Facts> Resolved::at(std::uint32_t statement) const {
  const Facts* facts = before(statement);
  if (facts == nullptr) return std::nullopt;
  std::optional<Facts> out = *facts;
  effects_.carry_out(statement, *out);
  return out;
}

std::string Resolved::program_at(std::uint32_t statement) const {
  const auto after = std::ranges::upper_bound(program_.sections, statement, {}, &ir::Section::first);
  if (after == program_.sections.begin()) return program_.name;
  return std::string(program_.strings.at(std::prev(after)->name));
}

std::vector<std::string> Resolved::paths(const Known<Setting>& fact) const {
  const auto path = [this](const Setting& setting, std::uint32_t origin) {
    const std::string_view what = description_of(setting);
    if (origin == kPowerOn) return fmt::format("{} at power-on", what);
    if (origin == kCaller) return fmt::format("{} as stated for its caller", what);
    const std::string name = program_at(origin);
    return fmt::format("{} from line {}{}", what, program_.statements[origin].line, name.empty() ? "" : " of " + name);
  };
  std::vector<std::string> out;
  if (fact.origin != kNoStatement) out.push_back(path(fact.value, fact.origin));
  if (fact.other_origin != kNoStatement) out.push_back(path(fact.other, fact.other_origin));
  if (fact.inherited) out.emplace_back("what a caller outside of this text has set");
  return out;
}

// --- the programs of the text

void Resolved::find_parts() {
  for (const ir::Section& section : program_.sections)
    parts_.push_back({.range = {.first = section.first, .last = section.last}, .name = section.name});
  if (parts_.empty())
    parts_.push_back({.range = {.first = 0, .last = static_cast<std::uint32_t>(program_.statements.size())}});
  for (Part& part : parts_) {
    for (std::uint32_t i = part.range.first; i < part.range.last; ++i) {
      const ir::Statement& s = program_.statements[i];
      part.saves_modes |= s.kind == StatementKind::procedure && program_.structures[s.payload].saves_modal;
    }
  }
}

std::uint32_t Resolved::part_at(std::uint32_t statement) const {
  const auto after = std::ranges::upper_bound(parts_, statement, {}, [](const Part& part) { return part.range.first; });
  return after == parts_.begin() ? 0 : static_cast<std::uint32_t>(after - parts_.begin()) - 1;
}

// kNoIndex: a program that is not in the text, or only known while it runs.
std::uint32_t Resolved::part_called_by(const ir::Statement& s) const {
  const ir::Call& call = program_.calls[s.payload];
  if (call.kind == ir::CallKind::external || call.name == ir::StringId::none) return ir::kNoIndex;
  if (call.start != ir::ExpressionId::none || call.first_label != ir::ExpressionId::none || call.in_other_language)
    return ir::kNoIndex;
  const auto part = std::ranges::find(parts_, call.name, &Part::name);
  return part == parts_.end() ? ir::kNoIndex : static_cast<std::uint32_t>(part - parts_.begin());
}

void Resolved::find_calls() {
  for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
    if (!is_call(program_.statements[i].kind)) continue;
    const std::uint32_t part = part_called_by(program_.statements[i]);
    if (part == ir::kNoIndex) continue;
    part_of_call_[i] = part;
    parts_[part].is_called = true;
    parts_[part].callers.push_back(i);
  }
}

// What a program calls counts as its own, so this goes round until nothing is added.
void Resolved::find_touched() {
  for (std::uint32_t i = 0; i < program_.statements.size() && parts_.size() > 1; ++i)
    if (part_of_call_[i] == ir::kNoIndex) parts_[part_at(i)].touched |= effects_.touched(i);
  for (bool added = parts_.size() > 1; added;) {
    added = false;
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      if (part_of_call_[i] == ir::kNoIndex) continue;
      Part& caller = parts_[part_at(i)];
      const FactSet both = caller.touched | parts_[part_of_call_[i]].touched;
      added |= both != caller.touched;
      caller.touched = both;
    }
  }
}

// --- the walk

void Resolved::find_leaders() {
  const auto count = static_cast<std::uint32_t>(program_.statements.size());
  for (const std::uint32_t entry : graph_.entries()) is_leader_[entry] = true;
  bool returns_to_blocks = false;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::vector<std::uint32_t>& next = graph_.after(i);
    const bool falls_through = next.size() == 1 && next.front() == i + 1 && part_of_call_[i] == ir::kNoIndex;
    returns_to_blocks |= program_.statements[i].kind == StatementKind::return_to;
    if (falls_through) continue;
    for (const std::uint32_t to : next) is_leader_[to] = true;
    is_leader_[i + 1] = true;
  }
  for (const Shape& shape : shapes_)
    is_leader_[shape.first] = is_leader_[shape.end] = is_leader_[shape.cycle + 1] = true;
  for (const ir::Label& label : program_.labels)
    if (returns_to_blocks) is_leader_[label.statement] = true;
  for (std::uint32_t i = 0; i <= count; ++i)
    if (is_leader_[i]) leaders_.push_back(i);
  at_leaders_.resize(leaders_.size());
}

Facts Resolved::start_of(const Part& part) const {
  Facts facts;
  const bool inherits = ir::is_subprogram(program_, part.range.first, part.range.last);
  for (std::size_t m = 0; m < kModes; ++m) {
    const Setting begin = power_on(static_cast<Mode>(m), control_);
    if (inherits)
      facts.modes[m].inherited = true;
    else if (begin.function == Function::none && std::ranges::find(kMayBeOff, static_cast<Mode>(m)) == kMayBeOff.end())
      facts.modes[m].begin_unknown();
    else
      facts.modes[m].begin(begin);
  }
  const auto begin = [inherits](auto& all) {
    for (auto& fact : all) {
      fact.inherited = inherits;
      if (!inherits) fact.begin_unknown();
    }
  };
  begin(facts.numbers);
  begin(facts.kept);
  if (!inherits) {
    for (const Number shift : {Number::shift_x, Number::shift_y, Number::shift_z}) facts[shift].begin(0.0);
    for (const Kept word : {Kept::feed, Kept::speed, Kept::surface_speed, Kept::spindle_limit})
      facts[word].begin({.is_number = true});
  }
  // These, left on by a caller outside of the text, are not looked for.
  for (const Mode mode : {Mode::modal_call, Mode::transformation, Mode::letters}) {
    facts[mode] = {};
    facts[mode].begin(power_on(mode, control_));
  }
  for (const ir::CodeRow& row : control_.caller_modes) {
    ir::Code code;
    code.function = row.function;
    code.group = row.group;
    if (const std::optional<Mode> mode = mode_of(code))
      facts[*mode].set({.function = row.function, .argument = row.argument}, kCaller);
  }
  return facts;
}

void Resolved::reach(std::uint32_t statement, const Facts& facts) {
  const auto leader = static_cast<std::size_t>(std::ranges::lower_bound(leaders_, statement) - leaders_.begin());
  std::optional<Facts>& there = at_leaders_[leader];
  const bool is_new = !there.has_value();
  if (is_new) there = facts;
  if (is_new || there->join(facts)) work_.push_back(statement);
}

void Resolved::flow() {
  for (const std::uint32_t entry : graph_.entries()) {
    const Part& part = parts_[part_at(entry)];
    Facts start = start_of(part);
    if (entry != part.range.first) start.forget_all(entry);
    if (entry != part.range.first || !part.is_called) reach(entry, start);
  }
  while (!work_.empty()) {
    const std::uint32_t leader = work_.back();
    work_.pop_back();
    run_from(leader);
  }
}

void Resolved::run_from(std::uint32_t leader) {
  const auto count = static_cast<std::uint32_t>(program_.statements.size());
  const auto index = static_cast<std::size_t>(std::ranges::lower_bound(leaders_, leader) - leaders_.begin());
  const std::uint32_t end = index + 1 < leaders_.size() ? leaders_[index + 1] : count;
  if (end == leader || leads_nowhere(leader, end - 1)) return;
  Facts facts = *at_leaders_[index];
  for (std::uint32_t i = leader; i < count; ++i) {
    if (!step(i, facts)) return;
    if (ends_part(i)) leave(i, facts);
    const std::vector<std::uint32_t>& next = graph_.after(i);
    if (next.size() == 1 && next.front() == i + 1 && !is_leader_[i + 1]) continue;
    for (const std::uint32_t to : std::vector(next)) go_on(i, to, facts);
    return;
  }
}

// Nothing asks for the state after the last statement of such a stretch: most programs are one.
bool Resolved::leads_nowhere(std::uint32_t from, std::uint32_t last) const {
  const StatementKind kind = program_.statements[last].kind;
  if (kind != StatementKind::program_end || part_of_call_[from] != ir::kNoIndex) return false;
  return shapes_.empty() && !parts_[part_at(last)].is_called && program_.statements[last].skip_level == 0;
}

// A cycle runs its shape in what it finds; after roughing, what held before it does again.
void Resolved::go_on(std::uint32_t from, std::uint32_t to, const Facts& facts) {
  bool leaves_shape = false;
  for (const Shape& shape : shapes_) {
    if (from == shape.cycle) reach(shape.first, facts);
    if (from == shape.cycle && shape.is_left_out) reach(shape.end, facts);
    leaves_shape |= shape.is_left_out && from >= shape.first && from < shape.end && to == shape.end;
  }
  if (!leaves_shape) reach(to, facts);
}

// The run goes back to its caller after the statement: by a return, or at the end of its text.
bool Resolved::ends_part(std::uint32_t statement) const {
  const StatementKind kind = program_.statements[statement].kind;
  if (kind == StatementKind::program_end) return control_.semantics.end_in_subprogram_returns;
  return ir::returns(kind) || statement + 1 == parts_[part_at(statement)].range.last;
}

bool Resolved::step(std::uint32_t statement, Facts& facts) {
  const std::uint32_t part = part_of_call_[statement];
  if (part == ir::kNoIndex) {
    effects_.apply(statement, facts);
    step_over_modal_calls(statement, facts);
    return true;
  }
  if (program_.statements[statement].kind == StatementKind::call) return step_over_call(statement, parts_[part], facts);
  // From here on the program is called after each move, in whatever is in effect there.
  effects_.apply(statement, facts);
  Facts anywhere = facts;
  anywhere.forget_all(statement);
  reach(parts_[part].range.first, anywhere);
  return true;
}

bool Resolved::step_over_call(std::uint32_t statement, Part& part, Facts& facts) {
  const ir::Statement& s = program_.statements[statement];
  const bool is_repeated = program_.calls[s.payload].repeats != ir::ExpressionId::none;
  Facts entered = facts;
  forget_computed(entered);
  reach(part.range.first, entered);
  const bool may_be_left_out = s.skip_level != 0 || is_repeated;
  if (!part.exit.has_value() && part.touched.any()) return may_be_left_out;
  Facts after = facts;
  FactSet changed = part.touched;
  if (part.saves_modes)
    for (const Mode mode : kSaved) changed[index_of(mode)] = false;
  if (part.exit.has_value()) {
    Facts left = *part.exit;
    forget_computed(left);
    overwrite(after, changed, left);
  }
  if (is_repeated) {
    entered = after;
    forget_computed(entered);
    reach(part.range.first, entered);
  }
  enter_callers_at_labels(statement, part, after);
  if (may_be_left_out) after.join(facts);
  facts = after;
  return true;
}

// M99 P100 goes on at a block of the caller.
void Resolved::enter_callers_at_labels(std::uint32_t statement, const Part& part, const Facts& facts) {
  const StatementRange own = section_of(program_, statement);
  for (std::uint32_t i = part.range.first; i < part.range.last; ++i) {
    if (program_.statements[i].kind != StatementKind::return_to) continue;
    const ir::Jump& jump = program_.jumps[program_.statements[i].payload];
    for (const ir::Label& label : program_.labels) {
      const bool is_here = label.statement >= own.first && label.statement < own.last;
      const bool matches =
          jump.computed != ir::ExpressionId::none || jump.label != ir::StringId::none || label.number == jump.number;
      if (is_here && matches) reach(label.statement, facts);
    }
  }
}

// Each block that moves calls what a modal call in effect names.
void Resolved::step_over_modal_calls(std::uint32_t statement, Facts& facts) const {
  const Known<Setting> called = facts[Mode::modal_call];
  const Moving moving = effects_.moving(program_.statements[statement]);
  if (moving == Moving::no) return;
  const auto call = [&](const Setting& setting) {
    if (setting.function == Function::none) return;
    const auto caller = static_cast<std::uint32_t>(setting.argument);
    if (part_of_call_[caller] != ir::kNoIndex) return forget(facts, parts_[part_of_call_[caller]].touched, caller);
    const ir::Statement& s = program_.statements[caller];
    if (!is_call(s.kind) || !is_standard_cycle(program_, s)) return facts.forget_all(caller);
    // Where paths disagree about the call, another may be made, or none.
    CalledCycleEffects{program_, control_, caller, facts}.at_position(moving == Moving::yes && called.is_certain());
  };
  if (called.more) facts.forget_all(called.other_origin);
  if (called.origin != kNoStatement) call(called.value);
  if (called.other_origin != kNoStatement) call(called.other);
}

// Back to whoever called the program.
void Resolved::leave(std::uint32_t statement, const Facts& facts) {
  Part& part = parts_[part_at(statement)];
  const bool restarts =
      !part.is_called && ir::returns(program_.statements[statement].kind) && control_.semantics.return_in_main_restarts;
  if (restarts) reach(part.range.first, facts);
  const bool is_new = !part.exit.has_value();
  if (is_new) part.exit = facts;
  if (!is_new && !part.exit->join(facts)) return;
  for (const std::uint32_t caller : part.callers) {
    const auto leader = std::prev(std::ranges::upper_bound(leaders_, caller));
    if (at_leaders_[static_cast<std::size_t>(leader - leaders_.begin())].has_value()) work_.push_back(*leader);
  }
}

}  // namespace dripfeed::facts

// A worklist over the statements of all programs of the text. A call of one of them joins its modes into that
// program's start; a mode that the called program never sets goes past the call unchanged, the others come from its
// returns. Facts only ever get weaker, so the list runs empty.
#include "dialects/passes/mode_flow.h"

#include <algorithm>

#include <fmt/format.h>

namespace dripfeed::passes {

namespace {

using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

struct FunctionRow {
  Function function;
  Mode mode;
  std::string_view said;
};
constexpr FunctionRow kFunctions[] = {
    {Function::feed_per_min, Mode::feed, "feed per minute"},
    {Function::feed_per_rev, Mode::feed, "feed per revolution"},
    {Function::feed_inverse_time, Mode::feed, "inverse-time feed"},
    {Function::surface_speed_on, Mode::surface_speed, "constant surface speed"},
    {Function::surface_speed_off, Mode::surface_speed, "constant spindle speed"},
    {Function::unit_inch, Mode::unit, "inch"},
    {Function::unit_mm, Mode::unit, "millimetre"},
    {Function::absolute, Mode::distance, "absolute"},
    {Function::incremental, Mode::distance, "incremental"},
    {Function::plane_xy, Mode::plane, "the plane XY"},
    {Function::plane_zx, Mode::plane, "the plane ZX"},
    {Function::plane_yz, Mode::plane, "the plane YZ"},
    {Function::diameter_on, Mode::diameter, "diameter"},
    {Function::diameter_off, Mode::diameter, "radius"},
    {Function::diameter_absolute_only, Mode::diameter, "diameter where absolute"},
};

const FunctionRow* row_of(Function function) {
  const auto* const row = std::ranges::find(kFunctions, function, &FunctionRow::function);
  return row == std::end(kFunctions) ? nullptr : row;
}

bool returns(const ir::Statement& s) {
  return s.kind == StatementKind::subprogram_return || s.kind == StatementKind::return_to;
}

}  // namespace

bool is_call(StatementKind kind) { return kind == StatementKind::call || kind == StatementKind::modal_call; }

bool keeps_modes(StatementKind kind) {
  using enum StatementKind;
  switch (kind) {
    case empty:
    case assign:
    case go_to:
    case if_begin:
    case else_begin:
    case if_end:
    case while_begin:
    case while_end:
    case repeat_begin:
    case repeat_end:
    case for_begin:
    case for_end:
    case loop_begin:
    case loop_end:
    case define:
    case declaration:
    case procedure:
    case message:
    case alarm:
    case output: return true;
    case block:
    case call:
    case subprogram_return:
    case return_to:
    case modal_call:
    case modal_call_end:
    case program_end:
    case native:
    case repeat_section:
    case execute_text: return false;
  }
  return false;
}

bool is_standard_cycle(const ir::Program& program, const ir::Statement& call) {
  const std::string_view name = program.strings.at(program.calls[call.payload].name);
  return name.starts_with("CYCLE") || name.starts_with("HOLES");
}

std::optional<Mode> mode_of(const ir::Code& code) {
  const FunctionRow* row = row_of(code.function);
  return row == nullptr ? std::nullopt : std::optional(row->mode);
}

ir::Function power_on(Mode mode, const ir::Semantics& s) {
  switch (mode) {
    case Mode::feed: return s.power_on_feed;
    case Mode::surface_speed: return Function::surface_speed_off;
    case Mode::unit: return s.power_on_unit;
    case Mode::distance: return s.power_on_distance;
    case Mode::plane: return s.power_on_plane;
    case Mode::diameter:
      return s.power_on_diameter == ir::DiameterMode::radius     ? Function::diameter_off
             : s.power_on_diameter == ir::DiameterMode::diameter ? Function::diameter_on
                                                                 : Function::diameter_absolute_only;
    case Mode::count_: break;
  }
  return Function::none;
}

bool ModeFact::meet(const ModeFact& with) {
  const ModeFact old = *this;
  const auto take = [this](Function f, std::uint32_t from) {
    if (f == Function::none || f == function || f == other) return;
    if (function == Function::none) {
      function = f;
      origin = from;
    } else if (other == Function::none) {
      other = f;
      other_origin = from;
    }
  };
  take(with.function, with.origin);
  take(with.other, with.other_origin);
  inherited |= with.inherited;
  if (changer == ir::kNoIndex) changer = with.changer;
  return *this != old;
}

ModeFlow::ModeFlow(const ir::Program& program, const ir::Control& control)
    : program_(program), control_(control), graph_(program), before_(program.statements.size() + 1) {
  find_parts();
  find_calls();
  find_changes();
  flow();
}

const ModeFacts* ModeFlow::before(std::uint32_t statement) const {
  return before_[statement].has_value() ? &*before_[statement] : nullptr;
}

void ModeFlow::find_parts() {
  for (const ir::Section& section : program_.sections)
    parts_.push_back({.range = {section.first, section.last}, .name = section.name});
  if (parts_.empty()) parts_.push_back({.range = {0, static_cast<std::uint32_t>(program_.statements.size())}});
}

ModeFlow::Part& ModeFlow::part_at(std::uint32_t statement) {
  const auto behind = std::ranges::upper_bound(parts_, statement, {}, [](const Part& p) { return p.range.first; });
  return behind == parts_.begin() ? parts_.front() : *std::prev(behind);
}

// nullptr: a program that is not in the text, or only known while it runs.
ModeFlow::Part* ModeFlow::called_by(const ir::Statement& s) {
  const ir::Call& call = program_.calls[s.payload];
  if (call.kind == ir::CallKind::external || call.name == ir::StringId::none) return nullptr;
  if (call.start != ir::ExpressionId::none || call.first_label != ir::ExpressionId::none || call.in_other_language)
    return nullptr;
  const auto part = std::ranges::find(parts_, call.name, &Part::name);
  return part == parts_.end() ? nullptr : &*part;
}

void ModeFlow::find_calls() {
  for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
    if (!is_call(program_.statements[i].kind)) continue;
    Part* part = called_by(program_.statements[i]);
    if (part == nullptr) continue;
    part->is_called = true;
    part->callers.push_back(i);
  }
}

// Statements whose effect is not in the text.
bool ModeFlow::may_change(const ir::Statement& s) const {
  if (s.kind == StatementKind::native) return !program_.natives[s.payload].effects_known;
  if (s.kind == StatementKind::repeat_section || s.kind == StatementKind::execute_text) return true;
  if (s.kind != StatementKind::block) return false;
  return std::ranges::any_of(program_.codes_of(program_.blocks[s.payload]),
                             [](const ir::Code& c) { return c.number != ir::ExpressionId::none && c.letter == 'G'; });
}

// What a program calls counts as its own, so this goes round until nothing is added.
void ModeFlow::find_changes() {
  bool added = true;
  const auto add = [&](Part& part, std::size_t mode) {
    added |= !part.changes[mode];
    part.changes[mode] = true;
  };
  while (added) {
    added = false;
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      Part& part = part_at(i);
      const Part* called = is_call(s.kind) ? called_by(s) : nullptr;
      const bool unseen = is_call(s.kind) && called == nullptr && !is_standard_cycle(program_, s);
      const bool all = may_change(s) || unseen;
      for (std::size_t mode = 0; mode < kModes; ++mode)
        if (all || (called != nullptr && called->changes[mode])) add(part, mode);
      if (s.kind != StatementKind::block) continue;
      for (const ir::Code& code : program_.codes_of(program_.blocks[s.payload])) {
        if (const auto mode = mode_of(code)) add(part, index_of(*mode));
        if (code.group == ModalGroup::feed) add(part, index_of(Mode::surface_speed));
      }
    }
  }
}

// A program that somebody calls and nobody in the text does begins in what that caller set. One with an end of its own
// is a main program and begins as the control woke up.
ModeFacts ModeFlow::start_of(const Part& part) const {
  ModeFacts facts;
  bool sub = false;
  bool ends = false;
  for (std::uint32_t i = part.range.first; i < part.range.last; ++i) {
    const ir::Statement& s = program_.statements[i];
    sub |= returns(s) || s.kind == StatementKind::procedure;
    ends |= s.kind == StatementKind::program_end;
  }
  for (std::size_t m = 0; m < kModes; ++m) {
    if (sub && !ends) {
      facts[m].inherited = true;
      for (const ir::CodeRow& row : control_.caller_modes) {
        const FunctionRow* mode = row_of(row.function);
        if (mode != nullptr && index_of(mode->mode) == m)
          facts[m] = {.function = row.function, .origin = ModeFact::kCaller};
      }
    } else {
      facts[m].function = power_on(static_cast<Mode>(m), control_.semantics);
      facts[m].origin = ModeFact::kPowerOn;
    }
  }
  return facts;
}

void ModeFlow::reach(std::uint32_t statement, const ModeFacts& facts) {
  std::optional<ModeFacts>& there = before_[statement];
  bool weaker = !there.has_value();
  if (weaker) {
    there = facts;
  } else {
    for (std::size_t m = 0; m < kModes; ++m) weaker |= (*there)[m].meet(facts[m]);
  }
  if (weaker) work_.push_back(statement);
}

void ModeFlow::flow() {
  for (const std::uint32_t entry : graph_.entries()) {
    const Part& part = part_at(entry);
    ModeFacts start = start_of(part);
    if (entry != part.range.first) forget(entry, start);
    if (entry != part.range.first || !part.is_called) reach(entry, start);
  }
  while (!work_.empty()) {
    const std::uint32_t i = work_.back();
    work_.pop_back();
    if (i >= program_.statements.size()) continue;
    const std::optional<ModeFacts> out = after(i, *before_[i]);
    if (!out) continue;
    const StatementKind kind = program_.statements[i].kind;
    const bool falls_off = i + 1 == part_at(i).range.last && kind != StatementKind::program_end;
    if (returns(program_.statements[i]) || falls_off) leave(i, *out);
    for (const std::uint32_t next : graph_.after(i)) reach(next, *out);
  }
}

// Nothing behind a call whose program has not come back yet.
std::optional<ModeFacts> ModeFlow::after(std::uint32_t i, const ModeFacts& facts) {
  const ir::Statement& s = program_.statements[i];
  ModeFacts out = facts;
  if (is_call(s.kind)) {
    Part* part = called_by(s);
    if (part != nullptr) return after_call(s, *part, facts);
    if (!is_standard_cycle(program_, s)) forget(i, out);
    return out;
  }
  if (may_change(s)) forget(i, out);
  if (s.kind == StatementKind::block) take_block(i, out);
  return out;
}

std::optional<ModeFacts> ModeFlow::after_call(const ir::Statement& s, const Part& part, const ModeFacts& facts) {
  reach(part.range.first, facts);
  const bool any = std::ranges::find(part.changes, true) != part.changes.end();
  if (any && !part.exit.has_value()) return std::nullopt;
  ModeFacts out = facts;
  for (std::size_t m = 0; m < kModes; ++m)
    if (part.changes[m]) out[m] = (*part.exit)[m];
  // It is called behind each move from here on, and not yet.
  if (s.kind == StatementKind::modal_call)
    for (std::size_t m = 0; m < kModes; ++m) out[m].meet(facts[m]);
  return out;
}

// Back to whoever called the program.
void ModeFlow::leave(std::uint32_t i, const ModeFacts& facts) {
  Part& part = part_at(i);
  bool weaker = !part.exit.has_value();
  if (weaker) {
    part.exit = facts;
  } else {
    for (std::size_t m = 0; m < kModes; ++m) weaker |= (*part.exit)[m].meet(facts[m]);
  }
  if (!weaker) return;
  for (const std::uint32_t caller : part.callers)
    if (before_[caller].has_value()) work_.push_back(caller);
}

void ModeFlow::take_block(std::uint32_t i, ModeFacts& facts) const {
  const auto codes = program_.codes_of(program_.blocks[program_.statements[i].payload]);
  const bool speed = std::ranges::any_of(codes, [](const ir::Code& c) { return mode_of(c) == Mode::surface_speed; });
  for (const ir::Code& code : codes) {
    const std::optional<Mode> mode = mode_of(code);
    if (!mode) continue;
    facts[index_of(*mode)] = {.function = code.function, .origin = i};
    if (*mode == Mode::feed && !speed && control_.semantics.feed_code_ends_surface_speed)
      facts[index_of(Mode::surface_speed)] = {.function = Function::surface_speed_off, .origin = i};
  }
}

void ModeFlow::forget(std::uint32_t changer, ModeFacts& facts) const {
  for (ModeFact& fact : facts)
    if (fact.changer == ir::kNoIndex) fact.changer = changer;
}

std::string ModeFlow::program_at(std::uint32_t statement) const {
  const auto behind = std::ranges::upper_bound(program_.sections, statement, {}, &ir::Section::first);
  if (behind == program_.sections.begin()) return program_.name;
  return std::string(program_.strings.at(std::prev(behind)->name));
}

std::string ModeFlow::way(Function function, std::uint32_t origin) const {
  const FunctionRow* row = row_of(function);
  const std::string_view said = row == nullptr ? ir::name_of(function) : row->said;
  if (origin == ModeFact::kPowerOn) return fmt::format("{} as the control wakes up", said);
  if (origin == ModeFact::kCaller) return fmt::format("{} as was said of its caller", said);
  const std::string name = program_at(origin);
  return fmt::format("{} from line {}{}", said, program_.statements[origin].line, name.empty() ? "" : " of " + name);
}

std::vector<std::string> ModeFlow::ways(const ModeFact& fact) const {
  std::vector<std::string> out;
  if (fact.function != Function::none) out.push_back(way(fact.function, fact.origin));
  if (fact.other != Function::none) out.push_back(way(fact.other, fact.other_origin));
  if (fact.inherited) out.emplace_back("what a caller outside of this text has set");
  return out;
}

}  // namespace dripfeed::passes

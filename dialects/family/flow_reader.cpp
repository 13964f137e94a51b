// The verbs of a body that lead through it: blocks with their `end`, assignments and calls. A line with a fault gives
// no step, but opens and closes its block all the same, so that one fault does not make ten.
#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/body_reader.h"

namespace dripfeed::family {

namespace {

constexpr std::size_t kMostSteps = 100'000;

}  // namespace

void BodyReader::profile() {
  if (open_profiles_++ > 0) cursor_.syntax(verb_, "a profile inside a profile");
  add(step(StepKind::profile_begin));
  open_.push_back({StepKind::profile_begin, verb_, line_});
  scope_.open();
}

void BodyReader::for_loop() {
  Step out = step(StepKind::for_begin);
  const std::optional<NewName> name = expect_new_name(cursor_, scope_);
  if (name && cursor_.accept_word("in")) return for_in(*name);
  Typed from;
  if (name && cursor_.expect_word("from")) {
    from = expressions_.value();
    out.down = !cursor_.line_failed() && cursor_.accept_word("down");
    cursor_.expect_word("to");
    out.values[0] = from.id;
    if (!cursor_.line_failed()) out.values[1] = expressions_.value_of(from.dimension).id;
    cursor_.expect_word("step");
    if (!cursor_.line_failed()) out.values[2] = expressions_.value_of(from.dimension).id;
  }
  open_.push_back({StepKind::for_begin, verb_, line_});
  scope_.open();
  if (name) out.target = scope_.define(family_.arena, name->name, from.dimension, name->span);
  add(std::move(out));
}

// for NAME in LIST: the name takes each number of the list in turn.
void BodyReader::for_in(const NewName& name) {
  Step out = step(StepKind::for_in_begin);
  const Scope::Name* list = cursor_.peek().kind == LexemeKind::word ? scope_.find(cursor_.word()) : nullptr;
  Dimension dimension;
  if (list == nullptr || list->kind != NameKind::list) {
    cursor_.expected("the name of a list");
  } else {
    const auto row = std::ranges::find(family_.lists, list->symbol, &List::symbol);
    out.number = static_cast<std::int32_t>(row - family_.lists.begin());
    dimension = list->dimension;
    cursor_.advance();
  }
  open_.push_back({StepKind::for_in_begin, verb_, line_});
  scope_.open();
  out.target = scope_.define(family_.arena, name.name, dimension, name.span);
  add(std::move(out));
}

void BodyReader::while_loop() {
  Step out = step(StepKind::while_begin);
  out.values[0] = expressions_.condition().id;
  add(std::move(out));
  open_.push_back({StepKind::while_begin, verb_, line_});
  scope_.open();
}

void BodyReader::if_block() {
  Step out = step(StepKind::if_begin);
  out.values[0] = expressions_.condition().id;
  add(std::move(out));
  open_.push_back({StepKind::if_begin, verb_, line_});
  scope_.open();
}

void BodyReader::else_block() {
  if (open_.empty() || open_.back().kind != StepKind::if_begin || open_.back().has_else) {
    return cursor_.syntax(verb_, "an 'else' without its 'if'");
  }
  open_.back().has_else = true;
  if (open_.back().changes_tool) tool_diameter_ = ir::ExpressionId::none;
  scope_.close();
  scope_.open();
  add(step(StepKind::if_else));
}

void BodyReader::end() {
  if (open_.empty()) {
    ended_ = true;
    return;
  }
  const Open open = open_.back();
  open_.pop_back();
  const bool is_once = open.kind == StepKind::let;                             // mirrored
  if (open.changes_tool && !is_once) tool_diameter_ = ir::ExpressionId::none;  // it may be another one
  if (open.copies) end_copies(*open.copies, open.span);
  if (is_once) return scope_.close();
  if (open.kind == StepKind::contour) {
    end_rough();
    return scope_.close();
  }
  if (open.kind == StepKind::offset) {
    end_offset();
    return scope_.close();
  }
  if (open.kind == StepKind::polar_begin || open.kind == StepKind::cylinder_begin) {
    close_face();
    return scope_.close();
  }
  if (open.kind == StepKind::profile_begin) --open_profiles_;
  if (open.kind == StepKind::drill_begin) --open_drills_;
  scope_.close();
  if (open.kind == StepKind::profile_begin) {
    if (line_ > open.line + 1) family_.profiles.push_back({open.line + 1, line_ - 1});
    return add(step(StepKind::profile_end));
  }
  static constexpr std::array<std::pair<StepKind, StepKind>, 5> kEnds = {
      {{StepKind::for_begin, StepKind::for_end},
       {StepKind::for_in_begin, StepKind::for_in_end},
       {StepKind::while_begin, StepKind::while_end},
       {StepKind::if_begin, StepKind::if_end},
       {StepKind::drill_begin, StepKind::drill_end}}};
  add(step(std::ranges::find(kEnds, open.kind, &std::pair<StepKind, StepKind>::first)->second));
}

void BodyReader::let() {
  Step out = step(StepKind::let);
  const std::optional<NewName> name = expect_new_name(cursor_, scope_);
  if (!name || !cursor_.expect_symbol("=")) return;
  const Typed value = expressions_.value();
  out.values[0] = value.id;
  if (!cursor_.line_failed())
    out.target = scope_.define(family_.arena, name->name, value.dimension, name->span, NameKind::variable);
  add(std::move(out));
}

// set NAME = value, set LIST[index] = value
void BodyReader::set() {
  Step out = step(StepKind::set);
  const std::optional<ExpressionReader::Place> place = expressions_.place();
  if (!place || !cursor_.expect_symbol("=")) return;
  out.target = place->name.symbol;
  out.values[1] = place->index;
  out.values[0] = expressions_.value_of(place->name.dimension).id;
  add(std::move(out));
}

// call NAME(argument, ...): the steps of the subprogram, after its parameters were given their values.
void BodyReader::call() {
  const text::Span at = cursor_.peek().span;
  const Subprogram* sub = family_.find_subprogram(cursor_.word());
  if (sub == nullptr) {
    std::vector<std::string_view> names;
    names.reserve(family_.subprograms.size());
    for (const Subprogram& one : family_.subprograms) names.emplace_back(one.name);
    return cursor_.expected_one_of("the name of a subprogram that stands above", names);
  }
  cursor_.advance();
  const std::vector<FunctionParameter>& parameters = sub->parameters;
  if (!parameters.empty()) cursor_.expect_symbol("(");
  for (std::size_t i = 0; i < parameters.size() && !cursor_.line_failed(); ++i) {
    if (i > 0 && !cursor_.expect_symbol(",")) return;
    Step argument = step(StepKind::let);
    argument.target = parameters[i].symbol;
    argument.values[0] = expressions_.value_of(parameters[i].dimension).id;
    add(std::move(argument));
  }
  if (!parameters.empty()) cursor_.expect_symbol(")");
  if (cursor_.line_failed()) return;
  if (!std::ranges::all_of(sub->steps, [this](const Step& one) { return may_stand_here(one.kind); })) return;
  if (sub->needs_feed && !may_cut()) return;
  if (steps_.size() + sub->steps.size() > kMostSteps)
    return cursor_.syntax(at, fmt::format("with all its calls the program has more than {} steps", kMostSteps));
  for (Step copy : sub->steps) {
    if (face_ && !on_face_) enter_face(copy);
    if (copy.kind == StepKind::tool) tool_changes(ir::ExpressionId::none);
    if (copy.kind == StepKind::compensate) compensated_ = copy.number != 0;
    if (copy.kind == StepKind::plane) other_plane_ = copy.number != 0;
    // These moves make the nominal; others of the subprogram do not, nor do those that may be skipped.
    if (open_profiles_ > 0 && copy.skip_level == 0) copy.line = line_;
    steps_.push_back(std::move(copy));
  }
  has_feed_ = has_feed_ || sub->sets_feed;
}

}  // namespace dripfeed::family

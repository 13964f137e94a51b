// Verbs of mills that stand for many moves: faces and pockets. Each is a subprogram of the verbs' library, with what
// its values must fulfil.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "dialects/family/body_reader.h"

namespace dripfeed::family {

using ir::ExpressionId;

// A tool that is called here. What stands above it in a loop is cut with it, too, but the first time.
void BodyReader::tool_changes(ExpressionId diameter) {
  for (Open& open : open_) {
    const bool repeats =
        open.kind == StepKind::for_begin || open.kind == StepKind::for_in_begin || open.kind == StepKind::while_begin;
    if (repeats && open.takes_diameter)
      return cursor_.syntax(verb_,
                            "a verb above it in this loop takes the diameter of the tool before: call that tool "
                            "in the loop, too");
    open.changes_tool = true;
  }
  tool_diameter_ = diameter;
}

// What holds for all of them.
bool BodyReader::may_mill(std::string_view verb) {
  if (family_.machine == ir::MachineKind::lathe)
    cursor_.syntax(verb_, fmt::format("'{}' mills along x and y, and a lathe has no y", verb));
  else if (tool_diameter_ == ExpressionId::none)
    cursor_.syntax(verb_, fmt::format("'{}' takes the diameter of its tool: 'tool NUMBER diameter LENGTH' stands above "
                                      "it, on every path",
                                      verb));
  else if (compensation_waits_ || compensated_)
    cursor_.syntax(verb_,
                   fmt::format("'{}' allows for the cutter itself: compensate off, and a move, before it", verb));
  else if (other_plane_)
    cursor_.syntax(verb_, fmt::format("'{}' mills in the plane of x and y: plane xy before it", verb));
  else if (open_profiles_ > 0)
    cursor_.syntax(verb_, fmt::format("'{}' roughs, too: a profile has only moves that make the nominal", verb));
  if (cursor_.line_failed()) return false;
  for (Open& open : open_)
    if (!open.changes_tool) open.takes_diameter = true;
  return may_cut();
}

// The word and its value.
bool BodyReader::clause(LibraryVerb& verb, std::string_view word, Dimension dimension) {
  if (cursor_.line_failed() || !cursor_.expect_word(word)) return false;
  verb.arguments.push_back(expressions_.value_of(dimension).id);
  return !cursor_.line_failed();
}

bool BodyReader::next_clause(LibraryVerb& verb, std::string_view word) {
  return !cursor_.line_failed() && cursor_.at_word(word) && clause(verb, word);
}

// [feed VALUE]
void BodyReader::entry_feed(LibraryVerb& verb) {
  verb.feeds = VerbFeeds{.entry = ExpressionId::none, .dimension = feed_dimension_};
  if (!cursor_.line_failed() && cursor_.accept_word("feed"))
    verb.feeds->entry = expressions_.value_of(feed_dimension_).id;
}

// The conditions are of what is written; the steps have names where a value would be computed again and again.
void BodyReader::write(std::string_view subprogram, const LibraryVerb& verb, std::span<const VerbRule> rules) {
  if (cursor_.line_failed()) return;
  Step head = step(StepKind::require);
  head.span = {verb_.begin, cursor_.last_span().end};
  VerbCopy copy(family_, scope_, head);
  if (verb.swaps_axes) copy.swap_axes();
  for (const VerbRule& rule : rules) {
    std::vector<ExpressionId> arguments;
    arguments.reserve(rule.arguments.size());
    for (const std::size_t i : rule.arguments) arguments.push_back(verb.arguments[i]);
    Step condition = head;
    condition.values[0] = copy.value(rule.function, arguments);
    condition.text = rule.text;
    condition.begins_pocket = verb.is_pocket && &rule == rules.data();
    add(std::move(condition));
  }
  scope_.open();
  LibraryVerb simple = verb;
  const Subprogram& library = *verb_library().find_subprogram(subprogram);
  const auto keep = [&](ExpressionId& value, std::size_t parameter) {
    if (copy.is_simple(value)) return;
    const ir::Program& names = verb_library().arena;
    const ir::SymbolId symbol = library.parameters[parameter].symbol;
    value = kept(names.strings.at(names.at(symbol).name), value, library.parameters[parameter].dimension);
  };
  for (std::size_t i = 0; i < simple.arguments.size(); ++i) keep(simple.arguments[i], i);
  if (simple.feeds && simple.feeds->entry != ExpressionId::none) keep(simple.feeds->entry, simple.arguments.size());
  for (Step& one : copy.steps(subprogram, simple.arguments, simple.feeds)) steps_.push_back(std::move(one));
  scope_.close();
}

// face x X to X y Y to Y z Z to Z depth LENGTH stepover LENGTH beyond LENGTH return Z; the passes are along the axis
// that is named first.
void BodyReader::face() {
  static const auto kRules = std::to_array<VerbRule>({
      {"is_in_order", {0, 1}, "'face' leads from the smaller place along its passes to the greater one"},
      {"is_in_order", {2, 3}, "'face' leads from the smaller place across its passes to the greater one"},
      {"face_leads_down", {4, 5}, "'face' leads down, from the stock's top to the finished one"},
      {"is_positive", {6}, "the depth of cut of 'face' is above 0"},
      {"is_positive", {7}, "the stepover of 'face' is above 0"},
      {"face_overlaps", {7, 10}, "the stepover of 'face' is at most 0.95 of the cutter's diameter"},
      {"is_positive", {8}, "'face' leaves the part at both ends: beyond is above 0"},
      {"is_above", {9, 4}, "'face' returns to above the stock"},
  });
  if (!may_mill("face")) return;
  LibraryVerb verb{.arguments = {}};
  verb.swaps_axes = cursor_.at_word("y");
  const std::string_view along = verb.swaps_axes ? "y" : "x";
  for (const std::string_view axis : {along, std::string_view(verb.swaps_axes ? "x" : "y"), std::string_view("z")}) {
    clause(verb, axis);
    clause(verb, "to");
  }
  for (const std::string_view word : {"depth", "stepover", "beyond", "return"}) clause(verb, word);
  verb.arguments.push_back(tool_diameter_);
  const bool is_turned = std::ranges::any_of(
      open_, [](const auto& block) { return block.copies && block.copies->cosine != ExpressionId::none; });
  write(is_turned ? "face_turned" : "face", verb, kRules);
}

// pocket x X y Y (diameter LENGTH | length LENGTH width LENGTH corner LENGTH) z Z to Z depth LENGTH stepover LENGTH
// finish LENGTH (helix | ramp) ANGLE [feed VALUE] return Z
void BodyReader::pocket() {
  if (!may_mill("pocket")) return;
  LibraryVerb verb{.arguments = {}, .is_pocket = true};
  clause(verb, "x");
  clause(verb, "y");
  const bool is_round = next_clause(verb, "diameter");
  if (!is_round) {
    clause(verb, "length");
    clause(verb, "width");
    clause(verb, "corner");
  }
  const std::size_t n = verb.arguments.size();  // top, bottom, depth, stepover, finish, angle, clear, cutter
  clause(verb, "z");
  for (const std::string_view word : {"to", "depth", "stepover", "finish"}) clause(verb, word);
  const bool is_ramp = !is_round && !cursor_.line_failed() && cursor_.at_word("ramp");
  if (!is_ramp && !cursor_.line_failed() && !cursor_.at_word("helix"))
    cursor_.expected(is_round ? "helix" : "helix or ramp");
  clause(verb, is_ramp ? "ramp" : "helix", kAngle);
  entry_feed(verb);
  clause(verb, "return");
  verb.arguments.push_back(tool_diameter_);
  if (cursor_.line_failed()) return;
  std::vector<VerbRule> rules = {
      {"face_leads_down", {n, n + 1}, "'pocket' leads down, from the part's top to its floor"},
      {"is_positive", {n + 2}, "the depth of cut of 'pocket' is above 0"},
      {"is_positive", {n + 3}, "the stepover of 'pocket' is above 0"},
      {is_round ? "rings_overlap" : "pocket_overlaps",
       {n + 3, n + 7},
       is_round ? "the stepover of a round 'pocket' is at most 0.95 of the cutter's diameter"
                : "the stepover of 'pocket' is at most 0.85 of the cutter's diameter"},
      {"is_positive", {n + 4}, "'finish', what 'pocket' leaves on the wall for its last pass, is above 0"},
      {"entry_descends", {n + 5}, "the angle of the entry into 'pocket' is above 0 and at most 45 degrees"},
      {"is_above_gap", {n + 6, n}, "'pocket' returns to 0.5 mm above its top or higher"},
  };
  const std::size_t second = is_round ? 2 : 3;
  rules.push_back({"pass_fits", {2, second, n + 7, n + 4}, "the cutter is too wide for the pocket and its last pass"});
  if (!is_round) {
    rules.push_back({"corner_takes", {4, n + 7}, "the cutter does not fit into the corners of 'pocket'"});
    rules.push_back({"corners_fit", {2, 3, 4}, "the corners of 'pocket' run into each other"});
  }
  if (is_ramp)
    rules.push_back({"ramp_fits",
                     {2, 3, n + 7},
                     "'pocket' is too short for a ramp: its length and width differ by the "
                     "cutter's diameter at least"});
  else
    rules.push_back({"helix_fits", {2, second, n + 7, n + 4}, "'pocket' is too narrow for a helix"});
  write(is_round ? "pocket_round" : is_ramp ? "pocket_by_ramp" : "pocket_by_helix", verb, rules);
}

}  // namespace dripfeed::family

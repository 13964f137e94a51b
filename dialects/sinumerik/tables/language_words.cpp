// What a word is for stands with its role or, of a statement, with its verb; of a function it is the operator's.
#include "dialects/sinumerik/tables/language_words.h"

#include "dialects/sinumerik/tables/called_cycles.h"
#include "dialects/sinumerik/tables/keywords.h"

namespace dripfeed::sinumerik {

namespace {

struct VerbText {
  Verb verb;
  std::string_view about;
};
constexpr VerbText kVerbs[] = {
    {Verb::if_word, "condition of a jump or of the blocks up to ENDIF"},
    {Verb::else_word, "blocks where the condition does not hold"},
    {Verb::end_if, "end of a condition"},
    {Verb::while_word, "loop as long as the condition holds"},
    {Verb::end_while, "end of a loop"},
    {Verb::for_word, "loop that counts"},
    {Verb::end_for, "end of a loop"},
    {Verb::loop, "loop without end"},
    {Verb::end_loop, "end of a loop"},
    {Verb::repeat, "loop up to UNTIL, or a part of the program once more"},
    {Verb::repeat_block, "a block once more"},
    {Verb::until, "end of a loop: it ends where the condition holds"},
    {Verb::case_word, "jump by a value"},
    {Verb::go_to, "jump: looks forward, then from the start"},
    {Verb::go_to_forward, "jump forward"},
    {Verb::go_to_backward, "jump backward"},
    {Verb::go_to_tolerant, "jump; no alarm where the label is missing"},
    {Verb::go_to_start, "jump to the start of the program"},
    {Verb::define, "declares variables"},
    {Verb::procedure, "head of a subprogram with its parameters"},
    {Verb::declare, "declares a subprogram of another file"},
    {Verb::message, "message to the operator"},
    {Verb::alarm, "sets an alarm"},
    {Verb::call, "calls a program or a part of one"},
    {Verb::call_path, "calls a program by its path"},
    {Verb::call_external, "calls a program of another device"},
    {Verb::call_iso, "calls a program in ISO mode"},
    {Verb::execute, "executes a text as a block"},
    {Verb::macro, "declares a macro"},
    {Verb::call_modal, "calls a program after each block that moves"},
    {Verb::return_word, "return to the calling program"},
};

std::string_view about_verb(Verb verb) {
  for (const VerbText& row : kVerbs)
    if (row.verb == verb) return row.about;
  return {};
}

// Of a word that is kept as it is.
std::string_view about_effect(Effect effect) {
  switch (effect) {
    case Effect::unknown: return "of the control; a check does not know what it changes";
    case Effect::none: return "of the control; neither moves nor changes what is checked";
    case Effect::moves: return "of the control; axes may be anywhere afterwards";
    case Effect::shifts: return "of the control; changes where coordinates lie";
    case Effect::smooths: return "of the control; tolerance and smoothing of the path";
    case Effect::paces: return "of the control; along which axes feeds count";
  }
  return {};
}

// Of a statement that is kept as it is.
ir::WordState state_of(Effect effect) {
  const bool leaves_paths = effect == Effect::none || effect == Effect::paces || effect == Effect::smooths;
  return leaves_paths ? ir::WordState::without_effect : ir::WordState::reported;
}

ir::LanguageWord word_of(const Keyword& keyword) {
  using ir::WordSort;
  switch (keyword.role) {
    case Role::infix:
    case Role::prefix: return {keyword.name, WordSort::keyword, ir::about_operator(keyword.op)};
    case Role::function: return {keyword.name, WordSort::function, ir::about_operator(keyword.op)};
    case Role::foreign:
      return {keyword.name, WordSort::function, "known to the control; its value is the control's",
              ir::WordState::reported};
    case Role::constant: return {keyword.name, WordSort::keyword, "a constant"};
    case Role::word_mode: return {keyword.name, WordSort::function, "how the value of this word is meant"};
    case Role::address: return {keyword.name, WordSort::keyword, "a word that takes a value"};
    case Role::statement: return {keyword.name, WordSort::keyword, about_verb(keyword.verb)};
    case Role::procedure:
      return {keyword.name, WordSort::keyword, about_effect(keyword.effect), state_of(keyword.effect)};
    case Role::cycle: return {keyword.name, WordSort::cycle, "standard cycle of the control", state_of(keyword.effect)};
    case Role::type: return {keyword.name, WordSort::keyword, "type of a variable"};
    case Role::attribute: return {keyword.name, WordSort::keyword, "part of a declaration"};
  }
  return {};
}

}  // namespace

std::vector<ir::LanguageWord> language_words() {
  std::vector<ir::LanguageWord> words;
  // Before the keywords: of CYCLE802 some calls are kept as they are.
  for (const ir::CalledCycle& cycle : called_cycles())
    words.push_back({cycle.name, ir::WordSort::cycle, "standard cycle of the control; a check runs it"});
  for (const Keyword& keyword : keywords()) words.push_back(word_of(keyword));
  return words;
}

}  // namespace dripfeed::sinumerik

// Spellings of one state in the order of the tables, a range of numbered variables as one.
#include "server/cli/words.h"

#include <array>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::cli {

namespace {

constexpr std::string_view kHead = R"(# Words of the languages

Every word that the built-in dialects know for their usual controls, by what a check makes of it. The list is written by
`dripfeed words --markdown`; `dripfeed words --dialect fanuc --kind lathe` shows one control with a line a word.

- **Interpreted**: its effect is followed exactly, in checks, in runs and in translation. Where one case of a word is
  not followed, the report names that case.
- **Without effect**: it neither moves nor changes what is checked.
- **Reported**: the control knows it, and what it does depends on the machine or is not followed. The report names it, and
  the verdict is `unknown` until a person waives it or the machine's profile states its effect.

A word that stands in no list is named as `unknown-code`, `unknown-address` or `unknown-name`; where an option or a definition file
may bring it, that is a warning, and the verdict is no better than `unknown`.
)";

struct Kind {
  ir::MachineKind kind;
  std::string_view title;
};
constexpr std::array kKinds = {Kind{ir::MachineKind::mill, "mills"}, Kind{ir::MachineKind::lathe, "lathes"},
                               Kind{ir::MachineKind::mill_turn, "mill-turn centers"}};
constexpr std::array kStates = {ir::WordState::interpreted, ir::WordState::without_effect, ir::WordState::reported};
constexpr std::array<std::string_view, 3> kStateTitles = {"Interpreted", "Without effect", "Reported"};

std::string spelling_of(const compile::DialectWord& word) {
  return word.last == 0 ? word.spelling : fmt::format("{} to #{}", word.spelling, word.last);
}

std::string by_state(const std::vector<compile::DialectWord>& words) {
  std::string out;
  for (std::size_t i = 0; i < kStates.size(); ++i) {
    std::vector<std::string> spellings;
    for (const compile::DialectWord& word : words)
      if (word.state == kStates[i]) spellings.push_back(fmt::format("`{}`", spelling_of(word)));
    if (!spellings.empty())
      out += fmt::format("**{}** ({}): {}\n\n", kStateTitles[i], spellings.size(), fmt::join(spellings, ", "));
  }
  return out;
}

}  // namespace

std::string list_of_words(const std::vector<compile::DialectWord>& words) {
  std::string out;
  for (const compile::DialectWord& word : words)
    out += fmt::format("{:<14}  {:<16}  {}\n", ir::name_of(word.state), spelling_of(word), word.about);
  return out;
}

std::string words_in_markdown() {
  std::string out(kHead);
  for (const compile::Dialect& dialect : compile::dialects()) {
    out += fmt::format("\n## {}\n\n", dialect.title);
    std::string before;
    for (const Kind& kind : kKinds) {
      const ir::Control control = dialect.control(kind.kind, ir::GSystem::a);
      std::string section = by_state(compile::language_of(dialect, control));
      if (section == before) continue;  // it has no codes of its own for that kind
      out += fmt::format("### For {}\n\n{}", kind.title, section);
      before = std::move(section);
    }
  }
  while (out.ends_with("\n\n")) out.pop_back();
  return out;
}

}  // namespace dripfeed::cli

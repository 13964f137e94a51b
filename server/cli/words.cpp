// The pages are tables: a row for each meaning of a word, a column for each kind of machine whose words differ.
#include "server/cli/words.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/compile/trial/word_trials.h"

namespace dripfeed::cli {

namespace {

constexpr std::string_view kHead = R"(# Words of the languages

Every word that the built-in dialects know for their usual controls, by what a check makes of it. A page for each dialect has them
with a line a word, what it does and where the control's manual states it. `dripfeed words` lists those of one control in a terminal.

- **interpreted**: its effect is followed exactly, in checks, in runs and in translation. Where one case of a word is
  not followed, the report names that case.
- **without effect**: it neither moves nor changes what is checked.
- **reported**: the control knows it, and what it does depends on the machine or is not followed. The report names it, and
  the verdict is `unknown` until a person waives it or the machine's profile states its effect.

The column *translated to* is found by doing it: small programs with the word, which the control accepts, are translated to the
usual control of each other dialect. It names the dialects for which one of them gives a program; `all` of them; or `none`, where
each was refused with an error. A dash: the control accepts none of these programs. Another use of the word may end differently.

A word that stands on no page is named as `unknown-code`, `unknown-address` or `unknown-name`; where an option or a definition file
may bring it, that is a warning, and the verdict is no better than `unknown`. What is translated between two controls is in
[dialects.md](dialects.md).
)";

struct Kind {
  ir::MachineKind kind;
  ir::GSystem system;
  std::string_view title;
};
constexpr std::array kKinds = {Kind{ir::MachineKind::mill, ir::GSystem::a, "mills"},
                               Kind{ir::MachineKind::lathe, ir::GSystem::a, "lathes"},
                               Kind{ir::MachineKind::lathe, ir::GSystem::b, "lathes, system B"},
                               Kind{ir::MachineKind::lathe, ir::GSystem::c, "lathes, system C"},
                               Kind{ir::MachineKind::mill_turn, ir::GSystem::a, "mill-turn centers"}};
// By ir::WordState.
constexpr std::array<std::string_view, 3> kStateTitles = {"interpreted", "without effect", "reported"};
// By ir::WordSort.
constexpr std::array<std::string_view, 5> kSortTitles = {"Codes", "Keywords", "Functions", "Cycles",
                                                         "System variables"};

std::string_view title_of(ir::WordState state) { return kStateTitles[static_cast<std::size_t>(state)]; }

std::string spelling_of(const compile::DialectWord& word) {
  return word.last == 0 ? word.spelling : fmt::format("{} to #{}", word.spelling, word.last);
}

bool is_same(const compile::DialectWord& a, const compile::DialectWord& b) {
  return a.spelling == b.spelling && a.last == b.last && a.sort == b.sort && a.about == b.about && a.state == b.state;
}

// Kinds of machine with the same words share one.
struct Column {
  std::string title;
  ir::Control control;
  std::vector<compile::DialectWord> words;
};

std::vector<Column> columns_of(const compile::Dialect& dialect) {
  std::vector<Column> columns;
  for (const Kind& kind : kKinds) {
    ir::Control control = dialect.control(kind.kind, kind.system);
    auto words = compile::language_of(dialect, control);
    const auto same =
        std::ranges::find_if(columns, [&](const Column& one) { return std::ranges::equal(one.words, words, is_same); });
    if (same == columns.end())
      columns.push_back({std::string(kind.title), std::move(control), std::move(words)});
    else if (kind.system == ir::GSystem::a)
      same->title += fmt::format(", {}", kind.title);
  }
  return columns;
}

struct Row {
  compile::DialectWord word;
  std::vector<std::string_view> states;  // by column; "" where it is not known with this meaning
  std::size_t first_column = 0;          // that knows it
};

// A word that means something else on another kind of machine has a row for each meaning.
std::vector<Row> rows_of(const std::vector<Column>& columns) {
  std::vector<Row> rows;
  std::map<std::pair<std::string, std::string>, std::size_t> by_meaning;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    for (const compile::DialectWord& word : columns[column].words) {
      const auto [known, is_new] = by_meaning.try_emplace({spelling_of(word), word.about}, rows.size());
      if (is_new) rows.push_back({word, std::vector<std::string_view>(columns.size()), column});
      rows[known->second].states[column] = title_of(word.state);
    }
  }
  std::ranges::stable_sort(rows, {}, [](const Row& row) { return row.word.sort; });
  return rows;
}

std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '|' ? "\\|" : std::string(1, c);
  return out;
}

std::string head_of_table(const std::vector<Column>& columns) {
  std::string names = "| word | does |";
  std::string lines = "|---|---|";
  for (const Column& column : columns) {
    names += fmt::format(" {} |", column.title);
    lines += "---|";
  }
  return fmt::format("{} translated to | manual |\n{}---|---|\n", names, lines);
}

// What becomes of the word on the first kind of machine that knows it.
std::string translated_to(const Row& row, const Column& column, const compile::WordTrials& trials) {
  std::vector<std::string_view> taking;
  std::size_t targets = 0;
  for (const compile::Dialect& other : compile::dialects()) {
    if (other.name == column.control.dialect) continue;
    const auto result = trials.of(row.word, other.control(column.control.kind, column.control.g_system));
    if (result == compile::TrialResult::not_tried) return "–";
    ++targets;
    if (result == compile::TrialResult::translated) taking.push_back(other.name);
  }
  if (taking.empty()) return "none";
  return taking.size() == targets ? "all" : fmt::format("{}", fmt::join(taking, ", "));
}

std::string line_of(const Row& row, std::string_view translated) {
  std::string line = fmt::format("| `{}` | {} |", cell(spelling_of(row.word)), cell(row.word.about));
  for (const std::string_view state : row.states) line += fmt::format(" {} |", state.empty() ? "–" : state);
  return fmt::format("{} {} | {} |\n", line, translated, row.word.reference.empty() ? "–" : cell(row.word.reference));
}

std::size_t count_of(const Column& column, ir::WordState state) {
  return static_cast<std::size_t>(std::ranges::count(column.words, state, &compile::DialectWord::state));
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
  out += "\n| dialect | for | interpreted | without effect | reported |\n|---|---|---|---|---|\n";
  for (const compile::Dialect& dialect : compile::dialects())
    for (const Column& column : columns_of(dialect))
      out += fmt::format("| [{}](words-{}.md) | {} | {} | {} | {} |\n", dialect.title, dialect.name, column.title,
                         count_of(column, ir::WordState::interpreted), count_of(column, ir::WordState::without_effect),
                         count_of(column, ir::WordState::reported));
  return out;
}

std::string words_in_markdown(const compile::Dialect& dialect) {
  const std::vector<Column> columns = columns_of(dialect);
  std::string out = fmt::format(
      "# Words: {0}\n\n`dripfeed words --markdown --dialect {1}` writes this page from the tables of the binary. What "
      "the "
      "columns state is in\n[words.md](words.md). A dash: the control does not know the word, or not with this "
      "meaning; "
      "the last column: no manual is cited.\n",
      dialect.title, dialect.name);
  const std::vector<Row> rows = rows_of(columns);
  std::vector<compile::WordTrials> trials;
  for (const Column& column : columns) trials.emplace_back(dialect, column.control);
  for (std::size_t sort = 0; sort < kSortTitles.size(); ++sort) {
    std::string table;
    for (const Row& row : rows)
      if (static_cast<std::size_t>(row.word.sort) == sort)
        table += line_of(row, translated_to(row, columns[row.first_column], trials[row.first_column]));
    if (!table.empty()) out += fmt::format("\n## {}\n\n{}{}", kSortTitles[sort], head_of_table(columns), table);
  }
  return out;
}

}  // namespace dripfeed::cli

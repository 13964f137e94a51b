// Joins the control's tables of codes and variables with the words of the dialect.
#include "dialects/compile/dialect/language.h"

#include <set>
#include <utility>

#include <fmt/format.h>

namespace dripfeed::compile {

namespace {

class Language {
 public:
  void add(DialectWord word) {
    if (!word.spelling.empty() && known_.insert(word.spelling).second) words_.push_back(std::move(word));
  }

  void add_codes(std::span<const ir::CodeRow> rows) {
    for (const ir::CodeRow& row : rows) {
      if (row.function == ir::Function::none) continue;
      add({.spelling = std::string(row.name),
           .about = ir::about_code(row),
           .reference = row.reference,
           .state = ir::state_of(row)});
    }
  }

  void add_words(const std::vector<ir::LanguageWord>& words) {
    for (const ir::LanguageWord& word : words)
      add({.spelling = std::string(word.spelling),
           .sort = word.sort,
           .about = std::string(word.about),
           .state = word.state});
  }

  void add_variables(std::span<const ir::SystemVariableRow> rows) {
    for (const ir::SystemVariableRow& row : rows) {
      if (row.name == "$") continue;  // all others
      const bool is_numbered = row.name.empty();
      add({.spelling = is_numbered ? fmt::format("#{}", row.first) : std::string(row.name),
           .sort = ir::WordSort::variable,
           .about = row.writable ? "system variable" : "system variable, to read only",
           .reference = row.reference,
           .last = is_numbered && row.last > row.first ? row.last : 0,
           .state = row.kind == ir::SystemValue::not_modelled ? ir::WordState::reported : ir::WordState::interpreted});
    }
  }

  std::vector<DialectWord> finish() && { return std::move(words_); }

 private:
  std::set<std::string> known_;
  std::vector<DialectWord> words_;
};

}  // namespace

std::vector<DialectWord> language_of(const Dialect& dialect, const ir::Control& control) {
  Language language;
  language.add_codes(control.g_codes);
  language.add_codes(control.m_codes);
  language.add_words(dialect.words());
  language.add_variables(control.system_variables);
  return std::move(language).finish();
}

}  // namespace dripfeed::compile

// Whether a word of a control's language is carried to another control, found by translating a small program with it.
// The program around the word is rendered from a family; the words in its block are tried by shape, the same shapes for
// every word, until the control itself accepts the program.
#pragma once

#include <string>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/language.h"
#include "dialects/ir/control.h"

namespace dripfeed::compile {

enum class TrialResult : std::uint8_t {
  not_tried,   // no shape makes a program that the control accepts
  translated,  // a program with the word was translated without an error
  refused,     // the control accepts programs with the word, and each translation of them is an error
};

class WordTrials {
 public:
  // `control` is of `from`. The dialects must outlive it.
  WordTrials(const Dialect& from, ir::Control control);

  // At most kPrograms programs are translated. `to` is a control of another dialect.
  [[nodiscard]] TrialResult of(const DialectWord& word, const ir::Control& to) const;
  // The programs that `of` translates: those with the word that the control accepts, the shortest shape first.
  [[nodiscard]] std::vector<std::string> programs(const DialectWord& word) const;

  static constexpr std::size_t kPrograms = 12;

 private:
  [[nodiscard]] bool is_accepted(const std::string& text) const;

  const Dialect& from_;
  ir::Control control_;
  std::string head_;  // the program around the word
  std::string tail_;
};

}  // namespace dripfeed::compile

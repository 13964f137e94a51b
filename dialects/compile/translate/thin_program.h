// A long program read without its stretches of plain moves: only the lines around them become statements, and a run
// scans the stretches from the text. What the reader, the validator and the passes make of the lines around a stretch
// they would make of those in it, too: it consists of moves alone that look like them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/control.h"
#include "dialects/ir/plain_stretch.h"
#include "dialects/ir/stage.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

// The parts of a line of plain moves, such as N12 G1 X1. Y-2.5 F300; without letters for any other line.
struct MoveForm {
  std::string_view number;  // digits of N; may be empty
  std::string_view code;    // "G01" as written; may be empty
  std::string letters;      // of the words, in order; a feed without a decimal point is f
  std::string_view words;   // with their values, as written
  std::string_view feed;    // the value of F; may be empty

  [[nodiscard]] bool is_move() const { return !letters.empty(); }
  [[nodiscard]] bool is_arc() const { return !code.empty() && (code.back() == '2' || code.back() == '3'); }
};
MoveForm move_form_of(std::string_view line);
// The same for all lines with the same words, numbered or not, with the same code or none.
std::string look_of(const MoveForm& form);

struct ThinOptions {
  std::uint64_t least_bytes = std::uint64_t{1} << 20U;  // of a text that is worth it
  std::uint32_t least_lines = 256;                      // of a stretch
  bool straight_alone = false;                          // lines with an arc or a feed are in none
};

class ThinProgram {
 public:
  static constexpr std::uint32_t kKeptBefore = 8;  // lines of a stretch that are read
  static constexpr std::uint32_t kKeptAfter = 2;

  // nullptr where nothing is gained, or where something in the program might depend on the difference: jumps, contours
  // by their labels, calls after each block.
  static std::unique_ptr<ThinProgram> read(const text::Source& whole, const Dialect& dialect,
                                           const ir::Control& control, const ThinOptions& options = {});

  // Of a text whose stretches are known. nullptr: a line of them is not plain.
  static std::unique_ptr<ThinProgram> join(const text::Source& thin, std::string_view whole,
                                           const std::vector<ir::PlainStretch>& stretches, const Dialect& dialect,
                                           const ir::Control& control);

  // Statements have their lines in the whole text, spans are in program.source.
  ir::ReadResult read_result;
  ir::PlainStretches stretches;  // for RunOptions::stretches

  // Of the thin text: the first line after a stretch, by its number.
  [[nodiscard]] std::uint32_t line_after(std::size_t stretch) const { return cuts_[stretch].line; }
  [[nodiscard]] std::uint32_t line_in_full_text(std::uint32_t thin_line) const;

  // Puts what was found in the program to its place in the whole text.
  void place(std::vector<text::Diagnostic>& diagnostics) const;
  void place(interpreter::RunResult& run) const;

 private:
  // What comes after a stretch in the thin text, and how much is removed by this cut and all before it.
  struct Cut {
    std::uint32_t at = 0;
    std::uint32_t line = 0;
    std::uint32_t removed_bytes = 0;
    std::uint32_t removed_lines = 0;
  };
  ThinProgram(std::string_view whole, const Dialect& dialect, const ir::Control& control);
  static std::unique_ptr<ThinProgram> read_without(const text::Source& whole, const Dialect& dialect,
                                                   const ir::Control& control, const ThinOptions& options);
  bool take(const text::Source& thin, const std::vector<ir::PlainStretch>& found, const Dialect& dialect,
            const ir::Control& control);
  [[nodiscard]] text::Span in_whole(text::Span span) const;
  void place(text::Diagnostic& diagnostic) const;

  text::Source whole_;
  std::vector<Cut> cuts_;
};

}  // namespace dripfeed::compile

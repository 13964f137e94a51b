// Blocks of plain positions, one after the other, go as text to a sink while the program runs: no program holds them.
// What raising and printing make of such a block is known from the control alone, and it is proved: the first block of
// each kind in a run, and then one of many, is written into the program as well, and its line must be the same.
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/stage.h"

namespace dripfeed::compile {

// Takes text piece by piece.
class TextSink {
 public:
  TextSink() = default;
  TextSink(const TextSink&) = delete;
  TextSink& operator=(const TextSink&) = delete;
  virtual ~TextSink() = default;
  virtual void write(std::string_view text) = 0;
};

// What comes into a text before its byte `at`: bytes of the sink.
struct Splice {
  std::uint64_t at = 0;
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

class PositionRuns {
 public:
  // Printed for `target`, which `dialect` writes for. All of them must outlive this.
  PositionRuns(const Dialect& dialect, const ir::Control& target, TextSink& sink)
      : dialect_(dialect), target_(target), sink_(sink) {}
  PositionRuns(const PositionRuns&) = delete;
  PositionRuns& operator=(const PositionRuns&) = delete;
  ~PositionRuns() = default;

  // The control that the blocks are written for: whether X of it is what the target's X is.
  [[nodiscard]] bool serves(const ir::Control& written_for) const;
  // Writes a block of the move's positions. False: its kind is new or its turn has come, and it has to be a block of
  // the program, which `sample` then is given.
  bool add(const ir::Motion& move);
  void sample(const ir::Motion& move, std::uint32_t block);
  // Another block comes.
  void end();
  // Nothing comes after this.
  void finish();

  // Where they belong in the program's text. Nothing where a sample is not printed as it was written here: then all
  // that was written is of no use.
  [[nodiscard]] std::optional<std::vector<Splice>> splices(const ir::PrintResult& printed) const;
  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }
  [[nodiscard]] std::uint64_t bytes() const { return written_ + text_.size(); }

 private:
  struct Run {
    std::uint32_t block = 0;  // the sample before it: Statement::line
    std::string line;         // and its text
    std::uint64_t begin = 0;  // bytes of the sink
    std::uint64_t end = 0;
  };

  void append(const ir::Motion& move, std::uint16_t axes);
  void drop_empty();

  const Dialect& dialect_;
  const ir::Control& target_;
  TextSink& sink_;
  std::bitset<1U << ir::kAxisCount> known_;  // kinds of the run at hand, by the axes that they name
  std::uint32_t since_sample_ = 0;
  std::string text_;  // not yet in the sink
  std::uint64_t written_ = 0;
  std::uint64_t blocks_ = 0;
  std::vector<Run> runs_;
};

}  // namespace dripfeed::compile

// What lines of a run's programs have. It is asked once a block that is executed.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace dripfeed::compile {

// Of one program. Line numbers may be far apart.
template <class Row>
class ByLine {
 public:
  // The row of a line, made where there is none. References stay valid as long as this.
  Row& row(std::uint32_t line) {
    may_have_.set(line % kMarks);
    return rows_[line];
  }
  // nullptr: nothing.
  [[nodiscard]] Row* at(std::uint32_t line) {
    if (!may_have_.test(line % kMarks)) return nullptr;
    const auto found = rows_.find(line);
    return found == rows_.end() ? nullptr : &found->second;
  }

 private:
  static constexpr std::size_t kMarks = 4096;
  std::bitset<kMarks> may_have_;  // most lines have nothing, and no search is needed for them
  std::map<std::uint32_t, Row> rows_;
};

// Of all programs of a run, by their number.
template <class Row>
class ByProgram {
 public:
  // nullptr: not looked at yet.
  [[nodiscard]] ByLine<Row>* of(std::uint32_t program) const {
    return program < programs_.size() ? programs_[program].get() : nullptr;
  }
  ByLine<Row>& add(std::uint32_t program, ByLine<Row> lines) {
    if (program >= programs_.size()) programs_.resize(std::size_t{program} + 1);
    programs_[program] = std::make_unique<ByLine<Row>>(std::move(lines));
    return *programs_[program];
  }

 private:
  std::vector<std::unique_ptr<ByLine<Row>>> programs_;
};

}  // namespace dripfeed::compile

// What the scanners of all dialects share: the loop over blocks, what becomes of a block that turns out not to be
// plain, lines and places. The words of a block are the dialect's.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "dialects/ir/plain_batch.h"
#include "dialects/text/source.h"

namespace dripfeed::ir {

// The block that is being scanned. A pointer into the text that is nullptr says "not plain".
struct ScannedBlock {
  PlainBatch* batch = nullptr;
  const char* text_end = nullptr;
  const char* first = nullptr;  // of its words, block number and program number left out; nullptr: none yet
  const char* last = nullptr;   // after its last word
  bool ends_program = false;

  void take(const char* begin, const char* end) {
    if (first == nullptr) first = begin;
    last = end;
  }
  void add_word(Address address, double value, bool has_point) { batch->words.push_back({value, address, has_point}); }
  void add_code(Function function, std::int16_t argument, ModalGroup group) {
    batch->codes.push_back({function, argument, group});
  }
  void report(std::string_view name, Function function, std::int16_t argument = 0) {
    batch->reports.push_back({static_cast<std::uint32_t>(batch->blocks.size()), name, function, argument});
  }
};

// Rows of a code table by ten times their number; those that are not plain are left out.
class PlainCodeIndex {
 public:
  void add(const CodeRow& row) {
    if (row.number10 < 0) return;
    const auto at = static_cast<std::size_t>(row.number10);
    rows_.resize(std::max(rows_.size(), at + 1));
    rows_[at] = &row;
  }
  // nullptr: there is none that is plain.
  [[nodiscard]] const CodeRow* find(std::uint64_t number10) const {
    return number10 < rows_.size() ? rows_[number10] : nullptr;
  }

 private:
  std::vector<const CodeRow*> rows_;
};

// Whether what the function does depends on nothing but the constants of its block and the modal state.
bool is_plain(Function function);
constexpr bool ends_program(Function function) {
  return function == Function::program_end || function == Function::program_end_rewind;
}

// `Words` has: const char* scan(const char* at, ScannedBlock&), which takes the words of a block up to its EOB (a byte
// for which ends_block is true) or gives nullptr; static bool ends_line(char), of an EOB; std::string_view name().
template <class Words>
class BlockScanner final : public PlainScanner {
 public:
  explicit BlockScanner(Words words) : words_(std::move(words)) {}

  PlainScan scan(std::string_view text, PlainBatch& batch) override {
    const char* const begin = text.data();
    const char* const end = begin + text.size();
    const char* at = begin;
    PlainStop stop = PlainStop::text_used;
    while (at < end && stop == PlainStop::text_used) {
      const char* const next = block(at, begin, end, batch);
      if (next == nullptr) {
        stop = PlainStop::not_plain;
        break;
      }
      at = next;
      if (!batch.blocks.empty() && batch.blocks.back().ends_program)
        stop = PlainStop::program_end;
      else if (batch.blocks.size() == PlainBatch::kMostBlocks)
        stop = PlainStop::batch_full;
    }
    const auto taken = static_cast<std::size_t>(at - begin);
    scanned_ += taken;
    return {taken, stop};
  }

  [[nodiscard]] std::string_view name() const override { return words_.name(); }

 private:
  // One block and its EOB; gives the byte after it.
  const char* block(const char* at, const char* begin, const char* end, PlainBatch& batch) {
    const std::size_t words = batch.words.size();
    const std::size_t codes = batch.codes.size();
    const std::size_t reports = batch.reports.size();
    ScannedBlock block{.batch = &batch, .text_end = end};
    at = words_.scan(at, block);
    if (at == nullptr) {
      batch.words.resize(words);
      batch.codes.resize(codes);
      batch.reports.resize(reports);
      return nullptr;
    }
    if (block.first != nullptr) {
      batch.blocks.push_back({.offset = scanned_ + static_cast<std::uint64_t>(block.first - begin),
                              .length = static_cast<std::uint32_t>(block.last - block.first),
                              .line = line_,
                              .first_word = static_cast<std::uint32_t>(words),
                              .first_code = static_cast<std::uint32_t>(codes),
                              .word_count = static_cast<std::uint16_t>(batch.words.size() - words),
                              .code_count = static_cast<std::uint16_t>(batch.codes.size() - codes),
                              .ends_program = block.ends_program});
    }
    if (at >= end) return end;
    if (!Words::ends_line(*at)) return at + 1;
    ++line_;
    return at + text::eob_length({at, static_cast<std::size_t>(end - at)}, 0);
  }

  Words words_;
  std::uint64_t scanned_ = 0;  // bytes of earlier scans
  std::uint32_t line_ = 1;
};

}  // namespace dripfeed::ir

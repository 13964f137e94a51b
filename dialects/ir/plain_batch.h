// Plain blocks in batches: words and codes with nothing left to compute, as a text is scanned, without tokens or
// statements of it. Flat arrays that are filled and emptied over and over; a program of any length passes through one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "dialects/ir/function.h"
#include "dialects/ir/statement.h"

namespace dripfeed::ir {

struct PlainCode {
  Function function = Function::none;
  std::int16_t argument = 0;
  ModalGroup group = ModalGroup::none;
};

struct PlainWord {
  double value = 0.0;
  Address address = Address::other;
  bool has_point = true;
};

// A code that a run has to name: it is known and has no effect here.
struct PlainReport {
  std::uint32_t block = 0;  // index in the batch
  std::string_view name;    // of a static table
  Function function = Function::no_effect;
  std::int16_t argument = 0;  // number of a machine function
};

struct PlainBlockRow {
  std::uint64_t offset = 0;  // of the block's first word in the text
  std::uint32_t length = 0;  // bytes up to the end of its last word
  std::uint32_t line = 0;    // 1-based
  std::uint32_t first_word = 0;
  std::uint32_t first_code = 0;
  std::uint16_t word_count = 0;
  std::uint16_t code_count = 0;
  bool ends_program = false;  // M30 or M02 stands in it; it is not among the codes
};

struct PlainBatch {
  static constexpr std::size_t kMostBlocks = 4096;
  std::vector<PlainBlockRow> blocks;
  std::vector<PlainWord> words;
  std::vector<PlainCode> codes;
  std::vector<PlainReport> reports;  // in the order of the blocks

  void clear() {
    blocks.clear();
    words.clear();
    codes.clear();
    reports.clear();
  }
};

// Why a scan stopped. `not_plain`: the block at which it stopped needs the dialect's reader.
enum class PlainStop : std::uint8_t { text_used, batch_full, program_end, not_plain };

struct PlainScan {
  std::size_t taken = 0;  // bytes of whole blocks
  PlainStop stop = PlainStop::text_used;
};

// Reads plain blocks as the dialect's reader does, and nothing else: what could be a fault, a label that is jumped to,
// a comment with a meaning or anything to compute is not plain. Knows its place in the text from call to call.
class PlainScanner {
 public:
  PlainScanner() = default;
  PlainScanner(const PlainScanner&) = delete;
  PlainScanner& operator=(const PlainScanner&) = delete;
  virtual ~PlainScanner() = default;
  // Adds blocks from the front of `text`, which ends after an EOB or with the program; the byte after it can be read
  // and is an EOB. Not to be called again after program_end or not_plain.
  virtual PlainScan scan(std::string_view text, PlainBatch& batch) = 0;
  // Of the program, as far as its head was scanned; "" when it has none.
  [[nodiscard]] virtual std::string_view name() const = 0;
};

}  // namespace dripfeed::ir

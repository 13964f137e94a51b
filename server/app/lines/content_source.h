// A stored text as a feed's source: read ahead in chunks on one thread, taken on another without waiting, EOBs turned
// to LF in passing.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "protocol/feed/program_check.h"
#include "protocol/tape_code/eob.h"
#include "protocol/tape_code/text_source.h"
#include "server/app/base/error.h"
#include "server/machine/profile.h"
#include "store/contents.h"

namespace dripfeed::app {

// A part of a stored text, in bytes as stored.
struct TextPart {
  std::uint64_t begin = 0;
  std::uint64_t end = UINT64_MAX;
  std::uint64_t line = 1;  // of the stored text, in which it begins
};

class ContentSource final : public tape_code::TextSource {
 public:
  // Four chunks of 64 KiB: 20 s at 115200 baud.
  static constexpr std::size_t kChunks = 4;

  // The text `rounds` times; no piece spans two of them.
  explicit ContentSource(std::shared_ptr<store::ContentReader> text, std::uint32_t rounds = 1, TextPart part = {});
  // Fills the free chunks. From one thread; the text is read here and nowhere else.
  void refill();
  // On the feed's thread.
  tape_code::TextPiece next() noexcept override;

 private:
  void fill_one(std::string& chunk);

  std::shared_ptr<store::ContentReader> text_;
  std::uint32_t rounds_left_;
  TextPart part_;
  std::uint64_t offset_;
  tape_code::EobReader eobs_;
  std::array<std::string, kChunks> chunks_;
  // Written by one side each: `filled_` by refill(), `taken_` and `released_` by next().
  std::atomic<std::uint64_t> filled_{0};
  std::atomic<std::uint64_t> released_{0};
  std::uint64_t taken_ = 0;
  std::atomic<bool> over_{false};
  std::atomic<bool> failed_{false};
};

// What of a stored text goes to this machine: all of it, but for a control that fetches files and whose archives carry
// a head (see machine::file_part).
Result<TextPart> part_for(store::Contents& contents, const std::string& sha256, const machine::Profile& profile);

// Reads that part of the text once and checks that it may be fed to this machine: its frame, and that the control takes
// and the line's code has every character. The facts are of the text with LF as EOB; a refusal names line and column.
Result<feed::ProgramFacts> check_program(std::shared_ptr<store::ContentReader> text, const TextPart& part,
                                         const machine::Profile& profile, ir::Delivery delivery);
Result<feed::ProgramFacts> check_program(store::Contents& contents, const std::string& sha256,
                                         const machine::Profile& profile, ir::Delivery delivery);

}  // namespace dripfeed::app

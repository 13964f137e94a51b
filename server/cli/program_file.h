// A program's file that is read in pieces. Small files are read whole before anything runs, so that all of their faults
// are seen at once; of large ones the head decides the control.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "dialects/compile/dialect/stream.h"
#include "dialects/text/source.h"
#include "server/app/base/error.h"

namespace dripfeed::cli {

// Files of more bytes are run while they are read.
inline constexpr std::size_t kWholeBytes = std::size_t{256} * 1024;

class ProgramFile final : public compile::ProgramText {
 public:
  // Errors: unavailable, with what the system said.
  static app::Result<std::unique_ptr<ProgramFile>> open(const std::string& path);
  ~ProgramFile() override;

  std::expected<std::size_t, std::string> read(std::span<char> into) override;
  std::expected<std::string, std::string> whole() override;

  // Of a regular file; nothing for a pipe, which can be read once only.
  [[nodiscard]] std::optional<std::uint64_t> size_bytes() const { return size_bytes_; }
  // The whole lines of the first kWholeBytes; the place of reading does not move.
  app::Result<text::Source> head();
  // The line around that byte, for messages: its text, and how many bytes of it come before.
  struct Line {
    std::string text;
    std::size_t before = 0;
  };
  app::Result<Line> line_at(std::uint64_t offset);

 private:
  ProgramFile(int file, std::string path, std::optional<std::uint64_t> size_bytes)
      : file_(file), path_(std::move(path)), size_bytes_(size_bytes) {}
  // Up to `count` bytes from `offset`.
  app::Result<std::string> bytes(std::uint64_t offset, std::size_t count) const;

  int file_;
  std::string path_;
  std::optional<std::uint64_t> size_bytes_;
};

}  // namespace dripfeed::cli

// The ledger of one transfer without a server: a text file that is synchronized to the disk with every line. What it
// says after a crash is what the server's ledger says: the true count lies between `clocked` and `reserve` of the last
// line.
#pragma once

#include <cstdint>
#include <expected>
#include <string>

#include "server/app/lines/line.h"

namespace dripfeed::cli {

class FileLedger {
 public:
  // Makes the file; refuses one that exists, because it is the record of another transfer.
  static std::expected<FileLedger, std::string> create(const std::string& path, const std::string& head);
  ~FileLedger();
  FileLedger(FileLedger&& other) noexcept;
  FileLedger& operator=(FileLedger&&) = delete;
  FileLedger(const FileLedger&) = delete;
  FileLedger& operator=(const FileLedger&) = delete;

  // One line, on the disk when it returns.
  std::expected<void, std::string> write(std::int64_t at_ms, const app::LineReport& report, std::uint64_t reserve,
                                         const std::string& note);

 private:
  FileLedger(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {}
  std::expected<void, std::string> append(const std::string& line);

  int descriptor_;
  std::string path_;
};

}  // namespace dripfeed::cli

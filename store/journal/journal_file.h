// The journal on the disk: a name of its own, then entries, each with its length and the hash of its bytes. A crash can
// only tear the last one, of which no caller was given word; a damage before it is an error.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "store/error.h"
#include "store/journal/entry.h"

namespace dripfeed::journal {

class JournalFile {
 public:
  // Makes the file where there is none. Errors: cannot_open, io_failed, corrupt (which byte).
  static store::Result<JournalFile> open(const std::string& path);
  JournalFile(JournalFile&& other) noexcept;
  JournalFile& operator=(JournalFile&&) = delete;
  ~JournalFile();

  // Made with the file, 64 hexadecimal digits: a database knows by it how far this journal was booked.
  [[nodiscard]] const std::string& name() const { return name_; }
  // What the file had when it was opened.
  [[nodiscard]] std::vector<Entry> take_entries() { return std::move(entries_); }
  [[nodiscard]] std::uint64_t bytes() const { return end_; }

  // Durable when it returns. What failed is not in the file. Errors: disk_full, io_failed.
  store::Result<void> append(const Entry& entry);
  // All entries are booked: the file has its name alone. A crash before this is durable brings them back.
  store::Result<void> clear();

 private:
  JournalFile(std::string path, int file) : path_(std::move(path)), file_(file) {}
  store::Result<void> make_name();
  store::Result<void> read();
  store::Result<void> write_at_end(const std::string& bytes);
  [[nodiscard]] store::Error fault(int error) const;

  std::string path_;
  int file_;
  std::string name_;
  std::vector<Entry> entries_;
  std::uint64_t end_ = 0;  // of what is whole
};

}  // namespace dripfeed::journal

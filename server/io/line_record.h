// The record of one line in a file: what was sent last, by whom, and whether it ended with a whole block. It survives a
// crash and a power failure at any moment. Who may write it, and by what that is decided, is the
// matter of the claim (line_claim.h).
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

namespace dripfeed::io {

enum class RecordState : std::uint8_t {
  clean,    // nothing is in transit; a control holds no part of a block
  sending,  // bytes may leave, or left when whoever sent them ended
  torn,     // what left broke off inside a block
};

struct LineRecord {
  RecordState state = RecordState::clean;
  std::string line{};      // the name of the line
  std::string what{};      // that was sent: "job 12"
  std::string why{};       // it broke off, or the reason of the last confirmed reset
  std::string by{};        // command and process id
  std::int64_t at_ms = 0;  // wall clock, of the last change
  std::string device{};    // the device that was at the port; "": not known
};

// "clean", "sending", "torn"
std::string_view name_of(RecordState state);
// "job 12 by dripfeed serve (pid 77) at 2026-11-24 11:40:00 UTC broke off inside a block: …"; "" for a clean one.
std::string describe(const LineRecord& record);
// "2026-11-24 11:40:00 UTC"
std::string text_of_time(std::int64_t at_ms);

// The file, open. One process writes it: whoever holds the line's lock. Move only.
class RecordFile {
 public:
  // Makes the file where there is none; or one sentence with the path and what the system said.
  static std::expected<RecordFile, std::string> open(const std::string& path);
  // What a record says, without a claim: it may change the moment after. A clean one where there is no file.
  static std::expected<LineRecord, std::string> look(const std::string& path);
  RecordFile(RecordFile&& other) noexcept;
  RecordFile& operator=(RecordFile&& other) noexcept;
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;
  ~RecordFile();

  [[nodiscard]] const LineRecord& record() const { return record_; }
  // On the disk when it returns. Long texts are cut, control characters become spaces.
  std::expected<void, std::string> write(const LineRecord& record);

 private:
  RecordFile(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {}
  std::expected<void, std::string> make();
  std::expected<void, std::string> read();
  [[nodiscard]] std::string system_error() const;

  int descriptor_;
  std::string path_;
  std::uint64_t sequence_ = 0;
  LineRecord record_;
};

// Makes an entry of a folder durable, as fsync() of a file does not. 0, or the system's error.
int sync_folder(const std::string& folder);
// FNV-1a, 64 bits: distinguishes a whole record from a broken one, and long names.
std::uint64_t fnv1a(std::string_view text);

}  // namespace dripfeed::io

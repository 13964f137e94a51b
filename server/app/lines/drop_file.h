// The file of one job that goes into a shop's folder: written under a name that no control fetches, read back, then
// named in one step. Every member blocks for as long as the folder's file system likes, for ever where its server
// hangs: only the folder's own thread calls them.
#pragma once

#include <atomic>
#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <string_view>

#include "store/hash/hash.h"

namespace dripfeed::app {

// Why a folder cannot be written to, in one sentence; empty where it can.
std::string look_at_folder(const std::string& folder);

// Removes what a lost power left, if it was not touched for ten minutes: another line may be writing to the same
// folder.
void remove_abandoned(const std::string& folder);

// The cause of give_name() after which the name may stand there all the same: a network share may have lost its answer.
inline constexpr std::string_view kNameNotTaken = "the folder does not take the name";

class DropFile {
 public:
  // Not open. `name` is unique among all that write to this folder.
  DropFile(std::string folder, std::string_view name);
  DropFile(const DropFile&) = delete;
  DropFile& operator=(const DropFile&) = delete;
  // Removes the file unless it got its name.
  ~DropFile();

  // Errors: what the system said.
  std::expected<void, std::string> create();
  std::expected<void, std::string> write(std::span<const std::byte> bytes);
  // On the disk, read back as written, and under `name`; a file of that name that says something else stays unless
  // `overwrite`. Once `given_up` is set no name is given any more. Errors: a cause that lives for ever.
  std::expected<void, std::string_view> give_name(const std::string& name, bool overwrite,
                                                  const std::atomic<bool>& given_up);

 private:
  std::expected<void, std::string_view> take_free_name(const std::string& path, const std::atomic<bool>& given_up);
  std::expected<void, std::string_view> same_text(const std::string& path);

  std::string folder_;
  std::string path_;
  int descriptor_ = -1;
  bool exists_ = false;
  hash::Sha256 sum_;  // of what was written
  std::string digest_;
};

}  // namespace dripfeed::app

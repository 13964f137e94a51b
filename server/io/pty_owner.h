// A link in the file system that leads to a pseudo-terminal, and whether the one who made it still lives. The number of
// a pseudo-terminal is given to another process once it is closed; a link that was left over by a crash then leads to
// a stranger. So the maker keeps a lock on PATH.owner, which the system drops with the process.
#pragma once

#include <expected>
#include <string>

namespace dripfeed::io {

class PtyOwner {
 public:
  // Makes `path` a link to `device` ("/dev/pts/4"). What a dead maker left is replaced; a living one's link, or a file
  // of another kind, is not: one sentence says which.
  static std::expected<PtyOwner, std::string> link(const std::string& path, const std::string& device);
  PtyOwner(PtyOwner&& other) noexcept;
  PtyOwner& operator=(PtyOwner&&) = delete;
  PtyOwner(const PtyOwner&) = delete;
  PtyOwner& operator=(const PtyOwner&) = delete;
  // The link goes, then the lock.
  ~PtyOwner() { let_go(); }
  void let_go();

 private:
  PtyOwner(int lock, std::string path, std::string device)
      : lock_(lock), path_(std::move(path)), device_(std::move(device)) {}

  int lock_;
  std::string path_;
  std::string device_;
};

// Whether `path` was linked by a maker that is gone.
bool is_abandoned(const std::string& path);

// For a port that was opened at `path`: refused where the maker of the link is gone, or where the link led to another
// device than the maker's. A path without an owner file is left alone here.
std::expected<void, std::string> check_pty_owner(const std::string& path, int descriptor);

}  // namespace dripfeed::io

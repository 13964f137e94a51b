// Brings what the write-ahead log holds into the database file, on a thread and a connection of its own: a commit that
// the ledger waits for never pays for it. PASSIVE: it waits for nothing and nothing waits for it.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "store/sqlite/connection.h"

namespace dripfeed::sqlite {

class Checkpointer {
 public:
  // The log is brought in when it is longer than this: often and little, because the disk makes a commit wait for what
  // is being written next to it.
  static constexpr std::uint64_t kLogBytes = std::uint64_t{1} << 20U;
  // Where the thread cannot keep up, or fails, a commit does it all the same: in pages of 4 KiB.
  static constexpr std::uint32_t kFallbackPages = 65'536;

  Checkpointer(std::string path, std::unique_ptr<Connection> connection);
  ~Checkpointer();
  Checkpointer(const Checkpointer&) = delete;
  Checkpointer& operator=(const Checkpointer&) = delete;

 private:
  void loop(const std::stop_token& stop);

  std::string log_path_;
  std::unique_ptr<Connection> connection_;
  std::mutex mutex_;
  std::condition_variable_any woken_;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::sqlite

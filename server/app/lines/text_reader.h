// Reads the texts of running jobs ahead of their feeds, on a thread of its own: a disk that is slow with one text
// delays no ledger and no other line's bytes.
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "server/app/base/round_thread.h"
#include "server/app/lines/content_source.h"

namespace dripfeed::app {

class TextReader {
 public:
  TextReader();

  // From any thread. A text belongs to one arming of a job, whatever its machine does before or after.
  void read_for(std::uint64_t session, std::shared_ptr<ContentSource> source);
  void arming_is_over(std::uint64_t session);
  bool wait_for_round(std::chrono::milliseconds patience) { return thread_.wait_for_round(patience); }

 private:
  void round();

  std::mutex mutex_;
  std::map<std::uint64_t, std::shared_ptr<ContentSource>> sources_;  // by session
  RoundThread thread_;                                               // last: it uses all of the above
};

}  // namespace dripfeed::app

// Waits for the notification that a node wrote an event, on a connection of its own. Where that cannot be had it waits
// all the same: whoever waits looks at the log after it in each case.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "store/postgresql/connection.h"

namespace dripfeed::postgresql {

class Listener {
 public:
  explicit Listener(std::string url) : url_(std::move(url)) {}
  void wait(std::chrono::milliseconds patience);

 private:
  bool listens();

  std::string url_;
  std::unique_ptr<Connection> connection_;
};

}  // namespace dripfeed::postgresql

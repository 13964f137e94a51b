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
  Listener(std::string url, std::shared_ptr<const Pulse> pulse) : url_(std::move(url)), pulse_(std::move(pulse)) {}
  void wait(std::chrono::milliseconds patience);

 private:
  bool listens();

  std::string url_;
  std::shared_ptr<const Pulse> pulse_;
  std::unique_ptr<Connection> connection_;
};

}  // namespace dripfeed::postgresql

// Controls that ask for a program (DC1, or their protocol's request) while nothing is armed: since when and how often.
// It is a state of the machine and no alarm: a control that waits for its program does so every few seconds.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>

#include "server/app/lines/line.h"
#include "server/app/ports/line_mutex.h"

namespace dripfeed::app {

struct Asks {
  std::uint64_t count = 0;    // 0: it does not ask
  std::int64_t since_ms = 0;  // 1970, UTC
  friend bool operator==(const Asks&, const Asks&) = default;
};

class AskWatch {
 public:
  static constexpr feed::Time kHeard = std::chrono::seconds(60);  // then it does not ask any more

  // What the line reports now. Over as soon as the line is used, or a job armed.
  Asks look(const std::string& machine, const LineReport& report, feed::Time now, std::int64_t wall_ms);
  // From any thread.
  [[nodiscard]] Asks of(const std::string& machine) const;

 private:
  struct Heard {
    std::uint64_t starts = 0;  // that the line had counted
    feed::Time last{};
    Asks asks;
  };
  mutable LineMutex mutex_{"who asks"};
  std::map<std::string, Heard> heard_;
};

}  // namespace dripfeed::app

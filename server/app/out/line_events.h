// The states of lines as events for other systems. A line changes far too often for them while it feeds (each hold is a
// change), so a state counts that has stood for a second.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "server/app/out/events.h"
#include "server/app/ports/clock.h"
#include "store/store.h"

namespace dripfeed::app {

class LineEvents {
 public:
  static constexpr std::chrono::milliseconds kStands{1000};

  // Whether this server has the machine's line; empty: it has each. Of another one's lines that one knows.
  using IsOurs = std::function<bool(std::string_view machine)>;

  LineEvents(store::Store& store, const Events& events, const Clock& clock, IsOurs is_ours = {})
      : store_(store), events_(events), clock_(clock), is_ours_(std::move(is_ours)) {}
  // Looks at all lines, and writes what is new. On one thread.
  void look();

 private:
  struct Seen {
    LineState state = LineState::disconnected;
    feed::Time since{};
    bool is_logged = false;
  };
  void look_at(const Progress& shown, feed::Time now);
  bool publish(const Progress& shown);

  store::Store& store_;
  const Events& events_;
  const Clock& clock_;
  IsOurs is_ours_;
  std::map<std::string, Seen> seen_;
  std::map<std::string, LineState> logged_;  // the last state of each machine that is in the log
};

}  // namespace dripfeed::app

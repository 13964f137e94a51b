// One watcher of live events, as the connection sees it: it takes what is ready and is woken when there is more. A slow
// watcher lags alone: its queue is bounded where it is made.
#pragma once

#include <functional>
#include <string>

namespace dripfeed::http {

class EventSubscription {
 public:
  EventSubscription() = default;
  EventSubscription(const EventSubscription&) = delete;
  EventSubscription& operator=(const EventSubscription&) = delete;
  virtual ~EventSubscription() = default;
  // All that is ready, as text/event-stream; empty when there is nothing.
  virtual std::string take() = 0;
  // Whoever watches may not any more (a token that was revoked): the stream is to be closed.
  virtual bool ended() = 0;
  // `ready` may be called from any thread, once for each time that something came; called with an empty function to
  // stop.
  virtual void on_ready(std::function<void()> ready) = 0;
};

}  // namespace dripfeed::http

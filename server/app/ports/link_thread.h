// The thread that all links share. Its work per character is small and bounded: no JSON, SQL, hashing, logging or
// allocation.
#pragma once

#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "server/app/ports/clock.h"
#include "server/app/ports/link.h"
#include "server/machine/link_url.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

// Something that wants to be called at its deadline. The thread rounds deadlines up to its own tick of 1 ms, shorter
// where a ticker says so.
class Ticker {
 public:
  Ticker() = default;
  Ticker(const Ticker&) = delete;
  Ticker& operator=(const Ticker&) = delete;
  virtual ~Ticker() = default;
  virtual void tick(feed::Time now) = 0;
  [[nodiscard]] virtual std::optional<feed::Time> deadline() const = 0;
};

class LinkThread {
 public:
  LinkThread() = default;
  LinkThread(const LinkThread&) = delete;
  LinkThread& operator=(const LinkThread&) = delete;
  virtual ~LinkThread() = default;
  [[nodiscard]] virtual const Clock& clock() const = 0;
  // Runs `work` on the thread, in order. From any thread.
  virtual void post(std::function<void()> work) = 0;
  // The same, and waits until it is done. Not from the thread itself.
  virtual void run(const std::function<void()>& work) = 0;

  // The rest on the thread only.
  virtual void add(Ticker& ticker) = 0;
  virtual void remove(Ticker& ticker) = 0;
  // Opens a link of bytes; or one sentence that says what the system refused. Success may come before the link is up.
  virtual std::expected<std::unique_ptr<Link>, std::string> open(const machine::LineSettings& line,
                                                                 LinkListener& listener) = 0;
};

}  // namespace dripfeed::app

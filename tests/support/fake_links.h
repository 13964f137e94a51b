// The links' thread and its links without a system, in virtual time: a test lets time pass, answers for the far end and
// sees every byte that was written. Work that other threads post waits until the test's thread comes by.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "server/app/ports/link_thread.h"
#include "tests/support/virtual_clock.h"

namespace dripfeed::test {

inline std::vector<std::byte> bytes_of(std::string_view text) {
  std::vector<std::byte> bytes;
  for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
  return bytes;
}

// Whatever is at the other end of a link.
class Peer {
 public:
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  virtual ~Peer() = default;
  virtual void receive(std::span<const std::byte> bytes, feed::Time now) = 0;
  virtual void tick(feed::Time now) = 0;
  // What it sends by now.
  virtual std::vector<std::byte> take_out(feed::Time now) = 0;
  [[nodiscard]] virtual std::optional<feed::Time> deadline() const = 0;
};

// One cable, by the URL's text: it stays when links on it come and go.
struct Cable {
  app::LinkListener* listener = nullptr;  // of the link that is open
  bool is_up = false;
  bool comes_up = true;                       // as soon as it is opened
  std::optional<bool> rts;                    // what it was set to; nothing: it was not
  std::string refusal;                        // opening fails with this
  int opened = 0;                             // times
  std::string written;                        // every byte that left, over all links
  std::optional<std::size_t> accept_at_most;  // of each write
  std::optional<std::uint64_t> unsent;
  std::optional<std::uint64_t> unconfirmed;
  std::string unread;                                   // came in, and the system has not reported it
  std::function<void(std::size_t total)> before_write;  // with the bytes that will have been written
  Peer* peer = nullptr;
};

class FakeLink final : public app::Link {
 public:
  FakeLink(Cable& cable, const VirtualClock& clock) : cable_(cable), clock_(clock) {}
  ~FakeLink() override {
    cable_.listener = nullptr;
    cable_.is_up = false;
  }
  std::size_t write(std::span<const std::byte> bytes) override {
    if (!cable_.is_up) return 0;
    const std::size_t count = std::min(bytes.size(), cable_.accept_at_most.value_or(bytes.size()));
    if (cable_.before_write && count > 0) cable_.before_write(cable_.written.size() + count);
    for (const std::byte byte : bytes.first(count)) cable_.written += static_cast<char>(byte);
    if (cable_.peer != nullptr && count > 0) cable_.peer->receive(bytes.first(count), clock_.now());
    return count;
  }
  std::size_t read(std::span<std::byte> into) override {
    const std::size_t count = std::min(into.size(), cable_.unread.size());
    std::copy_n(bytes_of(cable_.unread).begin(), count, into.begin());
    cable_.unread.erase(0, count);
    return count;
  }
  std::optional<std::uint64_t> unsent() override { return cable_.unsent; }
  bool set_rts(bool on) override {
    cable_.rts = on;
    return true;
  }
  std::optional<std::uint64_t> unconfirmed() override { return cable_.unconfirmed; }

 private:
  Cable& cable_;
  const VirtualClock& clock_;
};

class FakeLinkThread final : public app::LinkThread {
 public:
  // --- what the lines call
  [[nodiscard]] const app::Clock& clock() const override { return clock_; }
  void post(std::function<void()> work) override {
    const std::lock_guard lock(posted_mutex_);
    posted_.push_back(std::move(work));
  }
  void run(const std::function<void()>& work) override {
    const std::lock_guard lock(mutex_);
    do_posted();
    work();
    do_posted();
  }
  void add(app::Ticker& ticker) override { tickers_.push_back(&ticker); }
  void remove(app::Ticker& ticker) override { std::erase(tickers_, &ticker); }
  std::expected<std::unique_ptr<app::Link>, std::string> open(const machine::LineSettings& line,
                                                              app::LinkListener& listener) override {
    Cable& cable = cables_[line.link.text];
    ++cable.opened;
    if (!cable.refusal.empty()) return std::unexpected(cable.refusal);
    cable.listener = &listener;
    post([this, &cable, opened = cable.opened] {
      if (cable.comes_up && cable.opened == opened) come_up(cable);
    });
    return std::make_unique<FakeLink>(cable, clock_);
  }

  // --- what a test calls
  Cable& cable(const std::string& url) { return cables_[url]; }
  void up(const std::string& url) {
    act([&] { come_up(cables_[url]); });
  }
  void receive(const std::string& url, std::string_view text) {
    act([&] {
      if (cables_[url].listener != nullptr) cables_[url].listener->on_receive(bytes_of(text));
    });
  }
  void writable(const std::string& url) {
    act([&] { cables_[url].listener->on_writable(); });
  }
  void lose(const std::string& url, std::string_view reason = "the cable is cut") {
    act([&] {
      Cable& cable = cables_[url];
      cable.is_up = false;
      if (app::LinkListener* listener = std::exchange(cable.listener, nullptr)) listener->on_lost(reason);
    });
  }
  void set_cts(const std::string& url, bool on) {
    act([&] { cables_[url].listener->on_cts(on); });
  }
  void run_posted() {
    act([] {});
  }
  // Time passes, from one deadline to the next.
  void advance(feed::Time span) {
    const std::lock_guard lock(mutex_);
    const feed::Time until = clock_.now() + span;
    do_posted();
    for (;;) {
      const std::optional<feed::Time> next = earliest();
      if (!next || *next > until) break;
      clock_.set(std::max(*next, clock_.now()));
      tick_due();
      do_posted();
    }
    clock_.set(until);
  }
  [[nodiscard]] feed::Time now() const { return clock_.now(); }

 private:
  template <class Action>
  void act(const Action& action) {
    const std::lock_guard lock(mutex_);
    do_posted();
    action();
    do_posted();
  }

  void come_up(Cable& cable) {
    if (cable.listener == nullptr || cable.is_up) return;
    cable.is_up = true;
    cable.listener->on_up();
  }

  void do_posted() {
    for (;;) {
      std::vector<std::function<void()>> work;
      {
        const std::lock_guard lock(posted_mutex_);
        work.swap(posted_);
      }
      if (work.empty()) return;
      for (const auto& one : work) one();
    }
  }

  [[nodiscard]] std::optional<feed::Time> earliest() const {
    std::optional<feed::Time> first;
    const auto consider = [&](std::optional<feed::Time> at) {
      if (at && (!first || *at < *first)) first = at;
    };
    for (const app::Ticker* ticker : tickers_) consider(ticker->deadline());
    for (const auto& [url, cable] : cables_) {
      if (cable.peer != nullptr) consider(cable.peer->deadline());
    }
    return first;
  }

  void tick_due() {
    const feed::Time now = clock_.now();
    for (auto& [url, cable] : cables_) {
      if (cable.peer == nullptr) continue;
      cable.peer->tick(now);
      const std::vector<std::byte> out = cable.peer->take_out(now);
      if (!out.empty() && cable.is_up) cable.listener->on_receive(out);
    }
    for (app::Ticker* ticker : tickers_) {
      const auto due = ticker->deadline();
      if (due && *due <= now) ticker->tick(now);
    }
  }

  VirtualClock clock_;
  std::recursive_mutex mutex_;  // a peer's answer may run a line's command
  std::mutex posted_mutex_;
  std::vector<std::function<void()>> posted_;
  std::vector<app::Ticker*> tickers_;
  std::map<std::string, Cable> cables_;
};

}  // namespace dripfeed::test

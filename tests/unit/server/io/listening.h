// What the tests of links share: a listener that remembers, and waiting for what another thread does. Waits end with
// what is waited for; their limit is long, so that a busy machine fails nothing.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "server/io/io.h"

namespace dripfeed::io::test {

inline constexpr std::chrono::seconds kLongest{30};

inline std::vector<std::byte> bytes_of(std::string_view text) {
  std::vector<std::byte> bytes;
  for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
  return bytes;
}

inline machine::LineSettings line_of(const std::string& url) {
  machine::LineSettings line;
  line.link = machine::parse_link_url(url).value();
  line.framing = tape_code::parse_framing("7E2").value();
  return line;
}

class Heard final : public app::LinkListener {
 public:
  void on_up() override {
    act([this] { ++ups_; });
  }
  void on_receive(std::span<const std::byte> bytes) override {
    act([&] {
      for (const std::byte byte : bytes) received_ += static_cast<char>(byte);
    });
  }
  void on_writable() override {
    act([this] { ++writables_; });
  }
  void on_cts(bool on) override {
    act([&] { lines_.emplace_back(on ? "cts on" : "cts off"); });
  }
  void on_dsr(bool on) override {
    act([&] { lines_.emplace_back(on ? "dsr on" : "dsr off"); });
  }
  void on_lost(std::string_view reason) override {
    if (when_lost) when_lost();
    act([&] {
      ++losses_;
      reason_ = reason;
    });
  }
  std::function<void()> when_lost;  // inside on_lost, on the links' thread

  bool await_ups(int count) {
    return await([&] { return ups_ >= count; });
  }
  bool await_received(std::size_t bytes) {
    return await([&] { return received_.size() >= bytes; });
  }
  bool await_writables(int count) {
    return await([&] { return writables_ >= count; });
  }
  bool await_losses(int count) {
    return await([&] { return losses_ >= count; });
  }
  bool await_lines(std::string_view change) {
    return await([&] { return std::ranges::find(lines_, change) != lines_.end(); });
  }
  std::string received() { return get(received_); }
  std::string reason() { return get(reason_); }
  int ups() { return get(ups_); }
  int losses() { return get(losses_); }
  int writables() { return get(writables_); }

 private:
  template <class Action>
  void act(const Action& action) {
    const std::lock_guard lock(mutex_);
    action();
    changed_.notify_all();
  }
  template <class Condition>
  bool await(const Condition& condition) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kLongest, condition);
  }
  template <class T>
  T get(const T& value) {
    const std::lock_guard lock(mutex_);
    return value;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  int ups_ = 0;
  int losses_ = 0;
  int writables_ = 0;
  std::string received_;
  std::string reason_;
  std::vector<std::string> lines_;
};

// A links' thread and one link on it. Everything of the link happens on that thread, as its port asks for.
class LinkTest : public ::testing::Test {
 protected:
  ~LinkTest() override { close(); }
  // "" or what the system refused.
  std::string open(const std::string& url) {
    std::string refusal;
    thread_->run([&] {
      auto opened = thread_->open(line_of(url), heard_);
      if (opened) {
        link_ = std::move(*opened);
      } else {
        refusal = opened.error();
      }
    });
    return refusal;
  }
  void close() {
    thread_->run([&] { link_.reset(); });
  }
  std::size_t write(std::string_view text) {
    std::size_t taken = 0;
    thread_->run([&] { taken = link_->write(bytes_of(text)); });
    return taken;
  }
  std::optional<std::uint64_t> unsent() {
    std::optional<std::uint64_t> count;
    thread_->run([&] { count = link_->unsent(); });
    return count;
  }

  Heard heard_;
  std::unique_ptr<app::LinkThread> thread_ = start_link_thread();
  std::unique_ptr<app::Link> link_;
};

}  // namespace dripfeed::io::test

// Turns on a register bus: one thread for all units of it, no one starved by a dead one, and a user that leaves has no
// turn any more.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <iostream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include "server/io/modbus_bus.h"

namespace dripfeed::io {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// The units 1 to 3 of a serial line: each answers FC3 with one register, its number. No one else is there.
class Slaves {
 public:
  Slaves() : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
    ::grantpt(master_);
    ::unlockpt(master_);
    termios settings{};
    ::tcgetattr(master_, &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(master_, TCSANOW, &settings);
    thread_ = std::jthread([this](const std::stop_token& stop) { loop(stop); });
  }
  Slaves(const Slaves&) = delete;
  Slaves& operator=(const Slaves&) = delete;
  ~Slaves() {
    thread_.request_stop();
    thread_.join();
    ::close(master_);
  }
  [[nodiscard]] std::string url(int unit, const std::string& more = {}) const {
    return "modbus-rtu:" + std::string(::ptsname(master_)) + "?timeout_ms=100&unit=" + std::to_string(unit) + more;
  }

 private:
  using Frame = std::array<std::uint8_t, 8>;
  static std::uint16_t crc_of(std::span<const std::uint8_t> bytes) {
    unsigned crc = 0xFFFF;
    for (const std::uint8_t byte : bytes) {
      crc ^= byte;
      for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xA001U : crc >> 1U;
    }
    return static_cast<std::uint16_t>(crc);
  }
  void loop(const std::stop_token& stop) {
    Frame request{};
    std::size_t have = 0;
    while (!stop.stop_requested()) {
      pollfd file{master_, POLLIN, 0};
      ::poll(&file, 1, 10);
      if ((file.revents & POLLHUP) != 0) std::this_thread::sleep_for(1ms);  // no one has it open
      const ssize_t count = ::read(master_, request.data() + have, request.size() - have);
      if (count <= 0) continue;
      have += static_cast<std::size_t>(count);
      if (have < request.size()) continue;
      have = 0;
      if (request[0] < 1 || request[0] > 3) continue;
      std::array<std::uint8_t, 7> answer{request[0], 3, 2, 0, request[0]};
      const std::uint16_t crc = crc_of(std::span(answer).first(5));
      answer[5] = static_cast<std::uint8_t>(crc & 0xFFU);
      answer[6] = static_cast<std::uint8_t>(crc >> 8U);
      EXPECT_EQ(::write(master_, answer.data(), answer.size()), 7);
    }
  }

  int master_;
  std::jthread thread_;
};

// Asks its unit again and again, as a line that polls does.
class Asker final : public app::BusUser {
 public:
  explicit Asker(std::chrono::milliseconds every = 20ms) : every_(every) {}
  std::optional<std::chrono::nanoseconds> turn(app::RegisterBus& bus) override {
    std::array<std::uint16_t, 1> value{};
    const auto begun = Clock::now();
    const bool answered = bus.read(0, value).has_value();
    const std::lock_guard lock(mutex_);
    threads_.insert(std::this_thread::get_id());
    if (wanted_ != Clock::time_point{}) worst_ = std::max(worst_, begun - wanted_);
    (answered ? answered_ : failed_) += 1;
    value_ = value[0];
    wanted_ = Clock::now() + every_;
    return every_;
  }
  [[nodiscard]] int answered() const { return read(answered_); }
  [[nodiscard]] int failed() const { return read(failed_); }
  [[nodiscard]] std::uint16_t value() const { return read(value_); }
  [[nodiscard]] std::chrono::milliseconds worst() const {
    return std::chrono::duration_cast<std::chrono::milliseconds>(read(worst_));
  }
  [[nodiscard]] std::set<std::thread::id> threads() const { return read(threads_); }

 private:
  template <class T>
  T read(const T& what) const {
    const std::lock_guard lock(mutex_);
    return what;
  }
  std::chrono::milliseconds every_;
  mutable std::mutex mutex_;
  int answered_ = 0;
  int failed_ = 0;
  std::uint16_t value_ = 0;
  Clock::time_point wanted_{};
  Clock::duration worst_{};
  std::set<std::thread::id> threads_;
};

std::unique_ptr<app::BusSeat> sit(const std::string& url, app::BusUser& user) {
  auto seat = take_modbus_seat(machine::parse_link_url(url).value(), user);
  if (!seat) ADD_FAILURE() << seat.error();
  return seat ? std::move(*seat) : nullptr;
}

bool until(const std::function<bool()>& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
  return condition();
}

TEST(ModbusTurns, ADeadUnitLeavesTheBusToTheOthers) {
  const Slaves line;
  std::array<Asker, 4> askers;  // the fourth unit is not there
  std::vector<std::unique_ptr<app::BusSeat>> seats;
  for (int unit = 1; unit <= 4; ++unit)
    seats.push_back(sit(line.url(unit), askers.at(static_cast<std::size_t>(unit - 1))));
  const auto begun = Clock::now();
  ASSERT_TRUE(until([&] { return askers[3].failed() >= 5; }));
  const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
  seats.clear();
  EXPECT_EQ(askers[3].answered(), 0);
  for (std::size_t i = 0; i < 3; ++i) {
    std::cout << "unit " << i + 1 << ": " << askers.at(i).answered() / seconds << " requests a second, longest wait "
              << askers.at(i).worst().count() << " ms\n";
    EXPECT_EQ(askers.at(i).value(), i + 1);
    EXPECT_GE(askers.at(i).answered(), 8 * askers[3].failed()) << "it waits for each failure and no more";
    EXPECT_LT(askers.at(i).worst(), 300ms) << "once the time-out of 100 ms, and the others' requests";
  }
}

TEST(ModbusTurns, WhatOneUserThrowsLeavesTheBusToTheOthers) {
  class Thrower final : public app::BusUser {
   public:
    std::optional<std::chrono::nanoseconds> turn(app::RegisterBus& /*bus*/) override {
      ++turns;
      throw std::runtime_error("no memory for this machine");
    }
    std::atomic<int> turns = 0;
  };
  const Slaves line;
  Thrower bad;
  Asker good;
  const auto seat = sit(line.url(1), bad);
  const auto other = sit(line.url(2), good);
  ASSERT_TRUE(until([&] { return bad.turns >= 2; }));
  const int answered = good.answered();
  EXPECT_TRUE(until([&] { return good.answered() > answered + 10; }));
}

TEST(ModbusTurns, AUnitAloneIsAskedAtOnceAgain) {
  const Slaves line;
  Asker dead;
  const auto begun = Clock::now();
  const auto seat = sit(line.url(4, "&poll_ms=20"), dead);
  ASSERT_TRUE(until([&] { return dead.failed() >= 10; }));
  EXPECT_LT(Clock::now() - begun, 2500ms) << "10 time-outs; with rests it would be 3.4 s";
}

TEST(ModbusTurns, OneThreadForAllUnitsOfABus) {
  const Slaves line;
  const Slaves other;
  std::array<Asker, 4> askers;
  std::vector<std::unique_ptr<app::BusSeat>> seats;
  for (int unit = 1; unit <= 3; ++unit)
    seats.push_back(sit(line.url(unit), askers.at(static_cast<std::size_t>(unit - 1))));
  seats.push_back(sit(other.url(1), askers[3]));
  ASSERT_TRUE(until([&] { return std::ranges::all_of(askers, [](const Asker& a) { return a.answered() >= 3; }); }));
  for (const Asker& asker : askers) EXPECT_EQ(asker.threads().size(), 1U);
  EXPECT_EQ(askers[0].threads(), askers[1].threads());
  EXPECT_EQ(askers[0].threads(), askers[2].threads());
  EXPECT_NE(askers[0].threads(), askers[3].threads());
  EXPECT_FALSE(askers[0].threads().contains(std::this_thread::get_id()));
}

TEST(ModbusTurns, WhoLeavesHasNoTurnAnyMore) {
  const Slaves line;
  for (int i = 0; i < 20; ++i) {
    auto asker = std::make_unique<Asker>(0ms);
    const Asker* const seen = asker.get();
    auto seat = sit(line.url(i % 4 + 1), *asker);
    if (i % 2 == 0) {
      ASSERT_TRUE(until([&] { return seen->answered() + seen->failed() > 0; }));
    }
    seat->wake();
    seat.reset();
    asker.reset();  // a turn now would be seen by the sanitizers, and most often without
  }
}

TEST(ModbusTurns, AWakeIsATurn) {
  const Slaves line;
  Asker asker(1h);
  const auto seat = sit(line.url(2), asker);
  ASSERT_TRUE(until([&] { return asker.answered() == 1; }));
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(asker.answered(), 1);
  seat->wake();
  ASSERT_TRUE(until([&] { return asker.answered() == 2; }));
}

TEST(ModbusTurns, TheSeventeenthBusIsRefused) {
  Asker asker(1h);
  std::vector<std::unique_ptr<app::BusSeat>> seats;
  for (std::size_t i = 0; i < kMaxBuses; ++i) seats.push_back(sit("modbus-rtu:/nowhere/" + std::to_string(i), asker));
  const auto more = take_modbus_seat(machine::parse_link_url("modbus-rtu:/nowhere/more").value(), asker);
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error(),
            "modbus-rtu:/nowhere/more: there are 16 register buses already; more than that are not served");
  EXPECT_TRUE(take_modbus_seat(machine::parse_link_url("modbus-rtu:/nowhere/3?unit=9").value(), asker));
  seats.pop_back();
  EXPECT_TRUE(take_modbus_seat(machine::parse_link_url("modbus-rtu:/nowhere/more").value(), asker));
}

}  // namespace
}  // namespace dripfeed::io

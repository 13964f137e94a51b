// A register bus for a test that calls it and waits: each call becomes a turn on the bus's own thread.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

#include "server/app/ports/register_bus.h"

namespace dripfeed::test {

class CallingBus final : public app::RegisterBus, private app::BusUser {
 public:
  // A bus that cannot be had says why with every call.
  CallingBus(const machine::LinkUrl& url, app::BusSeatMaker take_seat) {
    auto seat = take_seat(url, *this);
    if (!seat) {
      refusal_ = seat.error();
    } else {
      seat_ = std::move(*seat);
    }
  }

  std::expected<void, app::BusFailure> write(std::uint16_t address, std::span<const std::uint16_t> registers) override {
    return call<std::expected<void, app::BusFailure>>(
        [=](app::RegisterBus& bus) { return bus.write(address, registers); });
  }
  std::expected<void, app::BusFailure> read(std::uint16_t address, std::span<std::uint16_t> registers) override {
    return call<std::expected<void, app::BusFailure>>(
        [=](app::RegisterBus& bus) { return bus.read(address, registers); });
  }
  std::expected<bool, app::BusFailure> exchange(std::uint16_t to, std::span<const std::uint16_t> registers,
                                                std::uint16_t from, std::span<std::uint16_t> into) override {
    return call<std::expected<bool, app::BusFailure>>(
        [=](app::RegisterBus& bus) { return bus.exchange(to, registers, from, into); });
  }

 private:
  template <class Result, class Request>
  Result call(const Request& request) {
    if (!seat_) return std::unexpected(app::BusFailure{.link_lost = true, .text = refusal_});
    Result result;
    std::unique_lock lock(mutex_);
    work_ = [&](app::RegisterBus& bus) { result = request(bus); };
    seat_->wake();
    done_.wait(lock, [this] { return !work_; });
    return result;
  }
  std::optional<std::chrono::nanoseconds> turn(app::RegisterBus& bus) override {
    const std::lock_guard lock(mutex_);
    if (!work_) return std::nullopt;
    work_(bus);
    work_ = nullptr;
    done_.notify_all();
    return std::nullopt;
  }

  std::string refusal_;
  std::mutex mutex_;
  std::condition_variable done_;
  std::function<void(app::RegisterBus&)> work_;
  std::unique_ptr<app::BusSeat> seat_;  // last: its turns use all of the above
};

inline std::unique_ptr<app::RegisterBus> calling_bus(const machine::LinkUrl& url, app::BusSeatMaker take_seat) {
  return std::make_unique<CallingBus>(url, take_seat);
}

}  // namespace dripfeed::test

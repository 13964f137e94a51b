// A PLC with the block mailbox behind a register bus without a network. Calls can be lost before or after they took
// effect, fail for good, or be held up; the text that arrived is compared byte by byte.
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <random>
#include <string>

#include "protocol/modbus/modbus.h"
#include "server/app/ports/register_bus.h"

namespace dripfeed::app::test {

class RegisterPlc final : private modbus::TextSink {
 public:
  RegisterPlc() { receiver_.set_free_blocks(kCredit); }

  // One call in `one_in` is lost, half of them after they took effect. 0: none.
  void lose_calls(unsigned one_in) { one_in_.store(one_in); }
  void go_away(bool gone) { gone_.store(gone); }
  void give_credit(bool gives) { gives_.store(gives); }
  // Called inside each write with its registers, on the bus's thread, before they take effect.
  void look_at_writes(std::function<void(std::span<const std::uint16_t>)> look) {
    const std::lock_guard lock(mutex_);
    look_ = std::move(look);
  }
  [[nodiscard]] std::string text() {
    const std::lock_guard lock(mutex_);
    return text_;
  }
  [[nodiscard]] modbus::Status status() {
    const std::lock_guard lock(mutex_);
    return receiver_.status();
  }
  [[nodiscard]] int writes() const { return writes_.load(); }

  std::expected<void, BusFailure> write(std::span<const std::uint16_t> registers) {
    ++writes_;
    std::function<void(std::span<const std::uint16_t>)> look;
    {
      const std::lock_guard lock(mutex_);
      look = look_;
    }
    if (look) look(registers);
    const std::lock_guard lock(mutex_);
    const Luck luck = draw();
    if (luck == Luck::lost_before) return failure();
    receiver_.written(0, registers);
    settle();
    if (luck == Luck::lost_after) return failure();
    return {};
  }
  std::expected<void, BusFailure> read(std::span<std::uint16_t> registers) {
    const std::lock_guard lock(mutex_);
    if (draw() != Luck::arrives) return failure();
    settle();
    receiver_.beat();
    std::ranges::copy(receiver_.status_image(), registers.begin());
    return {};
  }

 private:
  static constexpr std::uint16_t kCredit = 8;
  enum class Luck : std::uint8_t { arrives, lost_before, lost_after };

  Luck draw() {
    if (gone_.load()) return Luck::lost_before;
    const unsigned one_in = one_in_.load();
    if (one_in == 0 || random_() % one_in != 0) return Luck::arrives;
    return random_() % 2 == 0 ? Luck::lost_before : Luck::lost_after;
  }
  static std::unexpected<BusFailure> failure() {
    return std::unexpected(BusFailure{.link_lost = true, .text = "the PLC does not answer"});
  }
  void settle() {
    receiver_.set_free_blocks(gives_.load() ? kCredit : std::uint16_t{0});
    receiver_.set_consumed(static_cast<std::uint32_t>(text_.size()));
  }
  void clear() noexcept override { text_.clear(); }
  bool append(std::span<const std::byte> bytes) noexcept override {
    for (const std::byte byte : bytes) text_ += static_cast<char>(byte);
    return true;
  }

  std::mutex mutex_;
  std::string text_;
  modbus::Receiver receiver_{*this, 1};
  std::minstd_rand random_{7};
  std::atomic<unsigned> one_in_{0};
  std::atomic<bool> gone_{false};
  std::atomic<bool> gives_{true};
  std::atomic<int> writes_{0};
  std::function<void(std::span<const std::uint16_t>)> look_;
};

class PlcBus final : public RegisterBus {
 public:
  explicit PlcBus(RegisterPlc& plc) : plc_(plc) {}
  std::expected<void, BusFailure> write(std::uint16_t address, std::span<const std::uint16_t> registers) override {
    if (address != kMailboxAddress) return std::unexpected(BusFailure{.link_lost = false, .text = "illegal address"});
    return plc_.write(registers);
  }
  std::expected<void, BusFailure> read(std::uint16_t address, std::span<std::uint16_t> registers) override {
    if (address != kStatusAddress) return std::unexpected(BusFailure{.link_lost = false, .text = "illegal address"});
    return plc_.read(registers);
  }

 private:
  RegisterPlc& plc_;
};

// The PLCs that buses are made for, by the URL's text.
inline std::map<std::string, RegisterPlc*>& plcs() {
  static std::map<std::string, RegisterPlc*> all;
  return all;
}
inline std::unique_ptr<RegisterBus> make_plc_bus(const machine::LinkUrl& url) {
  return std::make_unique<PlcBus>(*plcs().at(url.text));
}

}  // namespace dripfeed::app::test

// A PLC with the block mailbox on a register bus without a network. Calls can be lost before or after they took
// effect, fail for good, or be held up; the text that arrived is compared byte by byte.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <thread>

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
    consume_all();
    if (luck == Luck::lost_after) return failure();
    return {};
  }
  std::expected<void, BusFailure> read(std::span<std::uint16_t> registers) {
    const std::lock_guard lock(mutex_);
    ++reads_;
    if (draw() != Luck::arrives) return failure();
    const bool wants_words = registers.size() > modbus::kStatusRegisters;
    if (wants_words && !words_ && ignores_long_reads_) return failure();
    if (wants_words && !words_) return illegal_address();
    consume_all();
    receiver_.beat();
    std::ranges::copy(receiver_.status_image(), registers.begin());
    modbus::MachineImage image{};
    if (words_) modbus::encode(*words_, image);
    if (wants_words) std::ranges::copy(image, registers.begin() + modbus::kStatusRegisters);
    return {};
  }
  std::expected<void, BusFailure> write_answer(std::span<const std::uint16_t> registers) {
    const std::lock_guard lock(mutex_);
    if (draw() != Luck::arrives) return failure();
    std::ranges::copy(registers, answer_.begin());
    ++answers_;
    return {};
  }
  std::expected<void, BusFailure> read_answer(std::span<std::uint16_t> registers) {
    const std::lock_guard lock(mutex_);
    if (draw() != Luck::arrives) return failure();
    std::ranges::copy(answer_, registers.begin());
    return {};
  }

  // The machine's words; nothing: a PLC of the map without them, which answers a longer read by an exception or not.
  void show(const std::optional<modbus::MachineWords>& words, bool ignores_long_reads = false) {
    const std::lock_guard lock(mutex_);
    words_ = words;
    ignores_long_reads_ = ignores_long_reads;
  }
  [[nodiscard]] modbus::AnswerImage answer() {
    const std::lock_guard lock(mutex_);
    return answer_;
  }
  [[nodiscard]] int answers() {
    const std::lock_guard lock(mutex_);
    return answers_;
  }
  [[nodiscard]] int reads() const { return reads_.load(); }
  static std::unexpected<BusFailure> illegal_address() {
    return std::unexpected(BusFailure{.link_lost = false, .text = "illegal address"});
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
  void consume_all() {
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
  std::atomic<int> reads_{0};
  std::optional<modbus::MachineWords> words_;
  bool ignores_long_reads_ = false;
  modbus::AnswerImage answer_{};
  int answers_ = 0;
  std::function<void(std::span<const std::uint16_t>)> look_;
};

class PlcBus final : public RegisterBus {
 public:
  explicit PlcBus(RegisterPlc& plc) : plc_(plc) {}
  std::expected<void, BusFailure> write(std::uint16_t address, std::span<const std::uint16_t> registers) override {
    if (address == kAnswerAddress) return plc_.write_answer(registers);
    if (address != kMailboxAddress) return RegisterPlc::illegal_address();
    return plc_.write(registers);
  }
  std::expected<void, BusFailure> read(std::uint16_t address, std::span<std::uint16_t> registers) override {
    if (address == kAnswerAddress) return plc_.read_answer(registers);
    if (address != kStatusAddress) return RegisterPlc::illegal_address();
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

// A bus with one place: its thread gives turns as they are wanted, by the real clock.
class PlcSeat final : public BusSeat {
 public:
  PlcSeat(RegisterPlc& plc, BusUser& user)
      : bus_(plc), user_(user), thread_([this](const std::stop_token& stop) { loop(stop); }) {}
  void wake() override {
    const std::lock_guard lock(mutex_);
    woken_ = true;
    wake_.notify_all();
  }

 private:
  void loop(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      {
        const std::lock_guard lock(mutex_);
        woken_ = false;
      }
      const auto wait = user_.turn(bus_);
      std::unique_lock lock(mutex_);
      // Virtual time may pass much quicker.
      wake_.wait_for(lock, stop, std::min(wait.value_or(kLook), kLook), [this] { return woken_; });
    }
  }

  static constexpr std::chrono::nanoseconds kLook = std::chrono::milliseconds(2);
  PlcBus bus_;
  BusUser& user_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  bool woken_ = false;
  std::jthread thread_;  // last: it uses all of the above
};
inline std::expected<std::unique_ptr<BusSeat>, std::string> take_plc_seat(const machine::LinkUrl& url, BusUser& user) {
  return std::make_unique<PlcSeat>(*plcs().at(url.text), user);
}

}  // namespace dripfeed::app::test

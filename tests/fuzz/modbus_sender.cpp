// The sending side of the block mailbox against a receiver over a bus that loses, repeats, tears and damages as the
// input says. The receiver holds the beginning of the text at any time, and all of it when the sender says done.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "protocol/modbus/modbus.h"
#include "tests/fuzz/target.h"

using namespace dripfeed;
using modbus::SenderState;
using modbus::Time;

namespace {

class Text final : public modbus::TextSink {
 public:
  void clear() noexcept override { text.clear(); }
  bool append(std::span<const std::byte> bytes) noexcept override {
    if (full) return false;
    for (const std::byte byte : bytes) text.push_back(static_cast<char>(byte));
    return true;
  }
  std::string text;
  bool full = false;
};

std::string whole_text() {
  std::string text = "%\nO1\n";
  for (int i = 0; i < 20; ++i) text += "G1X" + std::to_string(i) + ".\n";
  return text + "M30\n%\n";
}

class Bus {
 public:
  explicit Bus(fuzz::Choices& choices) : choices_(choices) {
    settings_.max_payload = 1 + choices_.below(64);
    sender_.emplace(settings_);
    receiver_.emplace(sink_, boot_);
  }

  void run() {
    for (int steps = 0; !choices_.done() && steps < 1500; ++steps) {
      step();
      require_text();
    }
  }

 private:
  void step() {
    switch (choices_.below(12)) {
      case 0: start(); break;
      case 1: {
        const auto command = static_cast<modbus::SenderCommand>(choices_.below(4));
        static_cast<void>(sender_->command(command, now_));
        break;
      }
      case 2: now_ += Time(static_cast<std::int64_t>(choices_.word()) * 100'000); break;
      case 3: receiver_->set_free_blocks(static_cast<std::uint16_t>(choices_.below(4))); break;
      case 4: receiver_->set_consumed(receiver_->memory().appended); break;
      case 5: sink_.full = choices_.flag(); break;
      case 6: restart_receiver(); break;
      case 7: restart_sender(); break;
      case 8:
        reserve_ += choices_.byte();
        sender_->extend_reserve(reserve_, now_);
        break;
      default: exchange(); break;
    }
    sender_->tick(now_);
    while (const auto event = sender_->next_event()) {
      if (event->kind == modbus::SenderEventKind::opened) journaled_boot_ = event->boot_counter;
    }
  }

  modbus::SenderJob job(std::uint32_t session) {
    source_.emplace(text_);
    return {.source = &*source_, .text_bytes = text_.size(), .session = session, .reserve = reserve_};
  }

  void start() {
    const SenderState state = sender_->state();
    const bool free = state == SenderState::idle || state == SenderState::done || state == SenderState::aborted;
    if (!free) return;
    reserve_ = choices_.word();
    if (sender_->start(job(session_ + 1), now_)) ++session_;
  }

  void restart_receiver() {
    const modbus::ReceiverMemory memory = receiver_->memory();
    const std::uint16_t blocks = receiver_->status().free_blocks;
    receiver_.emplace(sink_, ++boot_, memory);
    receiver_->set_free_blocks(blocks);
  }

  void restart_sender() {
    if (session_ == 0) return;
    sender_.emplace(settings_);
    static_cast<void>(sender_->resume(job(session_), journaled_boot_, now_));
  }

  // One request, answered or not, its registers whole or not.
  void exchange() {
    const auto request = sender_->next_request(now_);
    if (!request) {
      now_ = std::max(now_, sender_->deadline().value_or(now_));
      return;
    }
    const std::uint32_t fate = choices_.below(10);
    if (fate == 9) return sender_->request_failed(now_);
    if (request->kind == modbus::Request::Kind::read_status) {
      modbus::StatusImage image = receiver_->status_image();
      if (fate == 8) {
        const std::size_t at = choices_.below(static_cast<std::uint32_t>(image.size()));
        image[at] = static_cast<std::uint16_t>(image[at] ^ (1 + choices_.below(255)));
      }
      const std::size_t count = fate == 7 ? choices_.below(static_cast<std::uint32_t>(image.size())) : image.size();
      return sender_->status_read(std::span(image).first(count), now_);
    }
    const std::span<const std::uint16_t> registers = request->registers;
    fuzz::require(registers.size() <= modbus::kMailboxRegisters, "a write fits into the mailbox");
    const std::size_t cut = choices_.below(static_cast<std::uint32_t>(registers.size()) + 1);
    if (fate == 8) receiver_->written(0, registers.first(cut));
    if (fate == 7) receiver_->written(cut, registers.subspan(cut));
    if (fate < 7) receiver_->written(0, registers);
    if (fate == 6) receiver_->written(0, registers);
    if (fate >= 5) return sender_->request_failed(now_);
    sender_->written(now_);
  }

  void require_text() const {
    fuzz::require(text_.starts_with(sink_.text), "the receiver holds the beginning of the text");
    const modbus::SenderCounters counters = sender_->counters();
    fuzz::require(counters.confirmed <= text_.size() && counters.handed <= text_.size(), "no more is counted than is");
    fuzz::require(sender_->state() != SenderState::done || sink_.text == text_, "a sender that is done sent all");
    const auto deadline = sender_->deadline();
    fuzz::require(!deadline || *deadline >= Time{}, "a deadline is a time");
  }

  fuzz::Choices& choices_;
  std::string text_ = whole_text();
  modbus::SenderSettings settings_;
  Text sink_;
  std::optional<modbus::Receiver> receiver_;
  std::optional<modbus::Sender> sender_;
  std::optional<tape_code::SpanSource> source_;
  std::uint32_t session_ = 0;
  std::uint16_t boot_ = 1;
  std::uint16_t journaled_boot_ = 1;
  std::uint64_t reserve_ = 0;
  Time now_ = std::chrono::seconds(1);
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Choices choices(data, size);
  Bus(choices).run();
  return 0;
}

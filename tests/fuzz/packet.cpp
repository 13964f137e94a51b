// A packet sender and a packet receiver under any bytes at any time: the sender sends nothing unasked and nothing
// beyond the ledger's window, never counts more confirmed than handed, and claims `done` only with all of it confirmed;
// the receiver gives its sink no more than came, and answers nothing at rest.
#include "protocol/packet/packet.h"

#include <algorithm>
#include <optional>
#include <string>

#include "tests/fuzz/target.h"

using namespace dripfeed;
using packet::Protocol;
using packet::Time;

namespace {

class Text final : public packet::Sink {
 public:
  std::size_t room() const noexcept override { return space; }
  void append(std::span<const std::byte> bytes) noexcept override { taken += bytes.size(); }
  std::size_t space = packet::kMaxPayload;
  std::uint64_t taken = 0;
};

std::string whole_text() {
  std::string text = "%\nO1\n";
  for (int i = 0; i < 300; ++i) text += "G1X" + std::to_string(i) + ".\n";
  return text + "M30\n%\n";
}

feed::ProgramFacts facts_of(const std::string& text) {
  feed::ProgramCheck check(feed::kParenthesesSyntax);
  check.append(text);
  return *check.finish();
}

// Bytes that the protocols know, more often than others.
std::byte likely_byte(fuzz::Choices& choices) {
  constexpr std::string_view kKnown(
      "\x01\x02\x03\x04\x06\x10\x15\x18\x1A"
      "CRSYNGTDAL\r",
      20);
  const std::uint32_t pick = choices.below(2 * kKnown.size());
  return pick < kKnown.size() ? static_cast<std::byte>(kKnown[pick]) : static_cast<std::byte>(choices.byte());
}

packet::Settings settings_of(fuzz::Choices& choices) {
  packet::Settings settings{.protocol = static_cast<Protocol>(choices.below(packet::kProtocols))};
  if (choices.flag()) settings.answer_patience = std::chrono::seconds(5);
  settings.counted = choices.flag();
  settings.yields_on_collision = choices.flag();
  settings.end_is_cr = choices.flag();
  return settings;
}

void run_sender(const packet::Settings& settings, fuzz::Choices& choices) {
  auto sender = packet::Sender::make(settings);
  const std::string text = whole_text();
  tape_code::SpanSource source(text);
  Time now{1'000'000'000};
  std::uint64_t reserve = choices.word();
  sender->link(true, now);
  static_cast<void>(sender->arm({.facts = facts_of(text), .source = &source, .reserve = reserve}, now));
  while (!choices.done()) {
    switch (choices.below(6)) {
      case 0: now += std::chrono::milliseconds(choices.word()); break;
      case 1:
        reserve = std::max<std::uint64_t>(reserve, choices.word());
        sender->extend_reserve(reserve, now);
        break;
      case 2:
        if (choices.below(8) == 0)
          static_cast<void>(sender->command(static_cast<feed::Command>(choices.below(7)), now));
        break;
      case 3:
        if (choices.below(16) == 0) sender->link(choices.flag(), now);
        break;
      default: {
        const std::byte byte = likely_byte(choices);
        sender->receive({&byte, 1}, now);
      }
    }
    sender->tick(now);
    const auto out = sender->pending_out();
    if (!out.empty()) sender->mark_sent(1 + choices.below(static_cast<std::uint32_t>(out.size())), now);
    const packet::Counters counters = sender->counters();
    fuzz::require(counters.handed <= reserve, "no text beyond the ledger's window");
    fuzz::require(counters.clocked <= counters.handed && counters.confirmed <= counters.clocked, "counters in order");
    fuzz::require(sender->state() != packet::State::armed || counters.handed == 0, "nothing before the start");
    fuzz::require(sender->state() != packet::State::done || counters.confirmed == sender->total_bytes(),
                  "done with all of it confirmed");
    // The remote buffer's host answers a reset, without text; of XMODEM a person's abort is reported, by CANs.
    const bool takes_leave =
        packet::is_xmodem(settings.protocol) &&
        std::ranges::all_of(sender->pending_out(), [](std::byte b) { return b == std::byte{0x18}; });
    const bool silent = settings.protocol == Protocol::remote_buffer_a || takes_leave || sender->pending_out().empty();
    fuzz::require(sender->state() != packet::State::torn || silent, "nothing on a torn line");
  }
}

void run_receiver(const packet::Settings& settings, fuzz::Choices& choices) {
  Text sink;
  auto receiver = packet::Receiver::make(settings, sink);
  Time now{1'000'000'000};
  std::uint64_t came = 0;
  receiver->link(true, now);
  static_cast<void>(receiver->start(now));
  while (!choices.done()) {
    switch (choices.below(5)) {
      case 0: now += std::chrono::milliseconds(choices.word()); break;
      case 1: sink.space = choices.flag() ? packet::kMaxPayload : 0; break;
      case 2:
        if (choices.below(16) == 0) static_cast<void>(choices.flag() ? receiver->stop(now) : receiver->start(now));
        break;
      default: {
        const std::byte byte = likely_byte(choices);
        receiver->receive({&byte, 1}, now);
        ++came;
      }
    }
    receiver->tick(now);
    receiver->mark_sent(receiver->pending_out().size(), now);
    fuzz::require(sink.taken <= came, "no more text than came");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Choices choices(data, size);
  const packet::Settings settings = settings_of(choices);
  if (!packet::validate(settings)) return 0;
  choices.flag() ? run_sender(settings, choices) : run_receiver(settings, choices);
  return 0;
}

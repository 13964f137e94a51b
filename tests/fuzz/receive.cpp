// A receiver under any bytes, pauses and commands. However they come, the bytes of a reception add up, the machine
// sends nothing but DC3 and DC1 of its hold, what it calls whole reads as text, and names and requests can be looked
// for.
#include <vector>

#include "protocol/receive/program_name.h"
#include "protocol/receive/request.h"
#include "protocol/receive/transfer.h"
#include "tests/fuzz/target.h"

using namespace dripfeed;

namespace {

void look_at(const receive::Transfer& transfer) {
  for (const char c : transfer.text) {
    fuzz::require(
        transfer.fault != receive::Fault::none || c == '\n' || c == '\t' || static_cast<std::uint8_t>(c) >= 0x20,
        "a whole text holds no control characters");
  }
  if (transfer.fault == receive::Fault::none) {
    fuzz::require(transfer.text.ends_with('\n') && transfer.parity_errors == 0, "a whole text has its last EOB");
  }
  static_cast<void>(receive::find_name(transfer.text));
  const auto request = receive::find_request(transfer.text, {.program_number = 0});
  fuzz::require(!request || !request->legal || request->argument.find("..") == std::string::npos,
                "a legal name stays inside");
  std::size_t all = 0;
  for (const std::string& part : receive::split_programs(transfer.text)) all += part.size();
  fuzz::require(all >= transfer.text.size() || transfer.text.size() - all < 64 || transfer.text.starts_with("%\n"),
                "parts hold the text");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Choices choices(data, size);
  receive::Settings settings;
  const std::uint32_t kind = choices.below(16);
  settings.eighth_bit = static_cast<tape_code::EighthBit>(kind % 4);
  settings.find_code = (kind & 4U) != 0;
  settings.flow_below = (kind & 8U) != 0;
  settings.hold = static_cast<receive::Hold>(choices.below(3));
  if (choices.flag()) settings.end_character = 0x04;
  settings.max_bytes = 16 + choices.word();
  receive::Receiver receiver(settings);
  std::vector<std::byte> raw;
  receive::Time now{1};
  const auto take = [&] {
    raw.insert(raw.end(), receiver.kept().begin(), receiver.kept().end());
    receiver.mark_taken();
    for (const std::byte out : receiver.pending_out()) {
      const auto sign = std::to_integer<unsigned>(out) & 0x7FU;
      fuzz::require(sign == 0x11 || sign == 0x13, "only DC1 and DC3 go out");
      fuzz::require(settings.hold == receive::Hold::dc3, "nothing goes out without the hold");
    }
    if (choices.flag()) receiver.mark_sent(receiver.pending_out().size());
    const auto ended = receiver.ended();
    if (!ended) return;
    fuzz::require(ended->bytes == raw.size(), "the bytes of a reception add up");
    fuzz::require(raw.size() <= settings.max_bytes + 1, "the limit holds");
    look_at(receive::judge(raw, *ended, settings));
    raw.clear();
  };
  while (!choices.done()) {
    switch (choices.below(6)) {
      case 0: now += std::chrono::milliseconds(choices.word()); break;
      case 1: receiver.can_take(choices.flag(), now); break;
      case 2: receiver.link_lost(now); break;
      default: {
        const std::string_view text = choices.text(1 + choices.byte());
        std::span<const std::byte> bytes = std::as_bytes(std::span(text.data(), text.size()));
        while (!bytes.empty()) {
          bytes = bytes.subspan(receiver.receive(bytes, now));
          take();
        }
      }
    }
    receiver.tick(now);
    take();
    const auto deadline = receiver.deadline();
    fuzz::require(!deadline || *deadline > now, "what is due is done");
  }
  return 0;
}

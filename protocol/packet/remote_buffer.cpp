// The messages of the remote buffer: writing, and finding them in a stream of bytes.
#include "protocol/packet/remote_buffer.h"

#include <algorithm>
#include <utility>

#include "protocol/packet/check_sums.h"
#include "protocol/tape_code/parity.h"

namespace dripfeed::packet::remote_buffer {
namespace {

constexpr std::array<std::string_view, 17> kLetters = {"SYN", "RDY", "RST", "ARS", "ALM", "AAL", "SAT", "SET", "GTD",
                                                       "DAT", "WAT", "EOD", "CLB", "RDI", "SDI", "SDO", "RTY"};

char hex_digit(unsigned value) { return static_cast<char>(value < 10 ? '0' + value : 'A' + value - 10); }

std::byte coded(const Form& form, char character) {
  return std::byte{tape_code::with_parity(static_cast<std::uint8_t>(character), form.eighth_bit)};
}

char plain(const Form& form, std::byte byte) {
  return static_cast<char>(tape_code::without_parity(static_cast<std::uint8_t>(byte), form.eighth_bit));
}

}  // namespace

Form form_of(const Settings& settings) {
  return {.end = settings.end_is_cr ? kCr : kEtx, .eighth_bit = settings.wire.eighth_bit};
}

std::size_t compose(const Form& form, Command command, std::span<const std::byte> data, std::span<std::byte> out) {
  const std::string_view letters = kLetters[static_cast<std::size_t>(command)];
  for (std::size_t i = 0; i < letters.size(); ++i) out[2 + i] = coded(form, letters[i]);
  std::ranges::copy(data, out.subspan(kHead).begin());
  const std::size_t size = kHead + data.size() + 1;
  out[size - 1] = coded(form, static_cast<char>(form.end));
  const std::uint8_t sum = sum8(out.subspan(2, size - 2));
  out[0] = coded(form, hex_digit(sum >> 4U));
  out[1] = coded(form, hex_digit(sum & 0xFU));
  return size;
}

Reader::Found Reader::put(std::uint8_t byte) {
  const bool is_end = plain(form_, std::byte{byte}) == static_cast<char>(form_.end);
  if (size_ == bytes_.size()) {
    overlong_ = true;
  } else {
    bytes_[size_++] = std::byte{byte};
  }
  if (!is_end) return Found::nothing;
  const auto whole = std::span<const std::byte>(bytes_).first(size_);
  size_ = 0;
  if (std::exchange(overlong_, false) || whole.size() < kHead + 1) return Found::damaged;
  const std::uint8_t sum = sum8(whole.subspan(2));
  const bool holds = plain(form_, whole[0]) == hex_digit(sum >> 4U) && plain(form_, whole[1]) == hex_digit(sum & 0xFU);
  if (!holds) return Found::damaged;
  const std::array<char, 3> letters{plain(form_, whole[2]), plain(form_, whole[3]), plain(form_, whole[4])};
  const auto found = std::ranges::find(kLetters, std::string_view(letters.data(), letters.size()));
  if (found == kLetters.end()) return Found::damaged;
  message_ = {.command = static_cast<Command>(found - kLetters.begin()),
              .data = whole.subspan(kHead, whole.size() - kHead - 1)};
  return Found::message;
}

}  // namespace dripfeed::packet::remote_buffer

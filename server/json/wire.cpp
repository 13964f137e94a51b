// A run is what passed in one direction without a pause, up to the end of a block. Its text has one character for each
// byte; what cannot be seen has the picture that Unicode has for it (␀ to ␡).
#include "server/json/wire.h"

#include <chrono>

#include <fmt/format.h>

namespace dripfeed::json {

namespace {

using app::WireKind;
using app::WireTap;

constexpr feed::Time kPause = std::chrono::milliseconds(100);
constexpr std::size_t kLongest = 200;  // characters of a run

bool is_character(WireKind kind) { return kind == WireKind::in || kind == WireKind::out; }

void append_utf8(std::string& out, char32_t character) {
  if (character < 0x80) {
    out += static_cast<char>(character);
  } else if (character < 0x800) {
    out += static_cast<char>(0xC0 | (character >> 6));
    out += static_cast<char>(0x80 | (character & 0x3F));
  } else {
    out += static_cast<char>(0xE0 | (character >> 12));
    out += static_cast<char>(0x80 | ((character >> 6) & 0x3F));
    out += static_cast<char>(0x80 | (character & 0x3F));
  }
}

// U+2400 on: pictures of the control characters; U+FFFD: no character.
char32_t shown(std::uint8_t character) {
  constexpr std::uint8_t kDelete = 0x7F;
  if (character < ' ') return 0x2400 + character;
  if (character == kDelete) return 0x2421;
  return character >= 0x80 && character < 0xA0 ? 0xFFFD : character;
}

// DC1 to DC4 are no characters of EIA, and controls send them on such lines as they are.
constexpr bool is_device_control(std::uint8_t byte) { return byte >= 0x11 && byte <= 0x14; }

void take(WireRun& run, const WireTap::Entry& entry, const tape_code::DecodeTable& code) {
  run.to = entry.at;
  if (!is_character(entry.kind)) return;
  ++run.count;
  run.hex += fmt::format("{:02X}", entry.byte);
  if (entry.kind == WireKind::in && is_device_control(entry.byte)) return append_utf8(run.text, shown(entry.byte));
  const tape_code::ByteKind kind = code.kind(entry.byte);
  const bool is_none = kind == tape_code::ByteKind::wrong_nothing;
  if (is_none || kind == tape_code::ByteKind::wrong) ++run.wrong;
  const auto character = static_cast<std::uint8_t>(code.character(entry.byte));
  append_utf8(run.text, is_none ? char32_t{0xFFFD} : shown(character));
  run.is_over = character == '\n' && !is_none;
}

bool goes_on(const WireRun& run, const WireTap::Entry& entry) {
  return is_character(run.kind) && run.kind == entry.kind && !run.is_over && run.count < kLongest &&
         entry.at - run.to < kPause;
}

}  // namespace

std::vector<WireRun> wire_runs(const WireTap::Batch& batch, const tape_code::DecodeTable& code) {
  std::vector<WireRun> runs;
  for (const WireTap::Entry& entry : batch.entries) {
    if (runs.empty() || !goes_on(runs.back(), entry))
      runs.push_back({.kind = entry.kind, .from = entry.at, .to = entry.at});
    take(runs.back(), entry, code);
  }
  return runs;
}

}  // namespace dripfeed::json

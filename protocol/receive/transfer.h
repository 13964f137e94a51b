// What a reception is worth: its code, its text with LF as EOB, and whether it is whole. A broken one keeps its bytes
// as they came; what becomes of them is the caller's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "protocol/receive/receiver.h"
#include "protocol/tape_code/wire_decoder.h"

namespace dripfeed::receive {

enum class Fault : std::uint8_t {
  none,
  empty,        // no character of a text
  device_text,  // a device server's own words: no program at all
  too_long,
  link_lost,
  parity,
  binary,
  interrupted,  // the control was reset or began to read before the end
  no_start,     // a final '%' and no first one
  no_end,       // no final '%', or no DC4 after DC2
  flow_taken,   // EIA through XON/XOFF below us: its 3 is DC3, and none arrived
};
std::string_view name(Fault fault);
std::string_view message(Fault fault);

enum class TextCode : std::uint8_t { ascii, iso, eia };
std::string_view name(TextCode code);
std::optional<TextCode> text_code(std::string_view name);

struct Transfer {
  Fault fault = Fault::none;
  TextCode code = TextCode::ascii;
  std::string text;  // as far as it can be read
  std::uint64_t parity_errors = 0;
  std::optional<tape_code::ParityError> first_parity_error;
  std::string_view device;  // for device_text: what it says
};

// `raw`: all that Receiver::kept() gave of this reception.
Transfer judge(std::span<const std::byte> raw, const Ending& ending, const Settings& settings);

// The text of bytes whose code a person or an earlier judgement knows, as far as it can be read.
std::string read_as(TextCode code, std::span<const std::byte> raw, const Settings& settings);

// What a terminal or device server says in the place of a control ("Port already in use", "Connection refused", …); ""
// when the text is no such sentence. Sources: ser2net 4.3, Moxa NPort, Lantronix and Digi manuals, telnet clients.
std::string_view device_text(std::string_view text);

}  // namespace dripfeed::receive

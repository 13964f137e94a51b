// The code of a reception is found from its bytes, because a person's terminal has none of the parity that the line's
// control has. Then it is read by the code's rules and compared with start and end.
#include "protocol/receive/transfer.h"

#include <array>

#include "protocol/tape_code/auto_decoder.h"
#include "protocol/tape_code/eob.h"
#include "protocol/tape_code/parity.h"

namespace dripfeed::receive {
namespace {

using tape_code::EighthBit;

constexpr char kNul = '\0';
constexpr char kDel = '\x7F';
constexpr std::size_t kShortestText = 4;

struct FaultRow {
  std::string_view name;
  std::string_view message;
};
constexpr std::array<FaultRow, 11> kFaults{{
    {"", "it is whole"},
    {"empty", "nothing but leader came"},
    {"device", "the device server spoke, not the control"},
    {"too_long", "it is longer than the limit"},
    {"link_lost", "the link was lost inside it"},
    {"parity", "characters have wrong parity"},
    {"binary", "it holds characters that no program has"},
    {"interrupted", "the control was reset or began to read before the end"},
    {"no_start", "it has a final % and no first one"},
    {"no_end", "its end is missing"},
    {"flow_taken", "EIA came through XON/XOFF below us, which takes every 3 (13h) out of it"},
}};
constexpr std::array<std::string_view, 3> kCodes{"ascii", "iso", "eia"};

struct Census {
  std::uint64_t all = 0;
  std::uint64_t high = 0;  // with bit 7
  std::uint64_t odd = 0;   // with an odd number of ones
};

Census count(std::span<const std::byte> raw) {
  Census census;
  for (const std::byte raw_byte : raw) {
    const auto byte = std::to_integer<std::uint8_t>(raw_byte);
    ++census.all;
    if ((byte & tape_code::kTopBit) != 0) ++census.high;
    if (tape_code::odd_ones(byte)) ++census.odd;
  }
  return census;
}

// What bit 7 carries in truth. Text without any bit 7 carries none. On a line of 8 data bits ISO shows by its parity:
// about half of its characters have bit 7, and all but damaged ones are even.
EighthBit bit_seven(const Census& census, EighthBit line) {
  if (line == EighthBit::clear || census.high == 0) return EighthBit::clear;
  if (line != EighthBit::data) return line;
  const bool iso = census.high * 4 >= census.all && census.odd * 10 <= census.all;
  return iso ? EighthBit::even : EighthBit::data;
}

bool is_text(char c) {
  const auto byte = static_cast<std::uint8_t>(c);
  return byte >= 0x20 || c == '\n' || c == '\t';
}

struct Marks {
  bool begins_bare = false;   // the first line is '%' alone
  bool begins_named = false;  // ... or '%NAME', '$NAME', or there is no '%' at all
  bool ends_closed = false;   // the last line is '%' alone, and not the first
};

std::string_view line_at(std::string_view text, std::size_t begin) {
  std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
  while (!line.empty() && line.back() == ' ') line.remove_suffix(1);
  return line;
}

Marks marks_of(std::string_view text) {
  Marks marks;
  const std::size_t first = text.find_first_not_of("\n ");
  const std::size_t last = text.find_last_not_of("\n ");
  if (first == std::string_view::npos) return marks;
  const std::string_view begin = line_at(text, first);
  marks.begins_bare = begin == "%";
  const bool header = begin.front() == '%' || begin.front() == '$';
  marks.begins_named = (header && !marks.begins_bare) || text.find('%') == std::string_view::npos;
  const bool own_line = last > first && (text[last - 1] == '\n');
  marks.ends_closed = text[last] == '%' && own_line;
  return marks;
}

bool broke_off(EndedBy by) { return by == EndedBy::reader_on || by == EndedBy::reset || by == EndedBy::renewed; }

Fault fault_of(const Transfer& transfer, const Ending& ending, bool binary, bool has_eob) {
  if (ending.by == EndedBy::too_long) return Fault::too_long;
  const Marks marks = marks_of(transfer.text);
  const bool closed = marks.ends_closed && (marks.begins_bare || marks.begins_named);
  if (ending.by == EndedBy::link_lost && !closed) return Fault::link_lost;
  if (transfer.parity_errors > 0) return Fault::parity;
  if (binary) return Fault::binary;
  if (closed) return Fault::none;
  if (broke_off(ending.by)) return Fault::interrupted;
  if (marks.begins_bare) return Fault::no_end;
  if (!marks.begins_named) return Fault::no_start;
  const bool no_sign = ending.punch_signs && ending.by == EndedBy::quiet;
  return no_sign || !has_eob ? Fault::no_end : Fault::none;
}

// EIA by its own table; a blank inside is an error there. True where there is one.
bool read_eia(std::span<const std::byte> raw, const Settings& settings, Transfer& transfer) {
  tape_code::WireDecoder decoder(tape_code::DecodeFormat{
      .eighth_bit = EighthBit::data, .eia = settings.eia_specials, .label = tape_code::Label::keep});
  decoder.decode(raw, transfer.text);
  decoder.finish(transfer.text);
  transfer.parity_errors = decoder.parity_errors();
  transfer.first_parity_error = decoder.first_parity_error();
  return decoder.blanks_inside() > 0;
}

// The text without what surrounds it, and the verdict.
void finish(Transfer& transfer, const Ending& ending, bool binary) {
  transfer.text.erase(0, transfer.text.find_first_not_of("\n "));
  const std::size_t last = transfer.text.find_last_not_of("\n ");
  if (last == std::string::npos) {
    transfer.text.clear();
    transfer.fault = ending.by == EndedBy::too_long ? Fault::too_long : Fault::empty;
    return;
  }
  const bool has_eob = transfer.text.find('\n', last) != std::string::npos || transfer.text.find('\n') < last;
  transfer.text.resize(last + 1);
  // Noise on an open cable: a few characters that end no block.
  if (!has_eob && transfer.text.size() < kShortestText && transfer.text.find('%') == std::string::npos) {
    transfer.fault = Fault::empty;
    return;
  }
  transfer.text += '\n';
  transfer.device = device_text(transfer.text);
  transfer.fault = transfer.device.empty() ? fault_of(transfer, ending, binary, has_eob) : Fault::device_text;
}

// The characters of ISO or ASCII. True where one of them is none of a text.
bool read_iso(std::span<const std::byte> raw, EighthBit eighth, Transfer& transfer) {
  tape_code::EobReader eobs;
  bool binary = false;
  std::uint64_t offset = 0;
  for (const std::byte raw_byte : raw) {
    const auto byte = std::to_integer<std::uint8_t>(raw_byte);
    if (!parity_holds(byte, eighth)) {
      ++transfer.parity_errors;
      if (!transfer.first_parity_error) transfer.first_parity_error = {.wire_offset = offset, .byte = byte};
    }
    ++offset;
    const auto character = static_cast<char>(without_parity(byte, eighth));
    if (character == kNul || character == kDel) continue;
    eobs.put(character, transfer.text);
    binary = binary || (!is_text(character) && character != '\r');
  }
  eobs.finish(transfer.text);
  return binary;
}

// The code by the first EOB and the parity of what stands before it.
TextCode found_code(std::span<const std::byte> raw, const Settings& settings) {
  static constexpr std::array kFound = {TextCode::ascii, TextCode::iso, TextCode::eia};
  tape_code::AutoDecoder decoder(tape_code::DecodeFormat{.eia = settings.eia_specials});
  std::string text;
  decoder.decode(raw, text);
  decoder.finish(text);
  return kFound[static_cast<std::size_t>(*decoder.code())];
}

TextCode code_of(std::span<const std::byte> raw, const Ending& ending, const Settings& settings) {
  if (settings.find_code && !settings.eia_known) return found_code(raw, settings);
  if (ending.eia) return TextCode::eia;
  return bit_seven(count(raw), settings.eighth_bit) == EighthBit::even ? TextCode::iso : TextCode::ascii;
}

// Bit 7 of a text that is not EIA. Where the code was looked for it alone says so, not the line.
EighthBit eighth_of(TextCode code, std::span<const std::byte> raw, const Settings& settings) {
  if (settings.find_code) return code == TextCode::iso ? EighthBit::even : EighthBit::data;
  return bit_seven(count(raw), settings.eighth_bit);
}

}  // namespace

std::string_view name(Fault fault) { return kFaults[static_cast<std::size_t>(fault)].name; }
std::string_view message(Fault fault) { return kFaults[static_cast<std::size_t>(fault)].message; }
std::string_view name(TextCode code) { return kCodes[static_cast<std::size_t>(code)]; }

std::optional<TextCode> text_code(std::string_view name) {
  for (std::size_t i = 0; i < kCodes.size(); ++i) {
    if (kCodes[i] == name) return static_cast<TextCode>(i);
  }
  return std::nullopt;
}

Transfer judge(std::span<const std::byte> raw, const Ending& ending, const Settings& settings) {
  Transfer transfer;
  transfer.code = code_of(raw, ending, settings);
  const bool eia = transfer.code == TextCode::eia;
  const bool binary =
      eia ? read_eia(raw, settings, transfer) : read_iso(raw, eighth_of(transfer.code, raw, settings), transfer);
  finish(transfer, ending, binary);
  if (eia && settings.flow_below && transfer.fault == Fault::none) transfer.fault = Fault::flow_taken;
  return transfer;
}

std::string read_as(TextCode code, std::span<const std::byte> raw, const Settings& settings) {
  Transfer transfer;
  if (code == TextCode::eia) {
    read_eia(raw, settings, transfer);
  } else {
    read_iso(raw, code == TextCode::iso ? EighthBit::even : bit_seven(count(raw), settings.eighth_bit), transfer);
  }
  return std::move(transfer.text);
}

}  // namespace dripfeed::receive

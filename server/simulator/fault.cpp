// The table of faults, and what the line's do to a character.
#include "server/simulator/fault.h"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

namespace dripfeed::simulator {

namespace {

constexpr std::array<FaultRow, 22> kRows{{
    {FaultKind::cut, "cut", "the cable is cut after N characters"},
    {FaultKind::unplug, "unplug", "the cable is out for two seconds after N characters"},
    {FaultKind::half_open, "half-open", "after N characters the peer takes and sends nothing, its connection stays"},
    {FaultKind::lose, "lose", "character N to the control is lost"},
    {FaultKind::lose_out, "lose-out", "character N from the control is lost"},
    {FaultKind::flip, "flip", "one bit of character N to the control is flipped"},
    {FaultKind::parity, "parity", "the parity bit of character N to the control is flipped"},
    {FaultKind::noise, "noise", "each character to the control has a flipped bit with a chance of N in a million"},
    {FaultKind::late_xoff, "late-xoff", "the control sends each DC3 N characters too late"},
    {FaultKind::overrun, "overrun", "the control has a buffer overflow at character N"},
    {FaultKind::silent, "silent", "after N characters the control runs and sends nothing more"},
    {FaultKind::reset, "reset", "the control is reset at character N: DC3, SYN"},
    {FaultKind::alarm, "alarm", "the control has an alarm at character N: DC3, NAK"},
    {FaultKind::slow, "slow", "the control runs N times slower"},
    {FaultKind::baud, "baud", "the control's line is set to N baud"},
    {FaultKind::dsr, "dsr", "the control's DTR drops at character N"},
    {FaultKind::tv, "tv", "N = 1: the control checks that each block has an even number of characters"},
    {FaultKind::plc_lose, "plc-lose", "the PLC gets nothing of each Nth request"},
    {FaultKind::plc_silent, "plc-silent", "the PLC carries out each Nth request and does not answer"},
    {FaultKind::plc_busy, "plc-busy", "the PLC is busy (exception 6) at each Nth request"},
    {FaultKind::plc_damage, "plc-damage",
     "each Nth answer of the PLC has a wrong check sum (RTU) or transaction (TCP)"},
    {FaultKind::plc_restart, "plc-restart", "the PLC is restarted at request N; it keeps its text"},
}};

constexpr bool rows_in_order() {
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (static_cast<std::size_t>(kRows[i].kind) != i) return false;
  }
  return true;
}
static_assert(rows_in_order());

constexpr std::byte kTopBit{0x80};
constexpr std::uint32_t kMillion = 1'000'000;

}  // namespace

std::span<const FaultRow> fault_table() { return kRows; }
std::string_view name_of(FaultKind kind) { return kRows[static_cast<std::size_t>(kind)].name; }

std::expected<Fault, std::string> parse_fault(std::string_view text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = text.substr(0, equals);
  const std::string_view value = text.substr(std::min(equals + 1, text.size()));
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  const bool is_number = error == std::errc{} && end == value.data() + value.size();
  std::string known;
  for (const FaultRow& row : kRows) {
    if (row.name == name && is_number) return Fault{row.kind, number};
    known += fmt::format("\n  {}=N  {}", row.name, row.meaning);
  }
  return std::unexpected(fmt::format("--fault \"{}\" is none of:{}", text, known));
}

std::optional<std::uint64_t> find_fault(const Faults& faults, FaultKind kind) {
  for (const Fault& fault : faults) {
    if (fault.kind == kind) return fault.number;
  }
  return std::nullopt;
}

void LineFaults::to_control(std::vector<std::byte>& bytes) {
  if (faults_.empty()) return;
  std::vector<std::byte> arrived;
  for (std::byte byte : bytes) {
    ++in_;
    bool lost = false;
    for (const Fault& fault : faults_) {
      const bool here = fault.number == in_;
      const std::byte bit{static_cast<std::uint8_t>(1U << (random_() % 8))};
      if (fault.kind == FaultKind::lose && here) lost = true;
      if (fault.kind == FaultKind::flip && here) byte ^= bit;
      if (fault.kind == FaultKind::parity && here) byte ^= kTopBit;
      if (fault.kind == FaultKind::noise && random_() % kMillion < fault.number) byte ^= bit;
    }
    if (!lost) arrived.push_back(byte);
  }
  bytes = std::move(arrived);
}

void LineFaults::to_host(std::vector<std::byte>& bytes) {
  std::vector<std::byte> sent;
  for (const std::byte byte : bytes) {
    ++out_;
    const bool lost = std::ranges::any_of(
        faults_, [&](const Fault& fault) { return fault.kind == FaultKind::lose_out && fault.number == out_; });
    if (!lost) sent.push_back(byte);
  }
  bytes = std::move(sent);
}

}  // namespace dripfeed::simulator

// One picture of a machine's line for each request: words of one answer belong together.
#include "server/app/out/status_registers.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace dripfeed::app {

namespace {

constexpr std::uint16_t kNoLine = 0xFFFF;
constexpr std::uint16_t kOtherStall = 255;
constexpr std::size_t kNameAt = 21;
constexpr std::array<std::string_view, 15> kStalls = {
    "",
    "waiting for DC1",
    "held by DC3",
    "CTS off",
    "peer gone",
    "waiting for ledger",
    "waiting for text",
    "waiting for end",
    "stopped",
    "waiting for credit",
    "waiting for receiver",
    "stopped by a fault",
    "machine held",
    "machine alarm",
    "machine in emergency stop",
};

using Registers = std::array<std::uint16_t, StatusRegisters::kCount>;

std::uint16_t stall_code(std::string_view stall) {
  const auto known = std::ranges::find(kStalls, stall);
  return known == kStalls.end() ? kOtherStall : static_cast<std::uint16_t>(known - kStalls.begin());
}

// Values beyond 32 bits stay at the top.
void put_32(Registers& registers, std::size_t at, std::uint64_t value) {
  const auto shown = static_cast<std::uint32_t>(std::min<std::uint64_t>(value, UINT32_MAX));
  registers[at] = static_cast<std::uint16_t>(shown >> 16U);
  registers[at + 1] = static_cast<std::uint16_t>(shown & 0xFFFFU);
}

void put_report(Registers& registers, const LineReport& report) {
  registers[3] = static_cast<std::uint16_t>(report.state);
  registers[4] = stall_code(report.stall);
  registers[5] = static_cast<std::uint16_t>(report.end);
  put_32(registers, 6, report.job);
  put_32(registers, 8, report.total);
  put_32(registers, 10, report.handed);
  put_32(registers, 12, report.clocked);
  put_32(registers, 14, report.confirmed);
  put_32(registers, 16, report.known.from_line);
  put_32(registers, 18, report.known.to_line);
  const unsigned flags = (report.confirms ? 1U : 0U) | (report.estimated ? 2U : 0U) | (report.stop_wanted ? 4U : 0U) |
                         (report.link_error.empty() ? 0U : 8U);
  registers[20] = static_cast<std::uint16_t>(flags);
}

void put_name(Registers& registers, const std::string& name) {
  for (std::size_t i = 0; i < name.size() && kNameAt + i / 2 < registers.size(); ++i) {
    const auto character = static_cast<std::uint8_t>(name[i]);
    registers[kNameAt + i / 2] |= static_cast<std::uint16_t>(i % 2 == 0 ? character << 8U : character);
  }
}

}  // namespace

bool StatusRegisters::read(std::uint8_t unit, std::uint16_t first, std::span<std::uint16_t> into) {
  const auto machine = machines_.find(unit);
  if (machine == machines_.end() || first + into.size() > kCount) return false;
  Registers registers{};
  registers[0] = kMagic;
  registers[1] = kVersion;
  registers[2] = static_cast<std::uint16_t>(std::chrono::duration_cast<std::chrono::seconds>(clock_.now()).count());
  registers[3] = kNoLine;
  for (const Progress& progress : events_.snapshot()) {
    if (progress.machine == machine->second) put_report(registers, progress.report);
  }
  put_name(registers, machine->second);
  std::copy_n(registers.begin() + first, into.size(), into.begin());
  return true;
}

}  // namespace dripfeed::app

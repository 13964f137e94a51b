// What can go wrong on purpose, as a table: faults of the line, which strike any kind of control, and faults of the
// control itself, and those of a PLC. `--fault NAME=N`; the same numbers and seed give the same run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::simulator {

enum class FaultKind : std::uint8_t {
  // of the line
  cut,
  unplug,
  half_open,
  lose,
  lose_out,
  flip,
  parity,
  noise,
  // of the control
  late_xoff,
  overrun,
  silent,
  reset,
  alarm,
  slow,
  baud,
  dsr,
  tv,
  // of a PLC
  plc_lose,
  plc_silent,
  plc_busy,
  plc_damage,
  plc_restart,
};

struct Fault {
  FaultKind kind = FaultKind::cut;
  std::uint64_t number = 0;  // what it counts: see the table
};

struct FaultRow {
  FaultKind kind;
  std::string_view name;
  std::string_view meaning;  // of N
};
std::span<const FaultRow> fault_table();
std::string_view name_of(FaultKind kind);

// "lose=100"; or one sentence that lists the names.
std::expected<Fault, std::string> parse_fault(std::string_view text);

using Faults = std::vector<Fault>;
std::optional<std::uint64_t> find_fault(const Faults& faults, FaultKind kind);

// The faults that strike characters in transit, in both directions. Not those that end the link.
class LineFaults {
 public:
  LineFaults(Faults faults, std::uint32_t seed) : faults_(std::move(faults)), random_(seed) {}
  void to_control(std::vector<std::byte>& bytes);
  void to_host(std::vector<std::byte>& bytes);

 private:
  Faults faults_;
  std::mt19937 random_;
  std::uint64_t in_ = 0;
  std::uint64_t out_ = 0;
};

}  // namespace dripfeed::simulator

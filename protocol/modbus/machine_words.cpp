// The machine's words: encoding, decoding, and the probe for them.
#include "protocol/modbus/machine_words.h"

namespace dripfeed::modbus {
namespace {

// Places in M; the map is in modbus.h.
constexpr std::size_t kState = 1;
constexpr std::size_t kProgram = 2;
constexpr std::size_t kLine = 4;
constexpr std::size_t kAlarm = 6;
constexpr std::size_t kBell = 8;
constexpr std::size_t kRequest = 9;
constexpr std::size_t kRequested = 10;
constexpr std::size_t kCrc = 12;

constexpr std::array<std::string_view, 7> kStateNames{"unknown", "idle",           "running", "held",
                                                      "alarm",   "emergency stop", "manual"};

void put_32(MachineImage& registers, std::size_t at, std::uint32_t value) {
  registers[at] = static_cast<std::uint16_t>(value >> 16U);
  registers[at + 1] = static_cast<std::uint16_t>(value & 0xFFFFU);
}

std::uint32_t get_32(std::span<const std::uint16_t> registers, std::size_t at) {
  return (std::uint32_t{registers[at]} << 16U) | registers[at + 1];
}

}  // namespace

std::string_view name(MachineState state) { return kStateNames[static_cast<std::size_t>(state)]; }

void encode(const MachineWords& words, MachineImage& out) {
  out[0] = kMachineMagic;
  out[kState] = static_cast<std::uint16_t>(words.state);
  put_32(out, kProgram, words.program);
  put_32(out, kLine, words.line);
  put_32(out, kAlarm, words.alarm);
  out[kBell] = words.bell;
  out[kRequest] = words.request;
  put_32(out, kRequested, words.requested);
  put_32(out, kCrc, crc32(0, std::span<const std::uint16_t>(out).first(kCrc)));
}

std::expected<MachineWords, MachineFault> decode_machine(std::span<const std::uint16_t> registers) {
  if (registers.size() < kMachineRegisters || registers[0] != kMachineMagic) {
    return std::unexpected(MachineFault::absent);
  }
  if (get_32(registers, kCrc) != crc32(0, registers.first(kCrc))) return std::unexpected(MachineFault::garbled);
  const bool known = registers[kState] < kStateNames.size();
  return MachineWords{.state = known ? static_cast<MachineState>(registers[kState]) : MachineState::unknown,
                      .program = get_32(registers, kProgram),
                      .line = get_32(registers, kLine),
                      .alarm = get_32(registers, kAlarm),
                      .bell = registers[kBell],
                      .request = registers[kRequest],
                      .requested = get_32(registers, kRequested)};
}

void WordsProbe::answered() {
  failures_ = 0;
  if (reads_all_) {
    proved_ = true;
    doubts_ = 0;
  } else if (!absent()) {
    ++doubts_;
    reads_all_ = !absent();
  }
}

// Long and short take turns until one of them is answered; what was proved is doubted after two failures only.
void WordsProbe::failed() {
  ++failures_;
  if (absent() || (proved_ && failures_ < kDoubts)) return;
  proved_ = false;
  reads_all_ = !reads_all_;
}

void WordsProbe::ask_again() {
  if (!absent()) return;
  doubts_ = kDoubts - 1;
  reads_all_ = true;
}

}  // namespace dripfeed::modbus

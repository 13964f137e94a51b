// The numbers of the Telnet protocol (RFC 854, 855), of the options used here, and of the COM-PORT option (RFC 2217,
// section 3).
#pragma once

#include <chrono>
#include <cstdint>

namespace dripfeed::telnet {

// Time since an epoch of the driver's choice that never steps back.
using Time = std::chrono::nanoseconds;

inline constexpr std::uint8_t kIac = 0xFF;  // "interpret as command"; doubled where it is data
inline constexpr std::uint8_t kSubBegin = 0xFA;
inline constexpr std::uint8_t kSubEnd = 0xF0;

enum class Verb : std::uint8_t { will = 0xFB, wont = 0xFC, do_it = 0xFD, dont = 0xFE };

inline constexpr std::uint8_t kBinary = 0;  // RFC 856: eight bits, nothing is special but IAC
inline constexpr std::uint8_t kEcho = 1;
inline constexpr std::uint8_t kSuppressGoAhead = 3;  // RFC 858
inline constexpr std::uint8_t kComPort = 44;         // RFC 2217

// Commands of the COM-PORT option from the client; the server's answer has kServer more, and the value in effect.
inline constexpr std::uint8_t kServer = 100;
enum class ComPort : std::uint8_t {
  signature = 0,
  set_baudrate = 1,  // 4 octets, high first; 0 asks
  set_datasize = 2,  // 5..8; 0 asks
  set_parity = 3,    // 1 none, 2 odd, 3 even, 4 mark, 5 space; 0 asks
  set_stopsize = 4,  // 1, 2; 3 is 1.5; 0 asks
  set_control = 5,   // a value of Control
  notify_linestate = 6,
  notify_modemstate = 7,
  flow_suspend = 8,
  flow_resume = 9,
  set_linestate_mask = 10,
  set_modemstate_mask = 11,
  purge_data = 12,  // 1 what came in, 2 what is to go out, 3 both
};

// Values of set_control: the three groups share one code.
namespace control {
inline constexpr std::uint8_t kAskFlow = 0;
inline constexpr std::uint8_t kFlowNone = 1;
inline constexpr std::uint8_t kFlowXonXoff = 2;
inline constexpr std::uint8_t kFlowHardware = 3;
inline constexpr std::uint8_t kAskBreak = 4;
inline constexpr std::uint8_t kBreakOn = 5;
inline constexpr std::uint8_t kBreakOff = 6;
inline constexpr std::uint8_t kAskDtr = 7;
inline constexpr std::uint8_t kDtrOn = 8;
inline constexpr std::uint8_t kDtrOff = 9;
inline constexpr std::uint8_t kAskRts = 10;
inline constexpr std::uint8_t kRtsOn = 11;
inline constexpr std::uint8_t kRtsOff = 12;
inline constexpr std::uint8_t kAskInboundFlow = 13;
inline constexpr std::uint8_t kInboundFlowNone = 14;
inline constexpr std::uint8_t kLast = 19;
}  // namespace control

// Bits of notify_modemstate; the low half says which changed.
namespace modem {
inline constexpr std::uint8_t kCd = 0x80;
inline constexpr std::uint8_t kRing = 0x40;
inline constexpr std::uint8_t kDsr = 0x20;
inline constexpr std::uint8_t kCts = 0x10;
inline constexpr std::uint8_t kDeltaDsr = 0x02;
inline constexpr std::uint8_t kDeltaCts = 0x01;
}  // namespace modem

// Bits of notify_linestate.
namespace line {
inline constexpr std::uint8_t kTimeout = 0x80;
inline constexpr std::uint8_t kAllSent = 0x40;  // the transmitter's shift register is empty
inline constexpr std::uint8_t kHoldingEmpty = 0x20;
inline constexpr std::uint8_t kBreak = 0x10;
inline constexpr std::uint8_t kFraming = 0x08;
inline constexpr std::uint8_t kParity = 0x04;
inline constexpr std::uint8_t kOverrun = 0x02;
inline constexpr std::uint8_t kErrors = kBreak | kFraming | kParity | kOverrun;
}  // namespace line

inline constexpr std::uint8_t kPurgeBoth = 3;
inline constexpr std::uint8_t kPurgeOutput = 2;

}  // namespace dripfeed::telnet

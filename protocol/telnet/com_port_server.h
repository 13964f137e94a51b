// The server's end of a serial port behind Telnet (RFC 2217), as a device server has it: a simulated control lives
// after it, and counterparts of others are tried against it. It answers every command with the value in effect and
// notifies what the masks ask for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "protocol/telnet/codes.h"
#include "protocol/telnet/decoder.h"
#include "protocol/telnet/options.h"
#include "protocol/telnet/output.h"

namespace dripfeed::telnet {

// The port as it is set; the values of RFC 2217.
struct PortState {
  std::uint32_t baud = 9600;
  std::uint8_t data_bits = 8;
  std::uint8_t parity = 1;
  std::uint8_t stop_bits = 1;
  std::uint8_t flow = control::kFlowNone;
  std::uint8_t inbound_flow = control::kInboundFlowNone;
  bool dtr = false;
  bool rts = false;
  bool break_on = false;
  friend bool operator==(const PortState&, const PortState&) = default;
};

class ComPortServer : private DecoderSink {
 public:
  ComPortServer();
  // The connection stands: offers what it has.
  void begin();
  std::size_t receive(std::span<const std::byte> wire, std::span<std::byte> data);
  // How many it took into pending_out(); none while the client suspends or earlier data waits.
  std::size_t send(std::span<const std::byte> data);
  // The lines as the device drives them (CTS, DSR, RI, CD: bits of modem::); reports to the client what changed.
  void set_modem_lines(std::uint8_t lines);
  // The receiver saw something (bits of line::); reported where the client's mask asks for it.
  void notify_line(std::uint8_t bits);
  // The device's buffer is full, or has room again.
  void ask_suspend(bool suspend);

  [[nodiscard]] std::span<const std::byte> pending_out() const { return out_.pending(); }
  void mark_sent(std::size_t count) { out_.mark_sent(count); }
  [[nodiscard]] const PortState& port() const { return port_; }
  [[nodiscard]] bool offered() const { return offered_; }  // the client does RFC 2217
  // Whether the client asked to drop what is to go out, since the last call.
  [[nodiscard]] bool take_purge() { return std::exchange(purge_, false); }

 private:
  void on_negotiation(Verb verb, std::uint8_t option) override;
  void on_subnegotiation(std::uint8_t option, std::span<const std::uint8_t> parameters) override;
  void accept();
  void on_baud(std::span<const std::uint8_t> value);
  void on_control(std::uint8_t value);
  void answer(ComPort command, std::span<const std::uint8_t> value);
  void answer_octet(ComPort command, std::uint8_t value);

  Options options_;
  Decoder decoder_;
  Output out_;
  PortState port_;
  bool offered_ = false;
  bool suspended_ = false;
  bool purge_ = false;
  std::uint8_t modem_ = 0;
  std::uint8_t modem_mask_ = 0xFF;  // the masks begin as section 3 says
  std::uint8_t line_mask_ = 0;
};

}  // namespace dripfeed::telnet

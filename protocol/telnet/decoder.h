// Splits a Telnet stream into data, negotiations and sub-negotiations, across any split of the bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "protocol/telnet/codes.h"

namespace dripfeed::telnet {

class DecoderSink {
 public:
  DecoderSink() = default;
  DecoderSink(const DecoderSink&) = delete;
  DecoderSink& operator=(const DecoderSink&) = delete;
  virtual ~DecoderSink() = default;
  virtual void on_negotiation(Verb verb, std::uint8_t option) = 0;
  // Doubled FF taken out; `parameters` is what stands after the option's number.
  virtual void on_subnegotiation(std::uint8_t option, std::span<const std::uint8_t> parameters) = 0;
};

class Decoder {
 public:
  // A longer sub-negotiation is dropped whole and counted.
  static constexpr std::size_t kMaxSubnegotiation = 256;

  // Writes the data among these bytes to `data`, which has at least their count, and says how many. Everything else
  // goes to the sink, in its order; other commands (NOP, AYT, GA, …) mean nothing to a serial line.
  std::size_t decode(std::span<const std::byte> wire, std::span<std::byte> data, DecoderSink& sink);

  // Whether the other side sends BINARY. Without it a bare CR comes as CR NUL (RFC 854), and the NUL is no data.
  void set_binary(bool on) { binary_ = on; }
  [[nodiscard]] std::uint64_t dropped_subnegotiations() const { return dropped_; }

 private:
  enum class State : std::uint8_t { data, iac, verb, sub, sub_iac };
  void end_subnegotiation(DecoderSink& sink);
  State on_command(std::uint8_t byte, std::span<std::byte> data, std::size_t& count);

  State state_ = State::data;
  Verb verb_ = Verb::will;
  bool binary_ = false;
  bool after_cr_ = false;  // a CR was the last data, whatever commands came since
  bool too_long_ = false;
  std::size_t sub_length_ = 0;
  std::array<std::uint8_t, kMaxSubnegotiation> sub_{};
  std::uint64_t dropped_ = 0;
};

}  // namespace dripfeed::telnet

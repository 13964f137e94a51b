// The lines that the scenarios run on, and the wire of a text made without the encoder.
#pragma once

#include <array>
#include <string>

#include "protocol/tape_code/tape_code.h"
#include "tests/wire/virtual_line.h"

namespace dripfeed::wire {

using namespace std::chrono_literals;

struct LineCase {
  const char* name;
  const char* framing;
  std::uint32_t baud;
  std::uint32_t budget;
  std::uint32_t unsent;
  std::uint32_t latency;
  Time out_delay;
  Time in_delay;
  Time wake_delay;
};

// The latency holds DC3's own character time and both delays.
inline constexpr std::array<LineCase, 4> kLines{{
    {"9600 7E2, 16550", "7E2", 9600, 10, 4, 5, 0us, 4500us, 1000us},
    {"19200 8N1, USB", "8N1", 19200, 10, 4, 6, 600us, 1900us, 1000us},
    {"115200 8N1, large budget", "8N1", 115200, 64, 40, 24, 400us, 1500us, 1000us},
    {"4800 7E2, slow", "7E2", 4800, 10, 4, 3, 0us, 4000us, 1000us},
}};

inline LineModel model_of(const LineCase& with) {
  LineModel model;
  feed::Settings& settings = model.settings;
  settings.framing = tape_code::parse_framing(with.framing).value();
  settings.baud = with.baud;
  settings.wire.eighth_bit = eighth_bit(settings.framing, tape_code::Code::ascii, tape_code::ParityBy::software);
  settings.overrun_budget = with.budget;
  settings.unsent = with.unsent;
  settings.latency_chars = with.latency;
  model.max_out_delay = with.out_delay;
  model.max_in_delay = with.in_delay;
  model.max_wake_delay = with.wake_delay;
  return model;
}

// The same line under RTS and CTS. The driver looks at CTS each `in_delay` at the latest.
inline LineModel by_lines(LineModel model) {
  model.by_lines = true;
  model.settings.flow = feed::Flow::rtscts;
  model.settings.start = feed::Start::at_once;
  model.settings.end = {.dc3 = false, .quiet = std::chrono::seconds(2)};
  return model;
}

// The whole wire, made without the encoder.
inline std::string expected_wire(const std::string& text, const feed::Settings& settings) {
  std::string wire(settings.wire.leader_chars, '\0');
  for (const char c : text) {
    const std::string one = c == '\n' ? std::string(characters(settings.wire.eob)) : std::string(1, c);
    for (const char out : one) {
      wire += static_cast<char>(tape_code::with_parity(static_cast<std::uint8_t>(out), settings.wire.eighth_bit));
    }
  }
  return wire + std::string(settings.wire.trailer_chars, '\0');
}

}  // namespace dripfeed::wire

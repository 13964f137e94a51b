// The receivers as a table.
#include "server/simulator/uart.h"

#include <array>

#include <fmt/format.h>

namespace dripfeed::simulator {

namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

constexpr std::array<Uart, 4> kUarts{{
    {.name = "16550", .chars = 4, .fixed_ns = 0},
    {.name = "ftdi", .chars = 0, .fixed_ns = 16 * kMillisecond},
    {.name = "device-server", .chars = 4, .fixed_ns = 2 * kMillisecond},
    {.name = "ideal", .chars = 0, .fixed_ns = 0},
}};

}  // namespace

std::expected<Uart, std::string> find_uart(std::string_view name) {
  std::string known;
  for (const Uart& uart : kUarts) {
    if (uart.name == name) return uart;
    known += fmt::format(" {}", uart.name);
  }
  return std::unexpected(fmt::format("uart \"{}\" is none of:{}", name, known));
}

}  // namespace dripfeed::simulator

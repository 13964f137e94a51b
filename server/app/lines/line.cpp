// Names as people and the API see them.
#include "server/app/lines/line.h"

#include <array>

#include <fmt/format.h>

namespace dripfeed::app {

std::string_view name_of(LineState state) {
  static constexpr std::array<std::string_view, 9> kNames = {"disconnected", "idle", "armed",     "feeding",  "held",
                                                             "draining",     "torn", "receiving", "answering"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string_view name_of(feed::Stall stall) {
  static constexpr std::array<std::string_view, 13> kNames = {
      "",
      "waiting for DC1",
      "held by DC3",
      "CTS off",
      "peer gone",
      "waiting for ledger",
      "waiting for text",
      "waiting for end",
      "stopped",
      "DSR off",
      "held below",
      "waiting for trigger",
      kResetSuspected,
  };
  return kNames[static_cast<std::size_t>(stall)];
}

std::string alarm_text(const MachineReport& machine) {
  if (machine.alarm == 0) return {};
  std::string text = fmt::format("machine alarm {}", machine.alarm);
  if (machine.program > 0) text += fmt::format(" (program {}, line {})", machine.program, machine.line);
  return text;
}

void report_link(const Link& link, LineReport& report) {
  report.line_errors = link.errors();
  if (report.link_note != link.note()) report.link_note = link.note();
}

}  // namespace dripfeed::app

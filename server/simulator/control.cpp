// One row a protocol. A control of a new kind is a file of its own and a row here.
#include "server/simulator/control.h"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "server/simulator/packet_control.h"
#include "server/simulator/packet_punch.h"
#include "server/simulator/punching_control.h"
#include "server/simulator/simulated_control.h"

namespace dripfeed::simulator {

namespace {

template <class Kind>
std::unique_ptr<Control> make_kind(const ControlSettings& settings, Record record) {
  return std::make_unique<Kind>(settings, std::move(record));
}

struct Row {
  std::string_view protocol;
  std::unique_ptr<Control> (*make)(const ControlSettings& settings, Record record);
};
constexpr std::array kRows = {
    Row{"dc", make_kind<SimulatedControl>},
    Row{"xmodem", make_kind<PacketControl>},
    Row{"xmodem-crc", make_kind<PacketControl>},
    Row{"xmodem-1k", make_kind<PacketControl>},
    Row{"3964", make_kind<PacketControl>},
    Row{"3964r", make_kind<PacketControl>},
    Row{"remote-buffer-a", make_kind<PacketControl>},
    Row{"ymodem", make_kind<PacketControl>},
    Row{"punch", make_kind<PunchingControl>},
    Row{"punch-read", make_kind<PunchingControl>},  // and reads what the host answers
    Row{"punch-xmodem", make_kind<PacketPunch>},
    Row{"punch-xmodem-crc", make_kind<PacketPunch>},
    Row{"punch-xmodem-1k", make_kind<PacketPunch>},
    Row{"punch-ymodem", make_kind<PacketPunch>},
    Row{"punch-3964", make_kind<PacketPunch>},
    Row{"punch-3964r", make_kind<PacketPunch>},
    Row{"punch-remote-buffer-a", make_kind<PacketPunch>},
};

}  // namespace

std::string_view name_of(ControlState state) {
  static constexpr std::array<std::string_view, 5> kNames = {"waiting", "reading", "held", "ended", "alarm"};
  return kNames[static_cast<std::size_t>(state)];
}

std::vector<std::string_view> control_protocols() {
  std::vector<std::string_view> names;
  for (const Row& row : kRows) names.push_back(row.protocol);
  return names;
}

std::expected<std::unique_ptr<Control>, std::string> make_control(const ControlSettings& settings, Record record) {
  for (const Row& row : kRows) {
    if (row.protocol == settings.protocol) return row.make(settings, std::move(record));
  }
  return std::unexpected(fmt::format("no simulated control speaks \"{}\"; known are {}", settings.protocol,
                                     fmt::join(control_protocols(), ", ")));
}

}  // namespace dripfeed::simulator

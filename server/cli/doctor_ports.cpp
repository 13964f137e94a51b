// The ports that profiles name. None is opened.
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "server/cli/doctor.h"
#include "server/io/line_claim.h"
#include "server/io/port_state.h"
#include "server/io/serial_identity.h"
#include "server/json/documents.h"
#include "server/machine/bus_settings.h"

namespace dripfeed::cli {

namespace {

// A machine whose link is a port of this computer.
struct Port {
  const std::string& machine;
  const machine::LinkUrl& link;
  std::uint32_t baud;
};

void look_at_use(const Port& port, Findings& found) {
  const auto folder = io::known_lines_folder();
  const std::string holder = folder.empty() ? std::string() : io::line_holder(folder, port.link);
  if (!holder.empty())
    found.push_back(
        {Health::ok, "port", fmt::format("{}: {} is in use by {}", port.machine, port.link.path, holder), ""});
}

void look_at_rate(const Port& port, const io::PortState& state, Findings& found) {
  if (!state.base_baud) return;  // an adapter's rates are its own, and only opening it would say them
  if (io::divides_to(*state.base_baud, port.baud)) return;
  found.push_back({Health::fault, "port",
                   fmt::format("{}: {}cannot make {} baud: its rates are {} divided by a whole number", port.machine,
                               port.link.path, port.baud, *state.base_baud),
                   "choose another rate at the control and in the profile"});
}

// Nothing where a person may use it as it is.
bool look_at_device(const Port& port, const io::PortState& state, Findings& found) {
  const std::string at = fmt::format("{}: {}", port.machine, port.link.path);
  if (!state.exists) {
    found.push_back({Health::fault, "port", at + " is not there",
                     "plug the adapter in (ls -l /dev/serial/by-id), or change the profile's link"});
  } else if (!state.is_device) {
    found.push_back({Health::fault, "port", at + " is not a serial port", "change the profile's link"});
  } else if (!state.has_uart) {
    found.push_back(
        {Health::fault, "port", at + "is the name of a port that is not there", "change the profile's link"});
  } else if (!state.may_use) {
    found.push_back(
        {Health::fault, "port", fmt::format("{} is for the group {}", at, state.group),
         fmt::format("usermod -aG {} USER, for the user of the server, and restart the server", state.group)});
  } else {
    return true;
  }
  return false;
}

void look_at_port_of(const Port& port, Findings& found) {
  const io::PortState state = io::look_at_port(port.link.path);
  look_at_use(port, found);
  if (!look_at_device(port, state, found)) return;
  look_at_rate(port, state, found);
  if (const std::string lasting = io::lasting_name(port.link.path); !lasting.empty()) {
    found.push_back(
        {Health::warning, "port",
         fmt::format("{}: {} may be another adapter after it was plugged in again", port.machine, port.link.path),
         fmt::format("name it {} in the profile", lasting)});
    return;
  }
  found.push_back(
      {Health::ok, "port", fmt::format("{}: {} is there and may be used", port.machine, port.link.path), ""});
}

}  // namespace

void look_at_lines_folder(Findings& found) {
  const std::filesystem::path folder = io::known_lines_folder();
  if (folder.empty()) {
    found.push_back({Health::fault, "lines", "there is no folder for the records of the lines",
                     "name one by DRIPFEED_LINES, the same for server and commands"});
    return;
  }
  std::error_code error;
  if (!std::filesystem::exists(folder, error)) {
    found.push_back({Health::ok, "lines", fmt::format("{} is made with the first line", folder.string()), ""});
  } else if (::access(folder.c_str(), R_OK | W_OK | X_OK) != 0) {
    found.push_back({Health::fault, "lines", fmt::format("{} cannot be written: no line opens", folder.string()),
                     "give it to the server's user, or name another one by DRIPFEED_LINES"});
  } else {
    found.push_back({Health::ok, "lines", fmt::format("{} has the records of the lines", folder.string()), ""});
  }
}

void look_at_ports(const sqlite::StoreState& state, Findings& found) {
  const json::JsonDocuments documents;
  for (const sqlite::StoreState::Machine& machine : state.machines) {
    const auto profile = documents.read_profile(machine.profile);
    if (!profile) {
      found.push_back({Health::fault, "machine",
                       fmt::format("{}: its profile is not read: {}", machine.name, profile.error().text),
                       "change the profile at the machine's card"});
      continue;
    }
    const auto line = machine::effective_line(profile->line);
    if (!line) {
      found.push_back(
          {Health::fault, "machine", fmt::format("{}: {}", machine.name, line.error()), "change the profile's link"});
      continue;
    }
    if (line->link.kind == machine::LinkKind::serial) {
      look_at_port_of({machine.name, line->link, line->baud}, found);
    } else if (line->link.kind == machine::LinkKind::modbus_rtu) {
      const auto bus = machine::bus_settings_of(line->link);
      look_at_port_of({machine.name, line->link, bus ? bus->baud : 0}, found);
    }
  }
}

}  // namespace dripfeed::cli

// dripfeed doctor: what may keep a server from its work, each with what to do.
#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/cli/doctor.h"
#include "server/cli/documents.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

namespace {

struct DoctorOptions {
  std::string data;
  bool json = false;
};

Findings look_at_all(const std::string& data) {
  Findings found;
  sqlite::StoreState state;
  look_at_folder(data, found);
  look_at_owner(data, found);
  look_at_contents(data, found, state);
  look_at_lines_folder(found);
  look_at_ports(state, found);
  look_at_clock(state, found);
  look_at_limits(found);
  return found;
}

std::string text_of(const Findings& found) {
  std::string text;
  for (const Finding& one : found) {
    text += fmt::format("{:8} {:9} {}\n", name_of(one.health), one.check, one.text);
    if (!one.cure.empty()) text += fmt::format("{:19}{}\n", "", one.cure);
  }
  return text;
}

int doctor(const DoctorOptions& options) {
  const Findings found = look_at_all(options.data);
  if (!write_output("-", options.json ? doctor_document(found) : text_of(found))) return kWrongUse;
  return std::ranges::any_of(found, [](const Finding& one) { return one.health == Health::fault; }) ? kFailed : kDone;
}

}  // namespace

void add_doctor(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("doctor", "Check what may keep a server from its work, and state what to do");
  const auto options = std::make_shared<DoctorOptions>();
  command->add_option("DATA", options->data, "folder of the store")->required();
  command->add_flag("--json", options->json, "one JSON object on standard output");
  command->footer(
      "Run it as the user of the server: rights, limits and groups are those of the user who runs it. It opens no\n"
      "port, takes no lock and writes nothing; a server may run. It reads samples of the store; dripfeed ledger "
      "verify\n"
      "reads all of it.\n"
      "Exit: 0 no fault (warnings allowed), 1 at least one fault, 2 wrong use");
  command->callback([options, &exit_code] { exit_code = doctor(*options); });
}

}  // namespace dripfeed::cli

// dripfeed maintenance: reads the store through or copies it, for the server, in a process that can touch nothing of
// it. Not for people: they have `ledger verify` and `backup`. It writes the document to standard output, or the
// sentence why there is none: with exit code 1 the store has faults, with 2 it cannot be read.
#include <filesystem>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/cli/data_folder.h"
#include "server/cli/documents.h"
#include "server/cli/output.h"
#include "server/cli/withdraw.h"
#include "store/postgresql/verify.h"
#include "store/sqlite/archive.h"

namespace dripfeed::cli {

namespace {

struct MaintenanceOptions {
  std::string data;
  bool is_database = false;
  std::string backup;
};

int reply(const std::string& document) { return write_output("-", document) ? kDone : kWrongUse; }
int reply_why(const store::Error& error) {
  write_output("-", "the store cannot be read: " + store::message_of(error));
  return kWrongUse;
}

// The address of a database may hold a password, so it comes by standard input and is in no list of processes.
int verify(const MaintenanceOptions& options) {
  withdraw(0);
  std::string url;
  if (options.is_database) std::getline(std::cin, url);
  const auto found = options.is_database ? postgresql::verify(url) : sqlite::verify(store_path(options.data));
  return found ? reply(verify_document(*found)) : reply_why(found.error());
}

int back_up(const MaintenanceOptions& options) {
  withdraw(0);
  const auto made = sqlite::back_up(store_path(options.data), options.backup);
  if (!made) return reply_why(made.error());
  if (const auto& faults = made->found.faults; !faults.empty()) {
    write_output("-", fmt::format("the store has {} faults and no backup was made; the first: {}: {}", faults.size(),
                                  faults.front().subject, faults.front().what));
    return kFailed;
  }
  return reply(holding_document(*made, std::filesystem::path(options.backup).filename().string()));
}

}  // namespace

void add_maintenance(CLI::App& app, int& exit_code) {
  CLI::App* maintenance = app.add_subcommand("maintenance", "one piece of maintenance for the server; not for people");
  maintenance->group("");  // not in the help
  maintenance->require_subcommand(1);
  const auto options = std::make_shared<MaintenanceOptions>();
  CLI::App* verifying = maintenance->add_subcommand("verify", "reads a store through");
  verifying->add_option("DATA", options->data, "folder of the store");
  verifying->add_flag("--database", options->is_database, "its address is the line of standard input");
  verifying->callback([options, &exit_code] { exit_code = verify(*options); });
  CLI::App* backing = maintenance->add_subcommand("backup", "makes a backup");
  backing->add_option("DATA", options->data, "folder of the store")->required();
  backing->add_option("FILE", options->backup, "the backup")->required();
  backing->callback([options, &exit_code] { exit_code = back_up(*options); });
}

}  // namespace dripfeed::cli

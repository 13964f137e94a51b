// dripfeed ledger verify: whether what a server recorded is whole. It reads the store in its folder, also while the
// server runs, and changes nothing.
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/cli/data_folder.h"
#include "server/cli/documents.h"
#include "server/cli/open_store.h"
#include "server/cli/output.h"
#include "store/postgresql/verify.h"
#include "store/sqlite/verify.h"

namespace dripfeed::cli {

namespace {

struct LedgerOptions {
  std::string data;
  std::string store{};
  bool json = false;
};

std::string summary_of(const sql::Verification& found) {
  return fmt::format(
      "audit: {} rows, head {}\nledger: {} jobs, {} rows\ncontents: {}, {} bytes\ntorn machines that wait for a "
      "confirmation: {}\n{}\n",
      found.audit_rows, found.audit_head.empty() ? "none" : found.audit_head, found.jobs, found.ledger_rows,
      found.contents, found.content_bytes, found.torn_machines,
      found.faults.empty() ? std::string("whole") : fmt::format("{} faults", found.faults.size()));
}

int verify(const LedgerOptions& options) {
  if (options.data.empty() == options.store.empty()) {
    print_error("one of the two: the folder of the store, or --store");
    return kWrongUse;
  }
  const std::string path = options.data.empty() ? std::string("--store") : store_path(options.data);
  const auto found = options.data.empty() ? postgresql::verify(options.store) : sqlite::verify(path);
  if (!found) {
    print_error(fmt::format("{}: {}", path, store::message_of(found.error())));
    return found.error().code == store::ErrorCode::corrupt ? kFailed : kWrongUse;
  }
  for (const sql::VerifyFault& fault : found->faults) print_error(fmt::format("{}: {}", fault.subject, fault.what));
  if (!write_output("-", options.json ? verify_document(*found) : summary_of(*found))) return kWrongUse;
  return found->faults.empty() ? kDone : kFailed;
}

}  // namespace

void add_ledger(CLI::App& app, int& exit_code) {
  CLI::App* ledger = app.add_subcommand("ledger", "what a server recorded of its transfers");
  ledger->require_subcommand(1);
  CLI::App* command = ledger->add_subcommand(
      "verify",
      "checks a server's folder: the file, the audit's chain, each job's ledger, each content by its hash, torn marks");
  const auto options = std::make_shared<LedgerOptions>();
  command->add_option("DIR", options->data, "folder of the store");
  command->add_option("--store", options->store, kStoreOption);
  command->add_flag("--json", options->json, "one JSON object on standard output");
  command->footer("Exit: 0 whole, 1 at least one fault, 2 wrong use or the store cannot be read");
  command->callback([options, &exit_code] { exit_code = verify(*options); });
}

}  // namespace dripfeed::cli

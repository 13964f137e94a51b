// dripfeed audit: the rows of a server's audit as lines of JSON, and whether such lines are whole, without the server.
#include <fstream>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/app/base/error.h"
#include "server/cli/cli.h"
#include "server/cli/open_store.h"
#include "server/cli/output.h"
#include "server/json/people.h"
#include "store/sql/audit_chain.h"

namespace dripfeed::cli {

namespace {

struct AuditOptions {
  std::string data = "data";
  std::string store{};
  std::string output;
  std::string file;
  std::string head;
};

// Oldest first, a page at a time: the store lists the newest first, so pages are asked for by their end.
app::Result<void> write_rows(store::Store& store, std::ostream& out) {
  const auto newest = app::lift(store.audit().list({.limit = 1, .after = {}}));
  if (!newest) return std::unexpected(newest.error());
  const std::uint64_t last = newest->items.empty() ? 0 : newest->items.front().seq;
  for (std::uint64_t done = 0; done < last;) {
    const std::uint64_t until = std::min<std::uint64_t>(done + store::kPageLimitMax, last);
    const auto rows = app::lift(
        store.audit().list({.limit = static_cast<std::uint32_t>(until - done), .after = fmt::format("{}", until + 1)}));
    if (!rows) return std::unexpected(rows.error());
    for (auto row = rows->items.rbegin(); row != rows->items.rend(); ++row) out << json::audit_row(*row) << '\n';
    done = until;
  }
  out.flush();
  return out ? app::Result<void>{} : app::fail(app::ErrorCode::unavailable, "the rows could not be written");
}

int export_rows(const AuditOptions& options) {
  const auto store = app::lift(open_existing({.data = options.data, .url = options.store}));
  if (!store) {
    print_error(store.error());
    return kWrongUse;
  }
  std::ofstream file;
  if (!options.output.empty()) file.open(options.output, std::ios::binary);
  const auto written = write_rows(**store, options.output.empty() ? std::cout : file);
  if (!written) print_error(written.error());
  return written ? kDone : kWrongUse;
}

int refuse(const AuditOptions& options, std::uint64_t line, std::string_view why) {
  print_error(fmt::format("{}:{}: {}", options.file, line, why));
  return kFailed;
}

int verify_rows(const AuditOptions& options) {
  std::ifstream file(options.file, std::ios::binary);
  if (!file) {
    print_error(fmt::format("{} cannot be read", options.file));
    return kWrongUse;
  }
  sql::AuditChain chain;
  std::string text;
  for (std::uint64_t line = 1; std::getline(file, text); ++line) {
    const auto row = json::read_audit_row(text);
    if (!row) return refuse(options, line, row.error().text);
    if (!chain.follows(*row)) return refuse(options, line, "the row was changed, or rows before it are missing");
  }
  if (!options.head.empty() && options.head != chain.head())
    return refuse(options, chain.rows(), "it does not end with the row whose hash was noted: rows are missing");
  fmt::print("{} rows, head {}\n", chain.rows(), chain.head().empty() ? "none" : chain.head());
  return kDone;
}

}  // namespace

void add_audit(CLI::App& app, int& exit_code) {
  CLI::App* audit = app.add_subcommand("audit", "who did what: export the rows, verify exported ones");
  audit->require_subcommand(1);
  const auto options = std::make_shared<AuditOptions>();
  CLI::App* exporting = audit->add_subcommand("export", "all rows as lines of JSON, oldest first");
  exporting->add_option("--data", options->data, "folder of the store")->capture_default_str();
  exporting->add_option("--store", options->store, kStoreOption);
  exporting->add_option("--output", options->output, "a file instead of standard output");
  exporting->callback([options, &exit_code] { exit_code = export_rows(*options); });
  CLI::App* verifying = audit->add_subcommand("verify", "whether exported rows are whole and as they were written");
  verifying->add_option("FILE", options->file, "as export wrote it")->required();
  verifying->add_option("--head", options->head, "the hash that was noted of the last row, to notice a cut tail");
  verifying->footer("Exit: 0 whole, 1 changed or cut, 2 wrong use");
  verifying->callback([options, &exit_code] { exit_code = verify_rows(*options); });
}

}  // namespace dripfeed::cli

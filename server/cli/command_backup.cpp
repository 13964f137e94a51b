// dripfeed backup and dripfeed restore: the whole of a server's store as one file, also while it runs, and a store from
// such a file. Each says what it holds, after it has read all of it.
#include <memory>
#include <tuple>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/cli/data_folder.h"
#include "server/cli/documents.h"
#include "server/cli/open_store.h"
#include "server/cli/output.h"
#include "store/postgresql/filling.h"
#include "store/postgresql/verify.h"
#include "store/sqlite/archive.h"

namespace dripfeed::cli {

namespace {

struct BackupOptions {
  std::string data;
  std::string file;
  std::string url = {};  // of a database for the store
  bool replace = false;
  bool json = false;
};

constexpr const char* kBackupFooter =
    "It takes one state while the server feeds, reads all of it through, and gives it its name only then: the file's\n"
    "soundness, the audit's chain, each job's ledger, each content by its hash. The file is the whole store: "
    "programs,\n"
    "machines, families, releases, jobs, ledger, audit, and the hashes of tokens. Not in it: the records of the lines\n"
    "(DRIPFEED_LINES), which belong to their computer, and certificates.\n"
    "Exit: 0 made, 1 the store has a fault and nothing was made, 2 wrong use or I/O error";
constexpr const char* kRestoreStoreOption =
    "postgresql://USER@HOST/DATABASE: an empty database for the store; DATA is then the server's folder";
constexpr const char* kRestoreFooter =
    "It refuses a folder whose server runs, and one that has a store, unless --replace keeps that under another name.\n"
    "With --store all rows go into a PostgreSQL database in one transaction, and the database is read through, too.\n"
    "An older schema is brought up to date; a newer one is refused. The store is as old as its backup: tokens revoked\n"
    "since are valid again, and jobs that had a line then are interrupted when the server starts. It does not\n"
    "know what was sent since: look at each control before you arm.\n"
    "Exit: 0 done, 1 the backup has a fault and nothing was changed, 2 wrong use or I/O error";

std::string summary_of(const sqlite::Holding& holding) {
  const sqlite::Verification& found = holding.found;
  std::string text = fmt::format(
      "schema {}, {} bytes\n{} machines, {} families, {} parts, {} programs, {} releases, {} receipts, {} tokens\n"
      "{} jobs with {} rows in their ledgers, {} rows in the audit, head {}\n{} contents, {} bytes, each has its "
      "hash\n",
      holding.schema, holding.file_bytes, holding.machines, holding.families, holding.parts, holding.programs,
      holding.releases, holding.receipts, holding.tokens, found.jobs, found.ledger_rows, found.audit_rows,
      found.audit_head.empty() ? "none" : found.audit_head, found.contents, found.content_bytes);
  if (found.torn_machines > 0)
    text += fmt::format("torn machines that wait for a confirmation: {}\n", found.torn_machines);
  return text;
}

int report(const store::Result<sqlite::Holding>& holding, const BackupOptions& options, std::string_view done) {
  if (!holding) {
    print_error(store::message_of(holding.error()));
    return holding.error().code == store::ErrorCode::corrupt ? kFailed : kWrongUse;
  }
  for (const sqlite::VerifyFault& fault : holding->found.faults)
    print_error(fmt::format("{}: {}", fault.subject, fault.what));
  const bool whole = holding->found.faults.empty();
  if (!whole) print_error("nothing was made or changed, because of these faults");
  std::string text;
  if (options.json) {
    text = holding_document(*holding, options.file);
  } else if (whole) {
    text = fmt::format("{}\n{}", done, summary_of(*holding));
    if (!holding->kept.empty()) text += fmt::format("the store that was there is now {}\n", holding->kept);
  }
  if (!write_output("-", text)) return kWrongUse;
  return whole ? kDone : kFailed;
}

int back_up(const BackupOptions& options) {
  const auto made = sqlite::back_up(store_path(options.data), options.file);
  return report(made, options, fmt::format("{} is a whole backup of {}", options.file, options.data));
}

// The same shop: what was read through on both sides is equal.
store::Result<void> compare(const sql::Verification& backup, const sql::Verification& database) {
  const auto figures = [](const sql::Verification& one) {
    return std::tie(one.audit_rows, one.audit_head, one.jobs, one.ledger_rows, one.contents, one.content_bytes,
                    one.torn_machines);
  };
  if (figures(backup) == figures(database) && database.faults.empty()) return {};
  const std::string why = database.faults.empty()
                              ? std::string("its figures are not those of the backup")
                              : fmt::format("{}: {}", database.faults[0].subject, database.faults[0].what);
  return std::unexpected(store::Error{store::ErrorCode::corrupt, fmt::format("{}; drop the database", why)});
}

int restore_into_database(const BackupOptions& options) {
  const StorePlace place{.data = options.data, .url = options.url};
  if (options.replace) {
    print_error("--replace is for a store in a folder: a database must be empty");
    return kWrongUse;
  }
  auto restored = [&]() -> store::Result<sqlite::Holding> {
    if (auto known = know_place(place); !known) return std::unexpected(known.error());
    auto holding =
        sqlite::read_out(options.file, [&](sql::Connection& from) { return postgresql::fill(options.url, from); });
    if (!holding || !holding->found.faults.empty()) return holding;
    const auto found = postgresql::verify(options.url);
    if (!found) return std::unexpected(found.error());
    if (auto same = compare(holding->found, *found); !same) return std::unexpected(same.error());
    if (auto marked = mark_elsewhere(place); !marked) return std::unexpected(marked.error());
    return holding;
  }();
  return report(restored, options, fmt::format("the database has the store of {}", options.file));
}

int restore(const BackupOptions& options) {
  if (const auto made = make_data_folder(options.data); !made) {
    print_error(made.error());
    return kWrongUse;
  }
  if (!options.url.empty()) return restore_into_database(options);
  const auto restored = sqlite::restore(options.file, store_path(options.data), options.replace);
  if (!restored && restored.error().code == store::ErrorCode::exists) {
    print_error(
        fmt::format("{} has a store already: give another folder, or --replace, which keeps the old one under "
                    "another name",
                    options.data));
    return kWrongUse;
  }
  return report(restored, options, fmt::format("{} has the store of {}", options.data, options.file));
}

}  // namespace

void add_backup(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("backup", "Copy a server's store to one file, also while it runs");
  const auto options = std::make_shared<BackupOptions>();
  command->add_option("DATA", options->data, "folder of the store")->required();
  command->add_option("FILE", options->file, "the backup; it must not be there yet")->required();
  command->add_flag("--json", options->json, "one JSON object on standard output");
  command->footer(kBackupFooter);
  command->callback([options, &exit_code] { exit_code = back_up(*options); });
}

void add_restore(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("restore", "Make a server's store from a backup");
  const auto options = std::make_shared<BackupOptions>();
  command->add_option("FILE", options->file, "the backup")->required();
  command->add_option("DATA", options->data, "folder of the store; made where there is none")->required();
  command->add_option("--store", options->url, kRestoreStoreOption);
  command->add_flag("--replace", options->replace, "put it in the place of the store there, which keeps its bytes");
  command->add_flag("--json", options->json, "one JSON object on standard output");
  command->footer(kRestoreFooter);
  command->callback([options, &exit_code] { exit_code = restore(*options); });
}

}  // namespace dripfeed::cli

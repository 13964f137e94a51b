// dripfeed import: a folder of programs, or an export of a shop, into the store of a server, which may run meanwhile.
// Each file is reported with what became of it and why.
#include <array>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/app/base/names.h"
#include "server/cli/cli.h"
#include "server/cli/import_folder.h"
#include "server/cli/open_store.h"
#include "server/cli/output.h"
#include "server/json/shop_manifest.h"

namespace dripfeed::cli {

namespace {

struct ImportOptions {
  std::string folder;
  std::string data = "data";
  std::string store{};
  std::string under{};
  std::string dialect{};
  std::string known = "revise";
  bool only_look = false;
  bool json = false;
};

constexpr const char* kFooter =
    "Folders become folders of the library. A file with several programs, as controls dump their memory, becomes a\n"
    "folder with each of them. The same text under the same name in the same folder is left alone. A folder that\n"
    "dripfeed export made comes back with its tags, families, parts and attached files. Links and hidden files are\n"
    "not followed; a running server shows what was added at once.\n"
    "Exit: 0 done, 1 something failed: its line states why, 2 wrong use or I/O error";

std::string line_of(const app::ImportRow& row) {
  const app::Imported& of = row.of;
  std::string line = fmt::format("{:<8} {}", app::kImportOutcomes.at(static_cast<std::size_t>(of.outcome)), row.file);
  if (!of.name.empty()) line += fmt::format(": {} {}{}{}", row.kind, of.folder, of.folder.empty() ? "" : "/", of.name);
  if (!of.dialect.empty()) line += fmt::format(" ({})", of.dialect);
  if (of.outcome == app::ImportOutcome::revised && of.revision != 0) line += fmt::format(", revision {}", of.revision);
  if (!of.why.empty()) line += fmt::format(": {}", of.why);
  return line;
}

std::string sums_of(const std::vector<app::ImportRow>& rows, bool only_look) {
  std::string text = only_look ? "nothing was stored; an import would give:" : "";
  for (std::size_t i = 0; i < app::kImportOutcomes.size(); ++i) {
    const auto count = std::ranges::count_if(
        rows, [&](const app::ImportRow& row) { return row.of.outcome == static_cast<app::ImportOutcome>(i); });
    text += fmt::format("{}{} {}", text.empty() ? "" : i == 0 ? " " : ", ", count, app::kImportOutcomes.at(i));
  }
  return text;
}

std::string why_wrong(const ImportOptions& options) {
  if (const std::string why = app::why_no_folder(options.under); !why.empty()) return fmt::format("--folder {}", why);
  if (const std::string why = app::why_no_dialect(options.dialect); !why.empty())
    return fmt::format("--dialect: {}", why);
  return {};
}

int import_folder(const ImportOptions& options) {
  if (const std::string why = why_wrong(options); !why.empty()) {
    print_error(why);
    return kWrongUse;
  }
  const auto store = open_existing({.data = options.data, .url = options.store});
  if (!store) {
    print_error(store::message_of(store.error()));
    return kWrongUse;
  }
  std::vector<app::ImportRow> rows;
  const app::OnImported on_imported = [&](const app::ImportRow& row) {
    rows.push_back(row);
    if (!options.json) fmt::print("{}\n", line_of(row));
  };
  const FolderImport order{.folder = options.folder,
                           .under = options.under,
                           .plan = {.actor = "dripfeed import",
                                    .dialect = options.dialect,
                                    .known = options.known == "skip" ? app::KnownName::skip : app::KnownName::revise,
                                    .only_look = options.only_look}};
  std::error_code fault;
  const bool is_export = std::filesystem::exists(order.folder / app::kManifestFile, fault);
  const auto done = (is_export ? import_export : import_tree)(**store, order, on_imported);
  if (!done) {
    print_error(done.error());
    return kWrongUse;
  }
  if (!write_output("-", options.json ? json::import_report(rows, options.only_look) + "\n"
                                      : sums_of(rows, options.only_look) + "\n"))
    return kWrongUse;
  const bool failed =
      std::ranges::any_of(rows, [](const app::ImportRow& row) { return row.of.outcome == app::ImportOutcome::failed; });
  return failed ? kFailed : kDone;
}

}  // namespace

void add_import(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("import", "Programs of a folder tree, or an export, into a server's store");
  const auto options = std::make_shared<ImportOptions>();
  command->add_option("FOLDER", options->folder, "with the files")->required();
  command->add_option("--data", options->data, "folder of the store")->capture_default_str();
  command->add_option("--store", options->store, kStoreOption);
  command->add_option("--folder", options->under, "the library's folder in which those of the tree lie");
  command->add_option("--dialect", options->dialect, "of new programs; without it the one that each text looks like");
  command->add_option("--known", options->known, "a name that is in use with another text: revise or skip")
      ->check(CLI::IsMember({"revise", "skip"}))
      ->capture_default_str();
  command->add_flag("--dry-run", options->only_look, "report what would become of each file; nothing is stored");
  command->add_flag("--json", options->json, "one JSON object on standard output");
  command->footer(kFooter);
  command->callback([options, &exit_code] { exit_code = import_folder(*options); });
}

}  // namespace dripfeed::cli

// dripfeed export: all that a shop has, as files of a folder with a manifest. The server may run meanwhile; the
// manifest is written last, so a folder without one is not whole.
#include <filesystem>
#include <memory>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "server/cli/cli.h"
#include "server/cli/folder_files.h"
#include "server/cli/open_store.h"
#include "server/cli/output.h"
#include "server/io/steady_clock.h"
#include "server/json/shop_manifest.h"
#include "store/hash/sha256.h"

namespace dripfeed::cli {

namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  std::string folder;
  std::string data = "data";
  std::string store{};
  bool all_revisions = false;
};

constexpr const char* kFooter =
    "FOLDER/programs/... has each program's newest text, byte for byte, in its folder of the library; families/, "
    "parts/,\n"
    "machines/ and attachments/ the rest, revisions/ the older texts with --all-revisions. dripfeed-export.json names\n"
    "each file with its SHA-256. Releases, verdicts, jobs, ledger, audit and people are not in it: dripfeed backup "
    "has\n"
    "them. dripfeed import reads it.\n"
    "Exit: 0 done, 2 wrong use or I/O error";

template <class Row, class List, class F>
app::Result<void> each(const List& list, const F& body) {
  store::PageRequest page{.limit = store::kPageLimitMax, .after = {}};
  do {
    auto rows = app::lift(list(page));
    if (!rows) return std::unexpected(rows.error());
    for (const Row& row : rows->items)
      if (auto done = body(row); !done) return done;
    page.after = std::move(rows->next);
  } while (!page.after.empty());
  return {};
}

std::string lower(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

class Exporter {
 public:
  Exporter(store::Store& store, const ExportOptions& options) : store_(store), options_(options) {}

  app::Result<app::ShopManifest> run() {
    manifest_.made_at_ms = io::SteadyClock().wall_ms();
    for (const auto step :
         {&Exporter::programs, &Exporter::families, &Exporter::parts, &Exporter::machines, &Exporter::attachments})
      if (auto done = (this->*step)(); !done) return std::unexpected(done.error());
    const auto written =
        write_new_file(fs::path(options_.folder) / app::kManifestFile, json::write_manifest(manifest_));
    if (!written) return std::unexpected(written.error());
    return std::move(manifest_);
  }

 private:
  // A path that no file has yet, nor a folder, whatever a file system makes of its letters.
  std::string free_path(const std::string& folder, const std::string& step, const std::string& ending, store::Id id) {
    std::string path = folder + "/" + step + ending;
    if (!taken_.insert(lower(path)).second) {
      path = fmt::format("{}/{}~{}{}", folder, step, id, ending);
      taken_.insert(lower(path));
    }
    return path;
  }

  app::Result<app::ShopFile> write(const std::string& path, std::string_view bytes) {
    if (auto written = write_new_file(fs::path(options_.folder) / path, bytes); !written)
      return std::unexpected(written.error());
    return app::ShopFile{.path = path, .sha256 = hash::sha256_hex(bytes), .bytes = bytes.size()};
  }

  app::Result<app::ShopFile> write_content(const std::string& path, const std::string& sha256) {
    const auto bytes = app::lift(store::read_whole(store_.contents(), sha256, UINT64_MAX));
    if (!bytes) return std::unexpected(bytes.error());
    auto file = write(path, *bytes);
    if (file && file->sha256 != sha256)
      return app::fail(app::ErrorCode::internal, fmt::format("content {} of the store is damaged", sha256));
    return file;
  }

  app::Result<void> program(const store::Program& program) {
    std::string folder = "programs";
    for (std::string_view rest = program.folder; !rest.empty();) {
      const std::string_view step = rest.substr(0, rest.find('/'));
      folder += "/" + file_step(step);
      rest.remove_prefix(std::min(rest.size(), step.size() + 1));
    }
    app::ShopProgram of{.id = program.id,
                        .name = program.name,
                        .dialect = program.dialect,
                        .folder = program.folder,
                        .tags = program.tags,
                        .archived = program.archived};
    const auto add = [&](const store::ProgramRevision& revision, const std::string& path) -> app::Result<void> {
      auto file = write_content(path, revision.sha256);
      if (!file) return std::unexpected(file.error());
      file->revision = revision.revision;
      file->by = revision.created_by;
      file->at_ms = revision.created_at_ms;
      of.revisions.push_back(std::move(*file));
      return {};
    };
    if (auto done = add(program.newest, free_path(folder, file_step(program.name), ".nc", program.id)); !done)
      return done;
    if (options_.all_revisions) {
      const auto list = [&](const store::PageRequest& page) { return store_.programs().revisions(program.id, page); };
      auto done = each<store::ProgramRevision>(list, [&](const store::ProgramRevision& one) {
        return one.revision >= program.newest.revision
                   ? app::Result<void>{}
                   : add(one, fmt::format("revisions/{}/{}.nc", program.id, one.revision));
      });
      if (!done) return done;
    }
    std::ranges::sort(of.revisions, {}, &app::ShopFile::revision);
    manifest_.programs.push_back(std::move(of));
    return {};
  }

  app::Result<void> programs() {
    const auto list = [&](const store::PageRequest& page) { return store_.programs().list(page); };
    auto done = each<store::Program>(list, [&](const store::Program& one) { return program(one); });
    std::ranges::reverse(manifest_.programs);  // in the order in which they came
    return done;
  }

  // All revisions of one document, or the newest alone.
  template <class Row, class Text>
  app::Result<app::ShopDocument> document(const std::string& name, std::vector<Row> rows, const std::string& folder,
                                          const std::string& ending, const Text& text) {
    app::ShopDocument of{.name = name};
    std::ranges::sort(rows, {}, &Row::revision);
    for (const Row& row : rows) {
      const bool is_newest = row.revision == rows.back().revision;
      const std::string step = is_newest ? file_step(name) : fmt::format("{}~{}", file_step(name), row.revision);
      auto file = write(free_path(folder, step, ending, row.revision), text(row));
      if (!file) return std::unexpected(file.error());
      file->revision = row.revision;
      file->by = row.changed_by;
      file->at_ms = row.changed_at_ms;
      of.revisions.push_back(std::move(*file));
    }
    return of;
  }

  // The newest, and with --all-revisions those before it.
  template <class Row, class List>
  app::Result<std::vector<Row>> rows_of(const Row& newest, const List& list) {
    std::vector<Row> rows{newest};
    if (!options_.all_revisions) return rows;
    auto done = each<Row>(list, [&](const Row& row) -> app::Result<void> {
      if (row.revision < newest.revision) rows.push_back(row);
      return {};
    });
    if (!done) return std::unexpected(done.error());
    return rows;
  }

  app::Result<void> families() {
    const auto list = [&](const store::PageRequest& page) { return store_.families().list(page); };
    return each<store::Family>(list, [&](const store::Family& newest) -> app::Result<void> {
      auto rows = rows_of(newest, [&](const auto& page) { return store_.families().revisions(newest.name, page); });
      if (!rows) return std::unexpected(rows.error());
      auto of = document(newest.name, std::move(*rows), "families", ".family",
                         [](const store::Family& one) { return std::string_view(one.text); });
      if (!of) return std::unexpected(of.error());
      manifest_.families.push_back(std::move(*of));
      return {};
    });
  }

  app::Result<void> parts() {
    const auto list = [&](const store::PageRequest& page) { return store_.parts().list(page); };
    return each<store::Part>(list, [&](const store::Part& newest) -> app::Result<void> {
      auto rows = rows_of(newest, [&](const auto& page) { return store_.parts().revisions(newest.number, page); });
      if (!rows) return std::unexpected(rows.error());
      auto of = document(newest.number, std::move(*rows), "parts", ".json",
                         [](const store::Part& one) { return std::string_view(one.made_of.values); });
      if (!of) return std::unexpected(of.error());
      of->family = newest.made_of.family;
      manifest_.parts.push_back(std::move(*of));
      return {};
    });
  }

  app::Result<void> machines() {
    const auto list = [&](const store::PageRequest& page) { return store_.machines().list(page); };
    return each<store::Machine>(list, [&](const store::Machine& newest) -> app::Result<void> {
      auto of = document(newest.name, std::vector<store::Machine>{newest}, "machines", ".json",
                         [](const store::Machine& one) { return std::string_view(one.profile); });
      if (!of) return std::unexpected(of.error());
      manifest_.machines.push_back(std::move(*of));
      return {};
    });
  }

  app::Result<void> attachments() {
    const auto list = [&](const store::PageRequest& page) { return store_.attachments().list(page); };
    return each<store::Attachment>(list, [&](const store::Attachment& one) -> app::Result<void> {
      if (one.of.to.order != 0) return {};  // orders are not in it
      auto file = write_content(fmt::format("attachments/{}/{}", one.id, file_step(one.of.name)), one.of.sha256);
      if (!file) return std::unexpected(file.error());
      file->by = one.added_by;
      file->at_ms = one.added_at_ms;
      manifest_.attachments.push_back(
          {.to = one.of.to, .name = one.of.name, .media_type = one.of.media_type, .file = std::move(*file)});
      return {};
    });
  }

  store::Store& store_;
  const ExportOptions& options_;
  app::ShopManifest manifest_;
  std::set<std::string> taken_;
};

int export_shop(const ExportOptions& options) {
  std::error_code fault;
  if (fs::exists(options.folder, fault) && !fs::is_empty(options.folder, fault)) {
    print_error(fmt::format("{} is there and not empty: give a new folder", options.folder));
    return kWrongUse;
  }
  const auto store = open_existing({.data = options.data, .url = options.store});
  if (!store) {
    print_error(store::message_of(store.error()));
    return kWrongUse;
  }
  const auto manifest = Exporter(**store, options).run();
  if (!manifest) {
    print_error(manifest.error());
    return kWrongUse;
  }
  fmt::print("{}: {} programs, {} families, {} parts, {} machines, {} attached files\n", options.folder,
             manifest->programs.size(), manifest->families.size(), manifest->parts.size(), manifest->machines.size(),
             manifest->attachments.size());
  return kDone;
}

}  // namespace

void add_export(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("export", "All of a server's programs, families, parts and files as files");
  const auto options = std::make_shared<ExportOptions>();
  command->add_option("FOLDER", options->folder, "where they go; new or empty")->required();
  command->add_option("--data", options->data, "folder of the store")->capture_default_str();
  command->add_option("--store", options->store, kStoreOption);
  command->add_flag("--all-revisions", options->all_revisions, "the older texts, too");
  command->footer(kFooter);
  command->callback([options, &exit_code] { exit_code = export_shop(*options); });
}

}  // namespace dripfeed::cli

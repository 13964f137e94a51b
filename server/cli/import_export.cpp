// What an export has, into a store: families, parts, programs, attached files, in this order, for each names those
// before it. Of what the store has already only the newest revision counts.
#include <map>
#include <optional>

#include <fmt/format.h>

#include "dialects/compile/render/render.h"
#include "server/app/library/attachments.h"
#include "server/app/shop/catalog.h"
#include "server/cli/folder_files.h"
#include "server/cli/import_folder.h"
#include "server/io/steady_clock.h"
#include "server/json/documents.h"
#include "server/json/shop_manifest.h"
#include "store/hash/sha256.h"

namespace dripfeed::cli {

namespace {

namespace fs = std::filesystem;
using app::ImportOutcome;

constexpr std::uint64_t kLargestManifest_bytes = std::uint64_t{1} << 30U;

// A link on the path would lead out of the folder.
bool passes_a_link(const fs::path& folder, const std::string& path) {
  fs::path at = folder;
  for (const fs::path& step : fs::path(path)) {
    std::error_code fault;
    at /= step;
    if (fs::is_symlink(fs::symlink_status(at, fault))) return true;
  }
  return false;
}

class ExportImport {
 public:
  ExportImport(store::Store& store, const FolderImport& order, const app::OnImported& on_imported)
      : store_(store),
        order_(order),
        on_imported_(on_imported),
        programs_(store, clock_, documents_),
        attachments_(store, clock_),
        importer_(store, programs_, clock_, order.plan) {}

  void run(const app::ShopManifest& manifest) {
    for (const app::ShopDocument& family : manifest.families) bring_all("family", family, &ExportImport::family);
    for (const app::ShopDocument& part : manifest.parts) bring_all("part", part, &ExportImport::part);
    for (const app::ShopDocument& machine : manifest.machines)
      report(machine.revisions.back(), "machine",
             {.outcome = ImportOutcome::skipped,
              .why = "an admin adds machines: their lines are of another place",
              .name = machine.name});
    for (const app::ShopProgram& program : manifest.programs) bring(program);
    for (const app::ShopAttachment& attachment : manifest.attachments) bring(attachment);
  }

 private:
  using Step = app::Result<app::Imported> (ExportImport::*)(const app::ShopDocument& of, const std::string& text,
                                                            bool follows);

  void report(const app::ShopFile& file, std::string_view kind, app::Imported of) {
    of.bytes = file.bytes;
    of.sha256 = file.sha256;
    on_imported_({.file = file.path, .kind = std::string(kind), .of = std::move(of)});
  }

  app::Result<std::string> bytes_of(const app::ShopFile& file) {
    if (passes_a_link(order_.folder, file.path))
      return app::fail(app::ErrorCode::invalid, "a link leads to it: that is not followed");
    auto bytes = read_file(order_.folder / file.path, app::kLargestProgram_bytes);
    if (bytes && hash::sha256_hex(*bytes) != file.sha256)
      return app::fail(app::ErrorCode::invalid, "its bytes do not have the hash that the manifest states");
    return bytes;
  }

  [[nodiscard]] store::Stamp stamp() const { return {order_.plan.actor, clock_.wall_ms()}; }
  [[nodiscard]] bool only_looks() const { return order_.plan.only_look; }

  // All revisions of what is new here, the newest of what is known.
  void bring_all(std::string_view kind, const app::ShopDocument& of, Step step) {
    bool follows = false;
    for (std::size_t i = 0; i < of.revisions.size(); ++i) {
      const app::ShopFile& file = of.revisions[i];
      const bool is_newest = i + 1 == of.revisions.size();
      if (!is_newest && !follows && is_known(kind, of.name)) continue;
      const auto text = bytes_of(file);
      auto placed = text ? (this->*step)(of, *text, follows) : std::unexpected(text.error());
      if (!placed) {
        report(file, kind, {.why = placed.error().text, .name = of.name});
        if (!follows) return;  // without its first revision none can follow
        continue;
      }
      follows = true;
      report(file, kind, std::move(*placed));
    }
  }

  bool is_known(std::string_view kind, const std::string& name) {
    return kind == "part" ? store_.parts().get(name).has_value() : store_.families().get(name).has_value();
  }

  // Of what is known with another text: whether it stays.
  std::optional<app::Imported> stays(const std::string& name, bool is_same, bool follows) const {
    if (is_same) return app::Imported{.outcome = ImportOutcome::same, .name = name};
    if (follows || order_.plan.known == app::KnownName::revise) return std::nullopt;
    return app::Imported{
        .outcome = ImportOutcome::skipped, .why = "the name is in use with another text", .name = name};
  }

  app::Result<app::Imported> family(const app::ShopDocument& of, const std::string& text, bool follows) {
    const text::Source source("family", text);
    const auto described = compile::describe_family(source);
    if (auto fine = app::refuse_errors(described.diagnostics, source, "the family"); !fine)
      return std::unexpected(fine.error());
    if (described.name != of.name)
      return app::fail(app::ErrorCode::invalid, fmt::format("its text is of family \"{}\"", described.name));
    const auto known = store_.families().get(of.name);
    if (known)
      if (auto kept = stays(of.name, known->text == text, follows)) return std::move(*kept);
    app::Imported done{.outcome = known ? ImportOutcome::revised : ImportOutcome::added, .name = of.name};
    if (only_looks()) return done;
    const auto put = app::lift(known ? store_.families().change(of.name, known->revision, text, stamp())
                                     : store_.families().add(of.name, text, stamp()));
    if (!put) return std::unexpected(put.error());
    done.revision = put->revision;
    return done;
  }

  app::Result<store::PartValues> checked_values(const app::ShopDocument& of, const std::string& text) {
    const auto values = documents_.read_values(text);
    if (!values) return std::unexpected(values.error());
    const auto family = app::lift(store_.families().get(of.family));
    if (!family) return std::unexpected(family.error());
    const text::Source source(family->name, family->text);
    const auto bound = compile::check_values(source, app::overrides_of(*values));
    if (auto fine = app::refuse_errors(bound, source, "the part"); !fine) return std::unexpected(fine.error());
    return store::PartValues{
        .family = family->name, .family_revision = family->revision, .values = documents_.write_values(*values)};
  }

  app::Result<app::Imported> part(const app::ShopDocument& of, const std::string& text, bool follows) {
    const auto known = store_.parts().get(of.name);
    app::Imported done{.outcome = known ? ImportOutcome::revised : ImportOutcome::added, .name = of.name};
    if (!known && only_looks()) return done;  // its family may be one that an import would bring
    const auto values = checked_values(of, text);
    if (!values) return std::unexpected(values.error());
    if (known && known->made_of.family != values->family)
      return app::fail(app::ErrorCode::refused,
                       fmt::format("the part is of family \"{}\" here", known->made_of.family));
    if (known)
      if (auto kept = stays(of.name, known->made_of.values == values->values, follows)) return std::move(*kept);
    if (only_looks()) return done;
    const auto put = app::lift(known ? store_.parts().change(of.name, known->revision, *values, stamp())
                                     : store_.parts().add(of.name, *values, stamp()));
    if (!put) return std::unexpected(put.error());
    done.revision = put->revision;
    return done;
  }

  // Under the folder that the command names.
  [[nodiscard]] std::string folder_of(const app::ShopProgram& program) const {
    if (order_.under.empty() || program.folder.empty()) return order_.under + program.folder;
    return order_.under + "/" + program.folder;
  }

  void bring(const app::ShopProgram& program) {
    const std::string folder = folder_of(program);
    const auto known = importer_.knows(folder, program.name);
    const std::size_t first = known && *known ? program.revisions.size() - 1 : 0;
    for (std::size_t i = first; i < program.revisions.size(); ++i) {
      const app::ShopFile& file = program.revisions[i];
      const auto text = bytes_of(file);
      app::Imported done{.why = text ? std::string() : text.error().text, .name = program.name, .folder = folder};
      if (text)
        done = importer_.import({.name = program.name,
                                 .folder = folder,
                                 .text = *text,
                                 .dialect = program.dialect,
                                 .tags = program.tags,
                                 .follows = i > first});
      const bool failed = done.outcome == ImportOutcome::failed;
      if (!failed) programs_here_[program.id] = done.program;
      const bool is_new = first == 0 && known && !*known && i + 1 == program.revisions.size();
      if (!failed && is_new) archive(program, done);
      report(file, "program", std::move(done));
      if (failed) return;
    }
  }

  void archive(const app::ShopProgram& program, app::Imported& done) {
    if (program.archived.at_ms == 0 || only_looks()) return;
    const auto archived = store_.programs().archive(done.program, program.archived.reason, stamp());
    if (archived) return;
    done.outcome = ImportOutcome::failed;
    done.why = fmt::format("it is here, but not archived: {}", store::message_of(archived.error()));
  }

  void bring(const app::ShopAttachment& attachment) {
    auto placed = place(attachment);
    if (!placed) placed = app::Imported{.why = placed.error().text};
    placed->name = attachment.name;
    report(attachment.file, "attachment", std::move(*placed));
  }

  app::Result<store::AttachedTo> owner_of(const app::ShopAttachment& attachment) {
    store::AttachedTo to = attachment.to;
    if (to.program == 0) return to;
    const auto here = programs_here_.find(to.program);
    if (here == programs_here_.end()) return app::fail(app::ErrorCode::invalid, "its program was not imported");
    to.program = here->second;
    return to;
  }

  app::Result<app::Imported> place(const app::ShopAttachment& attachment) {
    const auto to = owner_of(attachment);
    if (!to) return std::unexpected(to.error());
    const auto bytes = bytes_of(attachment.file);
    if (!bytes) return std::unexpected(bytes.error());
    if (only_looks() && to->program == 0) return app::Imported{.outcome = ImportOutcome::added};
    const auto known = app::lift(store_.attachments().list({.limit = store::kPageLimitMax, .after = {}}, *to));
    if (!known) return std::unexpected(known.error());
    for (const store::Attachment& one : known->items) {
      if (one.of.name != attachment.name) continue;
      if (one.of.sha256 == attachment.file.sha256) return app::Imported{.outcome = ImportOutcome::same};
      return app::Imported{.outcome = ImportOutcome::skipped, .why = "another file of this name is attached"};
    }
    if (only_looks()) return app::Imported{.outcome = ImportOutcome::added};
    std::string_view rest = *bytes;
    const auto kept = attachments_.keep(
        {.to = *to, .name = attachment.name, .media_type = app::media_type_of(attachment.media_type), .sha256 = {}},
        bytes->size(), [&rest](std::span<char> into) -> std::expected<std::size_t, std::string> {
          const std::size_t count = rest.copy(into.data(), into.size());
          rest.remove_prefix(count);
          return count;
        });
    if (!kept) return std::unexpected(kept.error());
    const auto added = attachments_.add(*kept, order_.plan.actor);
    if (!added) return std::unexpected(added.error());
    return app::Imported{.outcome = ImportOutcome::added};
  }

  store::Store& store_;
  const FolderImport& order_;
  const app::OnImported& on_imported_;
  io::SteadyClock clock_;
  json::JsonDocuments documents_;
  app::Programs programs_;
  app::Attachments attachments_;
  app::Importer importer_;
  std::map<store::Id, store::Id> programs_here_;  // by their ids in the export; 0: it would be added
};

}  // namespace

app::Result<void> import_export(store::Store& store, const FolderImport& order, const app::OnImported& on_imported) {
  const auto text = read_file(order.folder / app::kManifestFile, kLargestManifest_bytes);
  if (!text) return std::unexpected(text.error());
  const auto manifest = json::read_manifest(*text);
  if (!manifest) return std::unexpected(manifest.error());
  ExportImport(store, order, on_imported).run(*manifest);
  return {};
}

}  // namespace dripfeed::cli

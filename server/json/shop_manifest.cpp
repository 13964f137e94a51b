// A manifest comes from a folder that others may have written: what it names is looked at before it is believed.
#include "server/json/shop_manifest.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "server/json/object_reader.h"
#include "server/json/parse.h"

namespace dripfeed::json {

namespace {

constexpr std::string_view kFormat = "dripfeed-export";
constexpr std::size_t kMostManifestValues = 50'000'000;
constexpr std::int64_t kMostNumber = INT64_MAX;
constexpr std::size_t kHash_chars = 64;

Document file_document(const app::ShopFile& file) {
  return {{"path", file.path},         {"sha256", file.sha256}, {"bytes", file.bytes},
          {"revision", file.revision}, {"by", file.by},         {"at_ms", file.at_ms}};
}

Document files_document(const std::vector<app::ShopFile>& files) {
  Document list = Document::array();
  for (const app::ShopFile& file : files) list.push_back(file_document(file));
  return list;
}

Document program_document(const app::ShopProgram& program) {
  Document archived = nullptr;
  if (program.archived.at_ms != 0)
    archived = {{"by", program.archived.by}, {"reason", program.archived.reason}, {"at_ms", program.archived.at_ms}};
  return {{"id", program.id},
          {"name", program.name},
          {"dialect", program.dialect},
          {"folder", program.folder},
          {"tags", program.tags},
          {"archived", std::move(archived)},
          {"revisions", files_document(program.revisions)}};
}

Document documents_document(const std::vector<app::ShopDocument>& documents, bool of_family) {
  Document list = Document::array();
  for (const app::ShopDocument& one : documents) {
    Document document = {{"name", one.name}};
    if (of_family) document["family"] = one.family;
    document["revisions"] = files_document(one.revisions);
    list.push_back(std::move(document));
  }
  return list;
}

Document attachment_document(const app::ShopAttachment& one) {
  Document document = {{"name", one.name}, {"media_type", one.media_type}};
  if (one.to.program != 0) document["program"] = one.to.program;
  if (!one.to.family.empty()) document["family"] = one.to.family;
  if (!one.to.part.empty()) document["part"] = one.to.part;
  document["file"] = file_document(one.file);
  return document;
}

// Down from where the manifest lies, and nowhere else.
bool leads_down(std::string_view path) {
  if (path.empty() || path.find('\\') != std::string_view::npos || path.find('\0') != std::string_view::npos)
    return false;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string_view segment = path.substr(begin, end - begin);
    if (segment.empty() || segment == "." || segment == "..") return false;
    begin = end + 1;
  }
  return true;
}

bool is_hash(std::string_view text) {
  return text.size() == kHash_chars &&
         std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

void read_file(ObjectReader& o, app::ShopFile& into) {
  o.text("path", into.path, true);
  if (!leads_down(into.path)) o.fault("path", "must lead down from the folder of the manifest");
  o.text("sha256", into.sha256, true);
  if (!is_hash(into.sha256)) o.fault("sha256", "must be 64 hexadecimal digits");
  o.integer("bytes", into.bytes, 0, kMostNumber, true);
  o.integer("revision", into.revision, 1, kMostNumber, true);
  o.text("by", into.by);
  o.integer("at_ms", into.at_ms, 0, kMostNumber);
  o.finish();
}

void read_revisions(ObjectReader& o, std::vector<app::ShopFile>& into) {
  o.objects("revisions", [&](ObjectReader& file) { read_file(file, into.emplace_back()); }, true);
  if (into.empty()) o.fault("revisions", "must not be empty");
}

void read_program(ObjectReader& o, app::ShopProgram& into) {
  o.integer("id", into.id, 1, kMostNumber, true);
  o.text("name", into.name, true);
  o.text("dialect", into.dialect, true);
  o.text("folder", into.folder);
  if (const Document* tags = o.member("tags", list_of(text(""), "")); tags != nullptr && tags->is_array())
    for (const Document& tag : *tags)
      if (tag.is_string()) into.tags.push_back(tag.get<std::string>());
  o.object("archived", [&](ObjectReader& archived) {
    archived.text("by", into.archived.by);
    archived.text("reason", into.archived.reason, true);
    archived.integer("at_ms", into.archived.at_ms, 1, kMostNumber, true);
    archived.finish();
  });
  read_revisions(o, into.revisions);
  o.finish();
}

void read_documents(ObjectReader& o, std::string_view name, std::vector<app::ShopDocument>& into, bool of_family) {
  o.objects(name, [&](ObjectReader& one) {
    app::ShopDocument& document = into.emplace_back();
    one.text("name", document.name, true);
    if (of_family) one.text("family", document.family, true);
    read_revisions(one, document.revisions);
    one.finish();
  });
}

void read_attachment(ObjectReader& o, app::ShopAttachment& into) {
  o.text("name", into.name, true);
  o.text("media_type", into.media_type, true);
  o.integer("program", into.to.program, 1, kMostNumber);
  o.text("family", into.to.family);
  o.text("part", into.to.part);
  o.object("file", [&](ObjectReader& file) { read_file(file, into.file); }, true);
  o.finish();
}

void read_members(ObjectReader& o, app::ShopManifest& into) {
  constexpr std::array<std::string_view, 1> kFormats = {kFormat};
  std::uint64_t version = 0;
  o.choice("format", kFormats, true);
  o.integer("version", version, 1, static_cast<std::int64_t>(app::kManifestVersion), true);
  o.integer("made_at_ms", into.made_at_ms, 0, kMostNumber);
  o.objects("programs", [&](ObjectReader& one) { read_program(one, into.programs.emplace_back()); });
  read_documents(o, "families", into.families, false);
  read_documents(o, "parts", into.parts, true);
  read_documents(o, "machines", into.machines, false);
  o.objects("attachments", [&](ObjectReader& one) { read_attachment(one, into.attachments.emplace_back()); });
  o.finish();
}

}  // namespace

std::string write_manifest(const app::ShopManifest& manifest) {
  Document programs = Document::array();
  for (const app::ShopProgram& program : manifest.programs) programs.push_back(program_document(program));
  Document attachments = Document::array();
  for (const app::ShopAttachment& one : manifest.attachments) attachments.push_back(attachment_document(one));
  return dump({{"format", kFormat},
               {"version", app::kManifestVersion},
               {"made_at_ms", manifest.made_at_ms},
               {"programs", std::move(programs)},
               {"families", documents_document(manifest.families, false)},
               {"parts", documents_document(manifest.parts, true)},
               {"machines", documents_document(manifest.machines, false)},
               {"attachments", std::move(attachments)}});
}

app::Result<app::ShopManifest> read_manifest(std::string_view text) {
  const auto document = parse(text, kMostManifestValues);
  if (!document) return std::unexpected(document.error());
  if (!document->is_object()) return app::fail(app::ErrorCode::malformed, "the manifest is not an object");
  std::vector<app::ErrorPlace> faults;
  app::ShopManifest manifest;
  ObjectReader reader(*document, "", faults);
  read_members(reader, manifest);
  if (!faults.empty()) return app::fail(app::ErrorCode::invalid, "the manifest has faults", std::move(faults));
  return manifest;
}

std::string import_report(std::span<const app::ImportRow> rows, bool only_looked) {
  std::array<std::uint64_t, app::kImportOutcomes.size()> counts{};
  Document items = Document::array();
  for (const app::ImportRow& row : rows) {
    const app::Imported& of = row.of;
    ++counts.at(static_cast<std::size_t>(of.outcome));
    items.push_back({{"file", row.file},
                     {"kind", row.kind},
                     {"outcome", app::kImportOutcomes.at(static_cast<std::size_t>(of.outcome))},
                     {"why", text_or_null(of.why)},
                     {"why_said", sentence_or_null(of.why)},
                     {"name", text_or_null(of.name)},
                     {"folder", text_or_null(of.folder)},
                     {"dialect", text_or_null(of.dialect)},
                     {"program", id_or_null(of.program)},
                     {"revision", id_or_null(of.revision)},
                     {"bytes", of.bytes},
                     {"sha256", text_or_null(of.sha256)}});
  }
  Document report = Document::object();
  for (std::size_t i = 0; i < counts.size(); ++i) report[std::string(app::kImportOutcomes.at(i))] = counts.at(i);
  report["only_looked"] = only_looked;
  report["items"] = std::move(items);
  return dump(report);
}

}  // namespace dripfeed::json

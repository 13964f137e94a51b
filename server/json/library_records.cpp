// Families, parts and programs; what rendering gave, what was found by words, where a program is used, and the store
// that holds them all.
#include <algorithm>
#include <utility>

#include "server/json/diagnostics.h"
#include "server/json/parse.h"
#include "server/json/records.h"

namespace dripfeed::json {

namespace {

Document origin_document(const store::Origin& origin) {
  Document document = {{"kind", store::name_of(origin.kind)}};
  if (origin.kind == store::OriginKind::uploaded) return document;
  document["family"] = origin.family;
  document["family_revision"] = origin.family_revision;
  document["part"] = text_or_null(origin.part);
  document["part_revision"] = origin.part_revision;
  document["machine"] = origin.machine;
  document["machine_revision"] = origin.machine_revision;
  document["mode"] = origin.mode;
  return document;
}

Document revision_document(const store::ProgramRevision& revision) {
  return {{"revision", revision.revision},
          {"sha256", revision.sha256},
          {"bytes", revision.bytes},
          {"blocks", revision.blocks},
          {"origin", origin_document(revision.origin)},
          {"created_by", revision.created_by},
          {"created_at_ms", revision.created_at_ms}};
}

Document family_document(const store::Family& family, std::string_view title) {
  return {{"name", family.name},
          {"title", title},
          {"revision", family.revision},
          {"changed_by", family.changed_by},
          {"changed_at_ms", family.changed_at_ms}};
}

Document call_members(const store::ProgramCall& call) {
  return {{"called", call.name}, {"kind", store::name_of(call.kind)}, {"line", call.line}};
}

Document program_reference(const store::Program& program) {
  return {{"program", program.id}, {"name", program.name}, {"is_archived", program.is_archived()}};
}

Document parts_document(const app::ProgramUses& uses) {
  Document list = Document::array();
  for (const app::ProgramUses::OfPart& one : uses.parts)
    list.push_back({{"number", one.number}, {"part_revision", one.part_revision}, {"revision", one.revision}});
  return list;
}

Document machines_document(const app::ProgramUses& uses) {
  Document list = Document::array();
  for (const app::ProgramUses::OfMachine& one : uses.machines)
    list.push_back({{"machine", one.machine}, {"releases", one.releases}, {"jobs", one.jobs}});
  return list;
}

Document callers_document(const app::ProgramUses& uses) {
  Document list = Document::array();
  for (const app::ProgramUses::Caller& one : uses.callers) {
    Document caller = program_reference(one.program);
    caller.update(call_members(one.call));
    list.push_back(std::move(caller));
  }
  return list;
}

Document calls_document(const app::ProgramUses& uses) {
  Document list = Document::array();
  for (const app::ProgramUses::Called& one : uses.calls) {
    Document call = call_members(one.call);
    call["programs"] = Document::array();
    for (const store::Program& program : one.programs) call["programs"].push_back(program_reference(program));
    list.push_back(std::move(call));
  }
  return list;
}

template <class Row, class Write>
Document list_of_rows(const std::vector<Row>& rows, const Write& write) {
  Document list = Document::array();
  for (const Row& row : rows) list.push_back(embedded(write(row)));
  return list;
}

// No one may take a list for whole that is not.
Document why_calls_may_be_missing(const app::ProgramUses& uses) {
  if (!uses.known.is_known) return "the program is not in the library yet";
  return text_or_null(uses.known.not_read);
}

}  // namespace

std::string family_summary(const store::Family& family, std::string_view title) {
  return dump(family_document(family, title));
}

std::string family(const store::Family& family, const compile::FamilyDescription& description) {
  Document document = family_document(family, description.title);
  document["text"] = family.text;
  Document parameters = Document::array();
  for (const compile::ParameterDescription& p : description.parameters) {
    const bool has_range = p.choices.empty() && p.kind != "text";
    parameters.push_back({{"name", p.name},
                          {"kind", p.kind},
                          {"unit", p.unit},
                          {"default", p.standard},
                          {"low", has_range ? Document(p.low) : Document()},
                          {"high", has_range ? Document(p.high) : Document()},
                          {"step", p.step},
                          {"choices", p.choices},
                          {"fewest", p.fewest},
                          {"most", p.most},
                          {"text", p.text},
                          {"group", p.group}});
  }
  document["parameters"] = std::move(parameters);
  return dump(document);
}

std::string part(const store::Part& part) {
  return dump({{"number", part.number},
               {"revision", part.revision},
               {"family", part.made_of.family},
               {"family_revision", part.made_of.family_revision},
               {"values", embedded(part.made_of.values)},
               {"changed_by", part.changed_by},
               {"changed_at_ms", part.changed_at_ms}});
}

std::string program(const store::Program& program) {
  Document archived = nullptr;
  if (program.is_archived())
    archived = {{"by", program.archived.by}, {"reason", program.archived.reason}, {"at_ms", program.archived.at_ms}};
  Document deleted = nullptr;
  if (program.is_deleted())
    deleted = {{"by", program.deleted.by}, {"reason", program.deleted.reason}, {"at_ms", program.deleted.at_ms}};
  Document document = {{"id", program.id},
                       {"name", program.name},
                       {"dialect", program.dialect},
                       {"tags", program.tags},
                       {"folder", text_or_null(program.folder)},
                       {"archived", std::move(archived)},
                       {"deleted", std::move(deleted)}};
  document.update(revision_document(program.newest));
  return dump(document);
}

std::string program_revision(const store::ProgramRevision& revision) {
  Document document = {{"id", revision.program}};
  document.update(revision_document(revision));
  return dump(document);
}

std::string search_result(std::span<const SearchHit> hits, std::string_view next, const store::LibraryState& state,
                          std::uint64_t waiting) {
  Document items = Document::array();
  for (const SearchHit& one : hits) {
    Document snippet = Document::array();
    for (const store::SnippetPart& part : one.hit.snippet)
      snippet.push_back({{"text", part.text}, {"is_hit", part.is_hit}});
    items.push_back({{"is_similar", one.hit.is_similar},
                     {"snippet", std::move(snippet)},
                     {"program", embedded(program(one.program))}});
  }
  return dump({{"items", std::move(items)},
               {"next", text_or_null(std::string(next))},
               {"programs", state.programs},
               {"waiting", waiting},
               {"cut", state.cut}});
}

std::string legend(std::span<const compile::LegendEntry> entries) {
  Document out = Document::array();
  for (const compile::LegendEntry& one : entries)
    out.push_back({{"variable", one.variable},
                   {"count", one.count},
                   {"name", one.name},
                   {"meaning", text_or_null(one.meaning)},
                   {"unit", text_or_null(one.unit)},
                   {"kind", compile::kLegendKindNames.at(static_cast<std::size_t>(one.kind))},
                   {"value", one.value ? Document(*one.value) : Document(nullptr)}});
  return dump(out);
}

std::vector<compile::LegendEntry> read_legend(std::string_view text) {
  const auto text_of = [](const Document& member) { return member.is_null() ? "" : member.get<std::string>(); };
  std::vector<compile::LegendEntry> out;
  for (const Document& one : Document::parse(text)) {
    const auto kind = std::ranges::find(compile::kLegendKindNames, one.at("kind").get<std::string>());
    compile::LegendEntry entry{.variable = one.at("variable").get<std::string>(),
                               .count = one.at("count").get<std::uint32_t>(),
                               .name = one.at("name").get<std::string>(),
                               .meaning = text_of(one.at("meaning")),
                               .unit = text_of(one.at("unit")),
                               .kind = static_cast<compile::LegendKind>(kind - compile::kLegendKindNames.begin())};
    if (!one.at("value").is_null()) entry.value = one.at("value").get<double>();
    out.push_back(std::move(entry));
  }
  return out;
}

std::string rendered(const app::Rendered& rendered, const text::Source& family) {
  const compile::RenderResult& r = rendered.result;
  return dump({{"program", rendered.program.id},
               {"name", rendered.program.name},
               {"revision", rendered.program.newest.revision},
               {"mode", compile::name_of(r.mode)},
               {"because", r.because},
               {"blocks", r.blocks},
               {"bytes", r.bytes},
               {"variables", r.variables},
               {"legend", embedded(legend(r.legend))},
               {"sha256", rendered.program.newest.sha256},
               {"diagnostics", embedded(diagnostics(r.diagnostics, family))}});
}

std::string preview(const app::Preview& preview) {
  const compile::RenderResult& r = preview.result;
  return dump({{"text", r.text},
               {"mode", compile::name_of(r.mode)},
               {"because", r.because},
               {"blocks", r.blocks},
               {"bytes", r.bytes},
               {"variables", r.variables},
               {"legend", embedded(legend(r.legend))},
               {"diagnostics", embedded(diagnostics(r.diagnostics, {preview.family, preview.family_text}))},
               {"drawing", embedded(preview.drawing)}});
}

std::string program_uses(const app::ProgramUses& uses) {
  return dump({{"parts", parts_document(uses)},
               {"machines", machines_document(uses)},
               {"releases", list_of_rows(uses.releases, release)},
               {"has_more_releases", uses.has_more_releases},
               {"jobs", list_of_rows(uses.jobs, job)},
               {"has_more_jobs", uses.has_more_jobs},
               {"called_by", callers_document(uses)},
               {"calls", calls_document(uses)},
               {"computed_calls", uses.known.computed},
               {"calls_not_known", why_calls_may_be_missing(uses)},
               {"waiting", uses.waiting},
               {"unread", uses.unread}});
}

std::string attachment(const store::Attachment& attachment) {
  const store::AttachedTo& to = attachment.of.to;
  const auto id_or_null = [](store::Id id) { return id == 0 ? Document(nullptr) : Document(id); };
  Document removed = nullptr;
  if (attachment.is_removed())
    removed = {
        {"by", attachment.removed_by}, {"reason", attachment.removed_reason}, {"at_ms", attachment.removed_at_ms}};
  return dump({{"id", attachment.id},
               {"program", id_or_null(to.program)},
               {"family", text_or_null(to.family)},
               {"part", text_or_null(to.part)},
               {"order", id_or_null(to.order)},
               {"name", attachment.of.name},
               {"media_type", attachment.of.media_type},
               {"bytes", attachment.bytes},
               {"sha256", attachment.of.sha256},
               {"added_by", attachment.added_by},
               {"added_at_ms", attachment.added_at_ms},
               {"removed", std::move(removed)}});
}

std::string store_room(const app::StoreRoom& room) {
  const auto known = [](std::uint64_t bytes) { return bytes == 0 ? Document(nullptr) : Document(bytes); };
  const auto given = [](const std::string& text) { return text.empty() ? Document(nullptr) : Document(text); };
  return dump({{"engine", room.engine},
               {"folder", room.folder},
               {"bytes", known(room.bytes)},
               {"free_bytes", known(room.free_bytes)},
               {"backups", given(room.backups)},
               {"backups_free_bytes", known(room.backups_free_bytes)},
               {"why_no_backups", given(room.why_no_backups)}});
}

std::string backup(const app::BackupFile& file) {
  return dump({{"name", file.name}, {"bytes", file.bytes}, {"made_at_ms", file.made_at_ms}});
}

}  // namespace dripfeed::json

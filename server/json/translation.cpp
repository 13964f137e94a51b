// What was refused has no text: half of one would be cut.
#include "server/json/translation.h"

#include <utility>

#include "server/json/diagnostics.h"
#include "server/json/parse.h"

namespace dripfeed::json {

namespace {

Document document_of(const compile::ConvertResult& result, const text::Source& source) {
  const bool failed = text::has_error(result.diagnostics);
  return {{"text", failed ? Document(nullptr) : Document(result.text)},
          {"verified", !failed && result.not_verified.empty()},
          {"not_verified", text_or_null(result.not_verified)},
          {"origins", result.origin_lines},
          {"diagnostics", embedded(diagnostics(result.diagnostics, source))},
          {"folded", embedded(folded_diagnostics(result.diagnostics))}};
}

}  // namespace

std::string translation(const compile::ConvertResult& result, const text::Source& source) {
  return dump(document_of(result, source));
}

std::string translation(const app::Translation& translation, compile::ConvertMode mode) {
  Document document = {{"from", translation.from}, {"to", translation.to}, {"mode", compile::name_of(mode)}};
  document.update(document_of(translation.result, translation.source));
  return dump(document);
}

std::string rewritten(const app::Rewritten& rewritten) {
  Document refused = Document::array();
  for (const compile::RenumberRefusal& one : rewritten.refused)
    refused.push_back({{"line", id_or_null(one.line)}, {"text", one.text}});
  return dump({{"text", rewritten.refused.empty() ? Document(rewritten.text) : Document(nullptr)},
               {"numbers", rewritten.numbers},
               {"references", rewritten.references},
               {"assumptions", rewritten.assumptions},
               {"refused", std::move(refused)}});
}

std::string value_changes(const app::ValueChanges& changes) {
  Document values = Document::array();
  for (const app::ChangedValue& one : changes.values)
    values.push_back({{"name", one.name}, {"before", one.before}, {"after", one.after}});
  Document rest = Document::array();
  for (const app::LeftOver& one : changes.rest)
    rest.push_back({{"line", one.line}, {"stored", one.stored}, {"received", one.received}});
  return dump({{"explains_all", changes.explains_all},
               {"why_not", text_or_null(changes.why_not)},
               {"values", std::move(values)},
               {"rest", std::move(rest)}});
}

std::string received_values(std::string_view changes, const store::ProgramRevision& stored) {
  Document document = Document::parse(changes);
  const store::Origin& origin = stored.origin;
  document["program"] = stored.program;
  document["revision"] = stored.revision;
  document["family"] = origin.family;
  document["part"] = text_or_null(origin.part);
  document["part_revision"] = id_or_null(origin.part_revision);
  return dump(document);
}

}  // namespace dripfeed::json

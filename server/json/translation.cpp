// What was refused has no text: half of one would be cut.
#include "server/json/translation.h"

#include <array>
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

// --- optimized: one row a change, and one a rule that changed something

namespace {

Document cost_of_run(const std::optional<compile::ComputeCost>& cost) {
  if (!cost) return nullptr;
  return {{"total_ms", cost->total_ms},
          {"longest_ms", cost->longest_ms},
          {"longest_line", cost->longest_line},
          {"moves", cost->moves},
          {"blocks", cost->blocks}};
}

Document saving_of(const std::optional<compile::Saving>& saved) {
  if (!saved) return nullptr;
  return {{"ms", saved->ms}, {"least_ms", saved->least_ms}, {"most_ms", saved->most_ms}};
}

Document passes_of(const compile::OptimizeResult& result) {
  Document out = Document::array();
  for (const compile::RuleSaving& one : result.savings)
    out.push_back({{"rule", optimize::row_of(one.rule).name}, {"edits", one.edits}, {"saved", saving_of(one.saved)}});
  if (!result.savings.empty()) return out;
  // Not run: what was changed, without figures.
  std::array<std::size_t, optimize::kRules> edits{};
  for (const optimize::Change& change : result.changes) ++edits[static_cast<std::size_t>(change.rule)];
  for (std::size_t i = 0; i < optimize::kRules; ++i)
    if (edits[i] > 0) out.push_back({{"rule", optimize::kRuleRows[i].name}, {"edits", edits[i]}, {"saved", nullptr}});
  return out;
}

Document not_inlined(const compile::OptimizeResult& result) {
  Document out = Document::array();
  for (const compile::KeptCall& one : result.not_inlined)
    out.push_back({{"line", one.line}, {"program", text_or_null(one.program)}, {"why", one.why}});
  return out;
}

}  // namespace

std::string optimized(const compile::OptimizeResult& result, const ir::CostModel& cost, const text::Source& source) {
  Document changes = Document::array();
  for (const optimize::Change& change : result.changes)
    changes.push_back({{"line", change.line}, {"rule", optimize::row_of(change.rule).name}, {"what", change.what}});
  return dump({{"text", text::has_error(result.diagnostics) ? Document(nullptr) : Document(result.text)},
               {"origins", result.origin_lines},
               {"passes", passes_of(result)},
               {"changes", std::move(changes)},
               {"left_because", text_or_null(result.obstacle)},
               {"not_verified", text_or_null(result.not_verified)},
               {"proved_max_mm", result.off_mm ? Document(*result.off_mm) : Document(nullptr)},
               {"not_merged", text_or_null(result.not_merged)},
               {"not_tabulated", text_or_null(result.not_tabulated)},
               {"not_inlined", not_inlined(result)},
               {"saved", saving_of(result.saved)},
               {"before", cost_of_run(result.before)},
               {"after", cost_of_run(result.after)},
               {"cost", {{"source", ir::name_of(cost.source)}, {"origin", cost.origin}, {"spread", cost.spread}}},
               {"diagnostics", embedded(diagnostics(result.diagnostics, source))}});
}

}  // namespace dripfeed::json

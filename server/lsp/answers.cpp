// The protocol's numbers for kinds stand here, each by our own list.
#include "server/lsp/answers.h"

#include <array>

#include <fmt/format.h>

namespace dripfeed::lsp {

namespace {

// By text::Severity: note, warning, error.
constexpr std::array kSeverities = {3, 2, 1};
// SymbolKind, by compile::OutlineSort: module, key, function, object, event.
constexpr std::array kSymbolKinds = {2, 20, 12, 19, 24};
// CompletionItemKind, by ir::WordSort: value, keyword, function, method, variable.
constexpr std::array kProposalKinds = {12, 14, 3, 2, 6};

template <class Enum, class Numbers>
int number_of(Enum value, const Numbers& numbers) {
  return numbers[static_cast<std::size_t>(value)];
}

Document written(const Position& at) { return {{"line", at.line}, {"character", at.character}}; }
Document written(const Range& range) { return {{"start", written(range.start)}, {"end", written(range.end)}}; }

Document written(const Fault& fault, std::string_view docs) {
  Document out = {{"range", written(fault.range)},
                  {"severity", number_of(fault.severity, kSeverities)},
                  {"code", fault.name},
                  {"source", "dripfeed"},
                  {"message", fault.text}};
  if (!docs.empty()) out["codeDescription"] = {{"href", fmt::format("{}#{}", docs, fault.name)}};
  Document related = Document::array();
  for (const Related& one : fault.related) related.push_back({{"location", written(one.at)}, {"message", one.text}});
  if (!related.empty()) out["relatedInformation"] = std::move(related);
  return out;
}

Document tree_of(const Symbol& symbol) {
  Document children = Document::array();
  for (const Symbol& one : symbol.children) children.push_back(tree_of(one));
  return {{"name", symbol.name},
          {"kind", number_of(symbol.sort, kSymbolKinds)},
          {"detail", compile::name_of(symbol.sort)},
          {"range", written(symbol.whole)},
          {"selectionRange", written(symbol.line)},
          {"children", std::move(children)}};
}

void add_flat(const Symbol& symbol, const OpenText& text, Document& into) {
  into.push_back({{"name", symbol.name},
                  {"kind", number_of(symbol.sort, kSymbolKinds)},
                  {"location", written(Location{text.uri(), symbol.whole})}});
  for (const Symbol& one : symbol.children) add_flat(one, text, into);
}

}  // namespace

Document capabilities(PositionUnit unit, std::string_view version) {
  constexpr int kByRanges = 2;  // TextDocumentSyncKind.Incremental
  return {{"capabilities",
           {{"positionEncoding", kPositionUnitNames[static_cast<std::size_t>(unit)]},
            {"textDocumentSync", {{"openClose", true}, {"change", kByRanges}, {"save", {{"includeText", false}}}}},
            {"hoverProvider", true},
            {"definitionProvider", true},
            {"documentSymbolProvider", true},
            {"completionProvider", {{"triggerCharacters", {"#", "$"}}}},
            {"documentFormattingProvider", true},
            {"codeActionProvider", {{"codeActionKinds", {"quickfix", "source.fixAll"}}}}}},
          {"serverInfo", {{"name", "dripfeed"}, {"version", version}}}};
}

Document published(const OpenText& text, const std::vector<Fault>& faults, std::string_view docs) {
  Document list = Document::array();
  for (const Fault& one : faults) list.push_back(written(one, docs));
  return {{"uri", text.uri()}, {"version", text.version()}, {"diagnostics", std::move(list)}};
}

Document written(const Hover& hover) {
  return {{"contents", {{"kind", "markdown"}, {"value", hover.text}}}, {"range", written(hover.range)}};
}

Document written(const Location& location) { return {{"uri", location.uri}, {"range", written(location.range)}}; }

Document written(const TextEdit& edit) { return {{"range", written(edit.range)}, {"newText", edit.text}}; }

Document written(const Proposal& proposal) {
  const compile::DialectWord& word = *proposal.word;
  Document out = {{"label", word.spelling},
                  {"kind", number_of(word.sort, kProposalKinds)},
                  {"detail", word.about},
                  {"textEdit", written(TextEdit{proposal.replaced, word.spelling})}};
  if (!word.reference.empty()) out["documentation"] = word.reference;
  return out;
}

Document written(const Action& action, const OpenText& text, std::string_view docs) {
  Document changes = Document::object();
  changes[text.uri()] = written(action.edits);
  Document out = {{"title", action.title},
                  {"kind", action.mends ? "quickfix" : "source.fixAll"},
                  {"edit", {{"changes", std::move(changes)}}}};
  if (action.mends) out["diagnostics"] = Document::array({written(*action.mends, docs)});
  return out;
}

Document written(const std::vector<Symbol>& symbols, const OpenText& text, bool as_trees) {
  Document list = Document::array();
  for (const Symbol& one : symbols) {
    if (as_trees)
      list.push_back(tree_of(one));
    else
      add_flat(one, text, list);
  }
  return list;
}

}  // namespace dripfeed::lsp

// What the client gets, as the protocol writes it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/json/parse.h"
#include "server/lsp/params.h"

namespace dripfeed::lsp {

Document capabilities(PositionUnit unit, std::string_view version);
// The parameters of textDocument/publishDiagnostics. `docs` as Settings::docs.
Document published(const OpenText& text, const std::vector<Fault>& faults, std::string_view docs);
Document written(const Hover& hover);
Document written(const Location& location);
Document written(const TextEdit& edit);
Document written(const Proposal& proposal);
Document written(const Action& action, const OpenText& text, std::string_view docs);
// As trees, or as a list for clients that take no trees.
Document written(const std::vector<Symbol>& symbols, const OpenText& text, bool as_trees);

template <class T>
Document written(const std::vector<T>& all) {
  Document list = Document::array();
  for (const T& one : all) list.push_back(written(one));
  return list;
}

}  // namespace dripfeed::lsp

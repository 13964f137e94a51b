// What goes to a worker and comes back: one line of JSON, then texts byte for byte, because a program may be in any
// encoding. Only files of this folder include this.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/checks/diagnose.h"
#include "server/app/checks/workers.h"
#include "server/json/parse.h"

namespace dripfeed::json {

struct WorkPackage {
  Document head = Document::object();
  std::vector<std::string> texts;

  // Adds a text; its index, for the head to name it by.
  std::size_t add(std::string_view text) {
    texts.emplace_back(text);
    return texts.size() - 1;
  }
  // The text that this member of `from` names; "" where it names none.
  [[nodiscard]] const std::string& text_of(const Document& from, std::string_view member) const;
};
std::string write_package(const WorkPackage& package);
app::Result<WorkPackage> read_package(std::string_view bytes);

// Members of a head.
Document write_case(const app::CaseOrder& order, WorkPackage& into);
app::CaseOrder read_case(const Document& from, const WorkPackage& package);
Document write_called(const std::vector<app::CalledText>& called, WorkPackage& into);
std::vector<app::CalledText> read_called(const Document& from, const WorkPackage& package);
Document write_texts(const std::vector<std::string>& texts, WorkPackage& into);
std::vector<std::string> read_texts(const Document& from, const WorkPackage& package);
Document write_names(const std::set<std::string>& names, WorkPackage& into);
std::set<std::string> read_names(const Document& from, const WorkPackage& package);
Document write_family(const app::RenderWork& work, WorkPackage& into);
app::RenderWork read_family(const Document& from, const WorkPackage& package);
// All of a head; the text is in the package.
Document write_text_order(std::string_view kind, const app::DiagnoseOrder& order, WorkPackage& into);
app::DiagnoseOrder read_text_order(const WorkPackage& package);
Document write_digest_orders(const std::vector<app::DigestOrder>& orders, WorkPackage& into);
std::vector<app::DigestOrder> read_digest_orders(const Document& from, const WorkPackage& package);
Document write_digests(const std::vector<app::ProgramDigest>& digests, WorkPackage& into);
std::vector<app::ProgramDigest> read_digests(const Document& from, const WorkPackage& package);
WorkPackage error_package(const app::Error& error);
app::Error read_work_error(const Document& error);
Document write_diagnostics(const std::vector<text::Diagnostic>& diagnostics);
std::vector<text::Diagnostic> read_diagnostics(const Document& from);

}  // namespace dripfeed::json

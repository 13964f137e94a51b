// Programs in the database.
#pragma once

#include "store/programs.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class ProgramTable final : public store::Programs {
 public:
  explicit ProgramTable(Database& database) : database_(database) {}
  store::Result<store::Program> add(std::string_view name, std::string_view dialect, const store::NewProgramText& text,
                                    const store::Stamp& by) override;
  store::Result<store::Program> add_revision(store::Id program, store::Revision expected,
                                             const store::NewProgramText& text, const store::Stamp& by) override;
  store::Result<store::Program> label(store::Id program, const store::ProgramLabels& labels,
                                      const store::Stamp& by) override;
  store::Result<store::Program> archive(store::Id program, std::string_view reason, const store::Stamp& by) override;
  store::Result<store::Program> fetch_back(store::Id program, std::string_view reason, const store::Stamp& by) override;
  store::Result<store::Program> erase(store::Id program, std::int64_t archived_until_ms, std::string_view reason,
                                      const store::Stamp& by) override;
  store::Result<std::vector<store::Program>> changed_after(std::uint64_t change, std::uint32_t most) override;
  store::Result<std::uint64_t> count_changed_after(std::uint64_t change) override;
  store::Result<store::Program> get(store::Id program) override;
  store::Result<store::ProgramRevision> get_revision(store::Id program, store::Revision revision) override;
  store::Result<store::Page<store::Program>> list(const store::PageRequest& page,
                                                  const store::ProgramFilter& filter) override;
  store::Result<store::Page<store::ProgramRevision>> revisions(store::Id program,
                                                               const store::PageRequest& page) override;

 private:
  Database& database_;
};

// What is known of the program has changed: it is the last that did. Within the caller's transaction.
void note_program_change(Session& session, store::Id program);
// Errors: refused_transition.
store::Result<void> refuse_archived(Session& session, store::Id program);
// The text's hash of a revision, within the caller's transaction.
store::Result<std::string> text_of_revision(Session& session, store::Id program, store::Revision revision);
// Whether this person stored the text, in whichever program, or wrote the family that it was rendered from; within the
// caller's transaction.
bool wrote_text(Session& session, std::string_view text_sha256, std::string_view name);

}  // namespace dripfeed::sql

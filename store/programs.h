// Programs: a name, a dialect, and revisions that never change. A revision refers to its text by hash and says where
// that came from; texts themselves are in contents.h.
#pragma once

#include <optional>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

enum class OriginKind : std::uint8_t { uploaded, rendered };
template <>
inline constexpr std::array<std::string_view, 2> kNames<OriginKind>{"uploaded", "rendered"};

// Where a text came from. All but `kind` is empty for an uploaded one; `part` is empty when a family was rendered with
// values of its own.
struct Origin {
  OriginKind kind = OriginKind::uploaded;
  std::string family{};
  Revision family_revision = 0;
  std::string part{};
  Revision part_revision = 0;
  std::string values{};  // document
  std::string machine{};
  Revision machine_revision = 0;
  std::string mode{};  // "macro" or "explicit", as the renderer calls it
};

// What a caller says of a new revision. The contents must have been put before.
struct NewProgramText {
  std::string sha256{};
  std::string places_sha256{};  // the place index, empty without one
  std::uint64_t blocks = 0;
  std::string facts{};  // document, not read here
  Origin origin{};
};

struct ProgramRevision {
  Id program = 0;
  Revision revision = 0;
  std::string sha256;
  std::uint64_t bytes = 0;
  std::string places_sha256;
  std::uint64_t blocks = 0;
  std::string facts;
  Origin origin;
  std::string created_by;
  std::int64_t created_at_ms = 0;
};

// By whom and why a program was put aside: it takes no revision and no release until it is fetched back.
struct Archived {
  std::int64_t at_ms = 0;  // 0: it is in use
  std::string by{};
  std::string reason{};
};

// The same of a program that was deleted. What releases, jobs and the ledger say of it stays, with the texts that they
// name; all else of it is gone.
struct Deleted {
  std::int64_t at_ms = 0;  // 0: it is not
  std::string by{};
  std::string reason{};
};

struct Program {
  Id id = 0;
  std::string name;  // need not be unique: O0100 exists for many machines
  std::string dialect;
  ProgramRevision newest;           // revision 0: it was deleted, and nothing names its newest text
  std::vector<std::string> tags{};  // sorted
  std::string folder{};             // "customer/pumps"; empty: in none
  Archived archived{};
  Deleted deleted{};         // then it is archived, too
  std::uint64_t change = 0;  // of all programs' changes (text, tags, folder, archive, releases) the last that was its

  [[nodiscard]] bool is_archived() const { return archived.at_ms != 0; }
  [[nodiscard]] bool is_deleted() const { return deleted.at_ms != 0; }
};

// Which of the programs, by whether they are archived. Deleted ones are on none.
enum class Shelf : std::uint8_t { in_use, archived, all };
template <>
inline constexpr std::array<std::string_view, 3> kNames<Shelf>{"in_use", "archived", "all"};

struct ProgramFilter {
  std::string name{};    // empty: all
  std::string part{};    // some revision was rendered from it; empty: all
  std::string tag{};     // empty: all
  std::string folder{};  // this one and those below it; empty: all
  Shelf shelf = Shelf::all;
};

// What is not given stays.
struct ProgramLabels {
  std::optional<std::vector<std::string>> tags{};  // all of them
  std::optional<std::string> folder{};
};

class Programs : public Repository {
 public:
  // Errors: broken_reference (no such content, part, family or machine revision), invalid_value (empty name).
  virtual Result<Program> add(std::string_view name, std::string_view dialect, const NewProgramText& text,
                              const Stamp& by) = 0;
  // Errors: not_found, stale_revision, broken_reference, refused_transition (it is archived).
  virtual Result<Program> add_revision(Id program, Revision expected, const NewProgramText& text, const Stamp& by) = 0;
  // Errors: not_found, invalid_value (an empty tag).
  virtual Result<Program> label(Id program, const ProgramLabels& labels, const Stamp& by) = 0;
  // Errors: not_found, invalid_value (no reason), refused_transition (it is archived; a job of it has not ended; a
  // release of it is proving or approved).
  virtual Result<Program> archive(Id program, std::string_view reason, const Stamp& by) = 0;
  // Errors: not_found, invalid_value (no reason), refused_transition (it is in use, or deleted).
  virtual Result<Program> fetch_back(Id program, std::string_view reason, const Stamp& by) = 0;
  // For good. Its revisions that no verdict, release, job or receipt names are erased, with their texts at the next
  // start, and its attachments removed. Its id is never used again. Errors: not_found, invalid_value (no reason),
  // refused_transition (it is not archived, was so after `archived_until_ms`, is deleted; a job that has not ended is
  // of it or calls it; a release of it is not obsolete).
  virtual Result<Program> erase(Id program, std::int64_t archived_until_ms, std::string_view reason,
                                const Stamp& by) = 0;
  // Those that were changed after this change, in the order of their changes; deleted ones, too.
  virtual Result<std::vector<Program>> changed_after(std::uint64_t change, std::uint32_t most) = 0;
  virtual Result<std::uint64_t> count_changed_after(std::uint64_t change) = 0;
  // Errors: not_found.
  virtual Result<Program> get(Id program) = 0;
  virtual Result<ProgramRevision> get_revision(Id program, Revision revision) = 0;
  // Newest first.
  virtual Result<Page<Program>> list(const PageRequest& page, const ProgramFilter& filter = {}) = 0;
  virtual Result<Page<ProgramRevision>> revisions(Id program, const PageRequest& page) = 0;
};

}  // namespace dripfeed::store

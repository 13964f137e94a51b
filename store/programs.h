// Programs: a name, a dialect, and revisions that never change. A revision refers to its text by hash and says where
// that came from; texts themselves are in contents.h.
#pragma once

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

struct Program {
  Id id = 0;
  std::string name;  // need not be unique: O0100 exists for many machines
  std::string dialect;
  ProgramRevision newest;
};

struct ProgramFilter {
  std::string name{};  // empty: all
  std::string part{};  // some revision was rendered from it; empty: all
};

class Programs : public Repository {
 public:
  // Errors: broken_reference (no such content, part, family or machine revision), invalid_value (empty name).
  virtual Result<Program> add(std::string_view name, std::string_view dialect, const NewProgramText& text,
                              const Stamp& by) = 0;
  // Errors: not_found, stale_revision, broken_reference.
  virtual Result<Program> add_revision(Id program, Revision expected, const NewProgramText& text, const Stamp& by) = 0;
  // Errors: not_found.
  virtual Result<Program> get(Id program) = 0;
  virtual Result<ProgramRevision> get_revision(Id program, Revision revision) = 0;
  // Newest first.
  virtual Result<Page<Program>> list(const PageRequest& page, const ProgramFilter& filter = {}) = 0;
  virtual Result<Page<ProgramRevision>> revisions(Id program, const PageRequest& page) = 0;
};

}  // namespace dripfeed::store

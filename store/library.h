// What programs say and which programs they call, made to be searched. All of it is derived from the programs, so it
// stands in a file of its own next to the store: making it keeps no other writer waiting, the ledger's least of all,
// and a file that is lost or of another form is made again.
#pragma once

#include <vector>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

enum class CallKind : std::uint8_t { subprogram, macro, external };
template <>
inline constexpr std::array<std::string_view, 3> kNames<CallKind>{"subprogram", "macro", "external"};

struct ProgramCall {
  std::string name{};  // by which the called program is found: "O12", "GROOVE"
  CallKind kind = CallKind::subprogram;
  std::uint32_t line = 0;  // the first one that calls it
};

// What is known of a program's newest revision.
struct LibraryEntry {
  Id program = 0;
  Revision revision = 0;
  std::uint64_t change = 0;  // Program::change
  std::string sha256{};
  std::string name{};
  std::string numbers{};  // names inside the text: "O0012"
  std::string labels{};   // tags and folder
  std::string part{};
  std::string machines{};
  std::string comments{};
  std::string text{};  // words of the text with blanks between, EOBs kept
  bool is_archived = false;
  bool is_cut = false;               // not all of the text's lines are in `text`
  std::string not_read{};            // why the reader could not look at it; then nothing is known of its calls
  std::vector<std::string> names{};  // all by which a call finds it
  std::vector<ProgramCall> calls{};
  std::uint64_t computed_calls = 0;  // whose program is known only while it runs
};

struct LibraryState {
  std::uint64_t change = 0;    // up to which all changes are in it
  std::uint64_t programs = 0;  // that are in it
  std::uint64_t cut = 0;       // of these, those whose text is not in it as a whole
  std::uint64_t not_read = 0;  // … those whose calls no one knows
};

// A piece of what was found, marked where it is what was looked for.
struct SnippetPart {
  std::string text{};
  bool is_hit = false;
};

struct LibraryHit {
  Id program = 0;
  Revision revision = 0;
  bool is_similar = false;  // a name that is nearly what was looked for
  std::vector<SnippetPart> snippet{};
};

// A program that calls another one.
struct Caller {
  Id program = 0;
  ProgramCall call{};
};

struct KnownCalls {
  bool is_known = false;   // false: the program is not in the library yet
  std::string not_read{};  // why no one knows its calls
  std::vector<ProgramCall> calls{};
  std::uint64_t computed = 0;
};

class Library : public Repository {
 public:
  virtual Result<LibraryState> state() = 0;
  // Those that are in it are replaced, by nothing for revision 0. `reached`: all changes up to this one are in it.
  virtual Result<void> put(const std::vector<LibraryEntry>& entries, std::uint64_t reached) = 0;
  virtual Result<void> clear() = 0;
  // Best first. All words must be found, each anywhere: a word stands for all that begin with it, a word of a program
  // (G1, T0505) for itself with and without leading zeros, "a phrase" for itself. After them come programs with names
  // that are nearly so. Errors: invalid_value (nothing to look for, a bad cursor).
  virtual Result<Page<LibraryHit>> search(std::string_view words, const PageRequest& page, bool with_archived) = 0;
  // The programs that a call by one of this program's names may find, and those whose calls may find it.
  virtual Result<std::vector<Caller>> callers_of(Id program) = 0;
  virtual Result<KnownCalls> calls_of(Id program) = 0;
  virtual Result<std::vector<Id>> named(std::string_view name) = 0;
};

}  // namespace dripfeed::store

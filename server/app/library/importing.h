// Many programs from files into the library, each under a name in a folder: what is there already stays, what differs
// becomes a revision, and of each it is known what became of it and why. Where files come from is the caller's.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"
#include "server/app/library/programs.h"
#include "server/app/ports/clock.h"
#include "store/store.h"

namespace dripfeed::app {

inline constexpr std::uint64_t kLargestProgram_bytes = std::uint64_t{64} << 20U;

enum class ImportOutcome : std::uint8_t { added, revised, same, skipped, failed };
inline constexpr std::array<std::string_view, 5> kImportOutcomes{"added", "revised", "same", "skipped", "failed"};

// What becomes of a text whose name is in use in its folder with another text.
enum class KnownName : std::uint8_t { revise, skip };
inline constexpr std::array<std::string_view, 2> kKnownNames{"revise", "skip"};

struct ImportPlan {
  std::string actor;
  std::string dialect{};  // of new programs; "": the one that each text looks like
  KnownName known = KnownName::revise;
  bool only_look = false;  // nothing is stored
};

struct TextToImport {
  std::string name;
  std::string folder;  // "": none
  std::string_view text;
  std::string dialect{};            // "": the plan's
  std::vector<std::string> tags{};  // of a new program
  bool follows = false;             // a later revision of what this import brought before
};

struct Imported {
  ImportOutcome outcome = ImportOutcome::failed;
  std::string why{};  // it was skipped or failed
  std::string name{};
  std::string folder{};
  std::string dialect{};
  store::Id program = 0;         // 0: none, or not yet
  store::Revision revision = 0;  // that has the text; 0: none, or not yet
  std::uint64_t bytes = 0;
  std::string sha256{};
};

class Importer {
 public:
  // Refers to the first three.
  Importer(store::Store& store, Programs& programs, const Clock& clock, ImportPlan plan)
      : store_(store), programs_(programs), clock_(clock), plan_(std::move(plan)) {}

  // The program with its folder and tags is there as a whole, or nothing of it is.
  Imported import(const TextToImport& one);
  // Whether a program has this name in this folder, in use or archived.
  Result<bool> knows(const std::string& folder, const std::string& name);

 private:
  Result<void> place(const TextToImport& one, Imported& done);
  Result<void> place_new(const TextToImport& one, Imported& done);
  Result<void> place_revision(const TextToImport& one, const store::Program& known, Imported& done);
  [[nodiscard]] store::Stamp stamp() const { return {plan_.actor, clock_.wall_ms()}; }

  store::Store& store_;
  Programs& programs_;
  const Clock& clock_;
  ImportPlan plan_;
  std::map<std::pair<std::string, std::string>, std::string> brought_{};  // by folder and name: the text's hash
};

// Why new programs cannot be of it; "" where they can. "" is the dialect that each text looks like.
std::string why_no_dialect(std::string_view dialect);
// What a program in that file is called: its ending goes where it says no more than that it is a program.
std::string program_name_of(std::string_view file);
// Why these bytes are no text of a program, as the end of a sentence ("is empty"); "" where they may be one.
std::string why_no_program(std::string_view bytes);

}  // namespace dripfeed::app

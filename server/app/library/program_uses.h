// Where a program is used: what the store and the library know together.
#pragma once

#include <string>
#include <vector>

#include "server/app/base/error.h"
#include "server/app/library/library_indexer.h"

namespace dripfeed::app {

struct ProgramUses {
  static constexpr std::uint32_t kMost = 100;  // of each list; the newest of them
  struct OfPart {
    std::string number;
    store::Revision part_revision = 0;
    store::Revision revision = 0;  // of the program that was rendered from it, the newest such
  };
  struct OfMachine {
    std::string machine;
    std::uint64_t releases = 0;  // of those in the list
    std::uint64_t jobs = 0;
  };
  struct Called {
    store::ProgramCall call;
    std::vector<store::Program> programs;  // that are stored under this name; none: it is not here
  };
  struct Caller {
    store::ProgramCall call;
    store::Program program;
  };
  std::vector<OfPart> parts;
  std::vector<store::Release> releases;
  bool has_more_releases = false;
  std::vector<store::Job> jobs;
  bool has_more_jobs = false;
  std::vector<OfMachine> machines;
  std::vector<Caller> callers;
  store::KnownCalls known;  // of what it calls itself
  std::vector<Called> calls;
  std::uint64_t waiting = 0;  // changes of programs that the library does not know yet: calls may be missing
  std::uint64_t unread = 0;   // programs whose calls are not known
};

// Errors: not_found.
Result<ProgramUses> uses_of(store::Store& store, LibraryIndexer& indexer, store::Id program);

}  // namespace dripfeed::app

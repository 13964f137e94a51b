// The programs that a program calls, as the library has them: which of those with a name is the one that a machine's
// control holds. Where that is not certain, none is, and it says why.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/text/source.h"
#include "server/app/base/error.h"
#include "store/library.h"
#include "store/store.h"

namespace dripfeed::app {

struct CalledText {
  std::string key;  // the name that a call has, as compile::call_key gives it
  store::Id program = 0;
  store::Revision revision = 0;
  std::string name;     // of the program in the library
  std::string text;     // empty lines stand for what comes before it in a text of several programs
  std::string why_not;  // why it is not known which program the control holds, as a sentence; then there is no text
};

// The programs that a text is run with, and what it called besides.
struct CalledBy {
  std::vector<CalledText> texts;
  std::set<std::string> missing;  // keys

  // For compile::FindText.
  std::optional<text::Source> find(std::string_view name);
};

// Who calls.
struct Caller {
  std::string dialect;
  std::string machine;
  std::string folder;  // of the library
};

class CalledPrograms {
 public:
  // Longer ones are toolpaths.
  static constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 20U;

  // Without `library` programs are found by their own names alone.
  CalledPrograms(store::Store& store, store::Library* library) : store_(store), library_(library) {}

  // In this order: the one whose release is proving or approved for the machine, in the revision that was released;
  // the only one in the caller's folder; the only one there is. Its text is empty where no program has the name.
  // Errors: of the store.
  Result<CalledText> find(const Caller& caller, std::string_view name);
  // A verdict rests on the called programs as they were then. Errors: refused, with what has changed.
  Result<void> refuse_changed(const store::Verdict& verdict);

 private:
  struct Found {
    store::Program program;
    store::Revision revision = 0;
    bool is_released = false;  // for the machine
  };
  Result<std::vector<Found>> all_named(const Caller& caller, const std::string& key);
  Result<CalledText> choose(const Caller& caller, std::string_view name);
  Result<std::string> text_of(const Found& found, const std::string& key);

  store::Store& store_;
  store::Library* library_;
};

}  // namespace dripfeed::app

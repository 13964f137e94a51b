// Titles of families for lists. A title stands in the text of the family; a revision never changes, so each text is
// read once.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "store/families.h"

namespace dripfeed::http {

class FamilyTitles {
 public:
  static constexpr std::size_t kMost = 4096;  // then all are read anew

  // From any thread. `family` with its text.
  std::string of(const store::Family& family);

 private:
  std::mutex mutex_;
  std::map<std::pair<std::string, store::Revision>, std::string> titles_;
};

}  // namespace dripfeed::http

// The text is read without the lock: two who ask at once read it twice, and find the same.
#include "server/http/titles.h"

#include "dialects/text/source.h"
#include "server/json/records.h"

namespace dripfeed::http {

std::string FamilyTitles::of(const store::Family& family) {
  const std::pair key(family.name, family.revision);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = titles_.find(key); known != titles_.end()) return known->second;
  }
  std::string title = compile::describe_family(text::Source(family.name, family.text)).title;
  const std::lock_guard lock(mutex_);
  if (titles_.size() >= kMost) titles_.clear();
  titles_[key] = title;
  return title;
}

}  // namespace dripfeed::http

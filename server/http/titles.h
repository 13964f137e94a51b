// What lists show of a document that they do not: the title of a family stands in its text, title and link of a machine
// in its profile. A revision never changes, so each document is read once.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "server/json/records.h"
#include "store/families.h"
#include "store/machines.h"

namespace dripfeed::http {

template <class Shown>
class PerRevision {
 public:
  static constexpr std::size_t kMost = 4096;  // then all are read again

  // From any thread. `read` is called without the lock: two who ask at once read twice, and find the same.
  template <class Read>
  Shown of(const std::string& name, store::Revision revision, const Read& read) {
    const std::pair key(name, revision);
    {
      const std::lock_guard lock(mutex_);
      if (const auto known = shown_.find(key); known != shown_.end()) return known->second;
    }
    Shown shown = read();
    const std::lock_guard lock(mutex_);
    if (shown_.size() >= kMost) shown_.clear();
    return shown_[key] = std::move(shown);
  }

 private:
  std::mutex mutex_;
  std::map<std::pair<std::string, store::Revision>, Shown> shown_;
};

class Titles {
 public:
  std::string of(const store::Family& family);
  json::ProfileHead of(const store::Machine& machine);

 private:
  PerRevision<std::string> families_;
  PerRevision<json::ProfileHead> machines_;
};

}  // namespace dripfeed::http

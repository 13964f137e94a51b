// Texts that were found fit for a machine: a text never changes, and a machine's revision shows whether it did, so the
// same text is read once for many jobs. Before an arming it is read again all the same.
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "protocol/feed/program_check.h"
#include "store/basics.h"

namespace dripfeed::app {

class CheckedTexts {
 public:
  static constexpr std::size_t kMostKept = 256;

  struct Key {
    std::string sha256;
    std::string machine;
    store::Revision revision = 0;  // of the machine
    store::Delivery delivery = store::Delivery::drip;
    friend bool operator==(const Key&, const Key&) = default;
  };

  // From any thread.
  [[nodiscard]] std::optional<feed::ProgramFacts> find(const Key& key) const {
    const std::lock_guard lock(mutex_);
    for (const Row& row : rows_) {
      if (row.key == key) return row.facts;
    }
    return std::nullopt;
  }
  void keep(const Key& key, const feed::ProgramFacts& facts) {
    const std::lock_guard lock(mutex_);
    if (rows_.size() == kMostKept) rows_.pop_front();
    rows_.push_back({key, facts});
  }

 private:
  struct Row {
    Key key;
    feed::ProgramFacts facts;
  };
  mutable std::mutex mutex_;
  std::deque<Row> rows_;
};

}  // namespace dripfeed::app

// Texts that were found fit for a machine: a text never changes, and a machine's revision shows whether it did, so the
// same text and profile are read once for many jobs. Before an arming they are read again all the same.
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

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

  // What a job takes from them.
  struct Fit {
    std::string link;  // the line's URL
    std::uint64_t bytes_total = 0;
    std::string end_check{};  // that the machine's profile asks for
  };

  // From any thread.
  [[nodiscard]] std::optional<Fit> find(const Key& key) const {
    const std::lock_guard lock(mutex_);
    for (const Row& row : rows_) {
      if (row.key == key) return row.fit;
    }
    return std::nullopt;
  }
  void keep(const Key& key, const Fit& fit) {
    const std::lock_guard lock(mutex_);
    if (rows_.size() == kMostKept) rows_.pop_front();
    rows_.push_back({key, fit});
  }

 private:
  struct Row {
    Key key;
    Fit fit;
  };
  mutable std::mutex mutex_;
  std::deque<Row> rows_;
};

}  // namespace dripfeed::app

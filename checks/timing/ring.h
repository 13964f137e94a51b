// A queue in one block of memory that grows when it must and never shrinks: nothing is allocated once it is large
// enough. Its size is a power of two, so that going round is a mask.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace dripfeed::timing {

template <class T>
class Ring {
 public:
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::size_t size() const { return count_; }
  void clear() { first_ = count_ = 0; }
  [[nodiscard]] T& front() { return slots_[first_]; }
  void push_back(const T& value) {
    if (count_ == slots_.size()) grow();
    slots_[(first_ + count_) & (slots_.size() - 1)] = value;
    ++count_;
  }
  void pop_front() {
    first_ = (first_ + 1) & (slots_.size() - 1);
    --count_;
  }

 private:
  static constexpr std::size_t kFirstSize = 64;

  void grow() {
    std::vector<T> larger(slots_.empty() ? kFirstSize : 2 * slots_.size());
    for (std::size_t i = 0; i < count_; ++i) larger[i] = std::move(slots_[(first_ + i) & (slots_.size() - 1)]);
    slots_ = std::move(larger);
    first_ = 0;
  }

  std::vector<T> slots_;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace dripfeed::timing

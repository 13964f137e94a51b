// Entries of one place and one span are joined when there are too many, and from then on as they come.
#include "checks/gouge/removal.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dripfeed::gouge {

namespace {

constexpr double kFirstSpans = 4096.0;  // that many spans at least over all moments so far

}  // namespace

RemovalLog::RemovalLog(MomentsOf moments_of, std::size_t most)
    : moments_of_(std::move(moments_of)), most_(std::max<std::size_t>(most, 2)) {}

void RemovalLog::begin(const ir::Motion& motion, double from, double to) {
  const Moments all = moments_of_(motion);
  const double whole = all.last - all.first;
  first_ = all.first + from * whole;
  length_ = (to - from) * whole;
  latest_ = std::max(latest_, all.last);
}

// Whether it belongs to the newest entry of its place.
bool RemovalLog::joins(std::uint32_t place, float height_mm, double moment) {
  if (place >= newest_.size()) newest_.resize(std::size_t{place} + 1, 0);
  const std::uint32_t newest = newest_[place];
  if (newest == 0 || !(span_ > 0.0)) return false;
  Removal& before = entries_[newest - 1];
  if (std::floor(before.moment / span_) != std::floor(moment / span_)) return false;
  before.height_mm = height_mm;
  return true;
}

void RemovalLog::take(std::size_t place, double height_mm, double share) {
  const auto index = static_cast<std::uint32_t>(place);
  const double moment = first_ + share * length_;
  if (joins(index, static_cast<float>(height_mm), moment)) return;
  if (entries_.size() >= most_) {
    thin_out();
    if (joins(index, static_cast<float>(height_mm), moment)) return;
  }
  entries_.push_back({index, static_cast<float>(height_mm), moment});
  newest_[index] = static_cast<std::uint32_t>(entries_.size());
}

// At least half of the room is free afterwards, or each place has one entry.
void RemovalLog::thin_out() {
  const std::vector<Removal> all = std::exchange(entries_, {});
  std::size_t places = 0;
  for (const std::uint32_t one : newest_) places += one > 0 ? 1 : 0;
  span_ = span_ > 0.0 ? span_ : std::max(latest_, 1.0) / kFirstSpans / 2.0;
  do {
    span_ *= 2.0;
    entries_.clear();
    std::ranges::fill(newest_, 0);
    for (const Removal& one : all) {
      if (joins(one.place, one.height_mm, one.moment)) continue;
      entries_.push_back(one);
      newest_[one.place] = static_cast<std::uint32_t>(entries_.size());
    }
  } while (entries_.size() > most_ / 2 && entries_.size() > places);
  most_ = std::max(most_, entries_.size() + 1);
}

std::vector<Removal> RemovalLog::finish() {
  std::ranges::stable_sort(entries_, {}, &Removal::moment);
  newest_ = {};
  return std::move(entries_);
}

}  // namespace dripfeed::gouge

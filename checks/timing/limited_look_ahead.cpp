// Buffers are independent of each other: threads take the next one that no one has.
#include "checks/timing/limited_look_ahead.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include "checks/timing/sweep.h"

namespace dripfeed::timing {

namespace {

struct Overlap {
  std::size_t count = 0;
  bool is_cut = false;
};

// Elements after `end` whose path brings the machine from rest to the feed of the last one before.
Overlap overlap_of(const PieceArrays& pieces, std::size_t end, const LimitedLookAhead& settings) {
  const std::size_t most = std::min(settings.overlap_most, pieces.size() - end);
  std::size_t count = std::min(settings.overlap_least, most);
  double reached2 = 0.0;
  for (std::size_t i = 0; i < count; ++i) reached2 += change2(pieces, end + i);
  while (count < most && reached2 < pieces.speed2[end - 1]) reached2 += change2(pieces, end + count++);
  return {count, reached2 < pieces.speed2[end - 1] && end + count < pieces.size()};
}

}  // namespace

void plan_limited(const PieceArrays& pieces, const LimitedLookAhead& settings, LimitedPlan& plan) {
  const std::size_t size = pieces.size();
  const std::size_t elements = std::max<std::size_t>(settings.elements, 1);
  const std::size_t buffers = (size + elements - 1) / elements;
  plan.limit2.assign(size + 1, 0.0);
  plan.overlap.assign(buffers, 0);
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> cut{0};
  const auto work = [&] {
    std::vector<double> swept(size == 0 ? 0 : elements + settings.overlap_most + settings.overlap_least);
    for (std::size_t k = next++; k < buffers; k = next++) {
      const Range buffer{k * elements, std::min(size, (k + 1) * elements)};
      const Overlap overlap = overlap_of(pieces, buffer.end, settings);
      plan.overlap[k] = overlap.count;
      if (overlap.is_cut) ++cut;
      const Range with{buffer.begin, buffer.end + overlap.count};
      double after = 0.0;
      for (std::size_t i = with.end; i-- > with.begin;) {
        double limit = i == 0 ? 0.0 : std::min({pieces.start2[i], pieces.speed2[i], pieces.speed2[i - 1]});
        limit = std::min(limit, after + change2(pieces, i));
        swept[i - with.begin] = after = limit;
      }
      std::copy(swept.begin(), swept.begin() + static_cast<std::ptrdiff_t>(buffer.end - buffer.begin),
                plan.limit2.begin() + static_cast<std::ptrdiff_t>(buffer.begin));
    }
  };
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < settings.threads; ++i) others.emplace_back(work);
  work();
  others.clear();  // joins
  plan.cut = cut;
}

}  // namespace dripfeed::timing

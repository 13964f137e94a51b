// Reads outside the lock: what is added or dropped meanwhile waits for no disk.
#include "server/app/lines/text_reader.h"

#include <utility>
#include <vector>

namespace dripfeed::app {

namespace {

constexpr std::chrono::milliseconds kPeriod{50};  // a source holds 256 KiB: 5 MB/s a line

}  // namespace

TextReader::TextReader() : thread_("texts", kPeriod, Urgency::usual, [this] { round(); }) {}

void TextReader::read_for(std::uint64_t session, std::shared_ptr<ContentSource> source) {
  const std::lock_guard lock(mutex_);
  sources_[session] = std::move(source);
}

void TextReader::arming_is_over(std::uint64_t session) {
  const std::lock_guard lock(mutex_);
  sources_.erase(session);
}

void TextReader::round() {
  std::vector<std::shared_ptr<ContentSource>> sources;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [session, source] : sources_) sources.push_back(source);
  }
  for (const auto& source : sources) source->refill();
}

}  // namespace dripfeed::app

// An older version than the last one is treated as a newer one is: nothing of another version is ever given.
#include "server/http/kept_answers.h"

namespace dripfeed::http {

void KeptAnswers::bring_to(std::uint64_t version) {
  if (version == version_) return;
  answers_.clear();
  bytes_ = 0;
  version_ = version;
}

std::optional<Response> KeptAnswers::find(std::uint64_t version, std::string_view target) {
  const std::lock_guard lock(mutex_);
  bring_to(version);
  const auto found = answers_.find(target);
  return found == answers_.end() ? std::nullopt : std::optional(found->second);
}

void KeptAnswers::keep(std::uint64_t version, std::string_view target, const Response& response) {
  if (response.status != 200 || response.source || response.events || response.body.size() > kLongest_bytes) return;
  const std::lock_guard lock(mutex_);
  bring_to(version);
  const std::size_t bytes = response.body.size() + target.size() + kOverhead_bytes;
  if (bytes_ + bytes > kAll_bytes) return;
  if (answers_.try_emplace(std::string(target), response).second) bytes_ += bytes;
}

}  // namespace dripfeed::http

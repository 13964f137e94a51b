// Answers to reads that say what the store says and no more: they are kept as long as the store has the same version.
// Many who ask for the same list then cost one query.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/http/request.h"

namespace dripfeed::http {

class KeptAnswers {
 public:
  static constexpr std::size_t kLongest_bytes = std::size_t{64} << 10U;  // of a body; a longer one is not kept
  static constexpr std::size_t kAll_bytes = std::size_t{8} << 20U;       // of all bodies and targets; then none is kept
  static constexpr std::size_t kOverhead_bytes = 512;                    // of an answer besides, roughly

  // From any thread. `version` of the store was asked for before the answer was made; `target` is the request's, as it
  // was sent.
  std::optional<Response> find(std::uint64_t version, std::string_view target);
  // Only what is done (200) is kept, and only a body that stands in the answer.
  void keep(std::uint64_t version, std::string_view target, const Response& response);

 private:
  void bring_to(std::uint64_t version);

  std::mutex mutex_;
  std::uint64_t version_ = 0;
  std::size_t bytes_ = 0;
  std::map<std::string, Response, std::less<>> answers_;
};

}  // namespace dripfeed::http

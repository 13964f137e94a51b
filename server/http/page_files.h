// The files of the page, as answers: by their type, compressed where the browser takes that and the build made it, with
// a tag of their content, so that no browser loads twice what did not change.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/http/request.h"

namespace dripfeed::http {

class PageFiles {
 public:
  // The file, or its twin PATH.br or PATH.gz; 304 where the browser has it; nothing where there is no such file.
  std::optional<Response> answer(const std::filesystem::path& path, const Request& request);

 private:
  struct Seen {
    std::filesystem::file_time_type changed;
    std::uintmax_t bytes = 0;
    std::string tag;
  };
  std::string tag_of(const std::filesystem::path& path, std::string& body);

  static constexpr std::size_t kMost = 1024;  // then all are read again
  std::mutex mutex_;
  std::map<std::string, Seen> seen_;
};

// Whether a list of codings has this one: "gzip, br;q=0.5" has both, "br;q=0" has none.
bool takes_coding(std::string_view accept_encoding, std::string_view coding);
// Whether If-None-Match names this tag.
bool names_tag(std::string_view if_none_match, std::string_view tag);
// "app-1A2B3C4D.js": the name carries a hash of the content, so it never means another.
bool has_content_hash(std::string_view name);

}  // namespace dripfeed::http

// The HTTP client for webhooks, the arming hook and the sign-in's provider, on libcurl.
#pragma once

#include <expected>
#include <memory>
#include <string>

#include "server/app/ports/http_sender.h"

namespace dripfeed::io {

struct HttpSenderSettings {
  std::string ca_file{};     // PEM: whose certificates are believed; "": whom the system believes
  std::string user_agent{};  // "dripfeed/0.1.0"
};

// Or one sentence: the file of certificates cannot be read, libcurl does not start.
std::expected<std::unique_ptr<app::HttpSender>, std::string> make_http_sender(HttpSenderSettings settings);

}  // namespace dripfeed::io

// The provider as this server asks it: its document and keys are kept for a while, and asked for again when a token
// names a key that is not among them. Each call ends within the time that the settings give for all its requests, and
// nothing but a sign-in by the provider waits for it. From any thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/app/base/error.h"
#include "server/app/ports/http_sender.h"
#include "server/oidc/id_token.h"
#include "server/oidc/key_set.h"
#include "server/oidc/provider_document.h"
#include "server/oidc/tickets.h"

namespace dripfeed::oidc {

struct ProviderSettings {
  std::string issuer{};
  std::string client_id{};
  std::string client_secret{};  // "": a public client, by PKCE alone
  std::string scope{};          // besides openid, with blanks between
  ClaimNames claims{};
  std::string title{};         // on the button
  std::string redirect_url{};  // of the page, as it is registered at the provider
  bool local = false;          // this computer and private networks are allowed
  std::chrono::milliseconds at_most{5000};
  app::MakeHttpSender make_sender{};
  std::function<std::int64_t()> now_ms{};  // since 1970
};

// What the provider sent back with the browser.
struct Returned {
  std::string code;
  std::string state;
  std::string issuer;  // "" where it does not name itself (RFC 9207)
  std::string error;   // instead of a code
};

class Provider {
 public:
  static constexpr std::chrono::minutes kKept{60};       // document and keys
  static constexpr std::chrono::seconds kNotAgain{2};    // after a failure the next ones fail at once
  static constexpr std::string_view kPage = "/sign-in";  // of this server's page, where the browser comes back

  explicit Provider(ProviderSettings settings);

  // The address that the browser opens, and the cookie that it keeps meanwhile. Errors: unavailable (no answer),
  // refused (a document that is not taken).
  struct Begun {
    std::string url;
    std::string cookie;
  };
  app::Result<Begun> begin();
  // Who the person is. Errors: refused: another browser's, too late, used before; the provider refuses; a token that is
  // not taken. unavailable: no answer.
  app::Result<Identity> finish(const Returned& returned, std::string_view cookie);

  [[nodiscard]] const ProviderSettings& settings() const { return settings_; }

 private:
  using Until = std::chrono::steady_clock::time_point;
  struct Known {
    ProviderDocument document;
    std::shared_ptr<const KeySet> keys;
    std::int64_t read_at_ms = 0;
  };

  [[nodiscard]] Until end_of_call() const;
  app::Result<app::HttpOutcome> ask(const app::HttpCall& call, Until until) const;
  app::Result<std::string> get(const std::string& url, Until until) const;
  app::Result<Known> known(Until until);
  app::Result<Known> read(Until until) const;
  app::Result<std::shared_ptr<const KeySet>> keys_for(const SignedToken& token, const Known& known, Until until);
  app::Result<std::string> redeem(const Known& known, const Returned& returned, const Ticket& ticket,
                                  Until until) const;
  app::Result<Identity> believe(std::string_view token, const Known& known, const Ticket& ticket, Until until);

  ProviderSettings settings_;
  Tickets tickets_;
  std::mutex mutex_;  // held while document and keys are asked for: one asks, the others wait for what it hears
  std::optional<Known> known_;
  std::optional<app::Error> failure_;
  std::int64_t failed_at_ms_ = 0;
};

}  // namespace dripfeed::oidc

// Each listens only where its option is given.
#include "server/cli/readers.h"

#include <utility>

#include <fmt/format.h>

#include "server/app/out/shdr.h"
#include "server/cli/logging.h"
#include "server/io/modbus_listener.h"
#include "server/io/text_listener.h"

namespace dripfeed::cli {

app::Result<void> Readers::start(app::Application& application, const json::ServerOptions& options,
                                 const ServePlan& plan) {
  if (plan.modbus_address) {
    registers_.emplace(application.events(), application.clock(), plan.modbus_units);
    const http::ListenAddress& at = *plan.modbus_address;
    auto listening = io::listen_modbus({at.host, at.port, options.modbus_allow}, *registers_);
    if (!listening) return app::fail(app::ErrorCode::invalid, "--modbus-listen: " + listening.error());
    plcs_ = std::move(*listening);
    say(fmt::format("Modbus at {}:{}, {} units", at.host, plcs_->port(), options.modbus_unit.size()));
  }
  if (plan.shdr_address) {
    const http::ListenAddress& at = *plan.shdr_address;
    auto listening =
        io::listen_for_readers({at.host, at.port, options.shdr_allow}, "SHDR",
                               [&seen = application.observations()] { return std::make_unique<app::ShdrFeed>(seen); });
    if (!listening) return app::fail(app::ErrorCode::invalid, "--shdr-listen: " + listening.error());
    agents_ = std::move(*listening);
    say(fmt::format("SHDR at {}:{}", at.host, agents_->port()));
  }
  return {};
}

app::Result<void> Readers::set_allowed(const json::ServerOptions& options) {
  const auto set = [](io::PeerListener* listener, const char* option,
                      const std::vector<std::string>& allowed) -> app::Result<void> {
    if (listener == nullptr) return {};
    if (const auto readers = listener->set_allowed(allowed); !readers)
      return app::fail(app::ErrorCode::invalid, fmt::format("{}: {}", option, readers.error()));
    return {};
  };
  if (auto plcs = set(plcs_.get(), "--modbus-allow", options.modbus_allow); !plcs) return plcs;
  return set(agents_.get(), "--shdr-allow", options.shdr_allow);
}

}  // namespace dripfeed::cli

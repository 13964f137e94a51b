// The addresses at which others read what the machines do, without a right of their own: PLCs by Modbus TCP, agents of
// MTConnect by SHDR.
#pragma once

#include <memory>
#include <optional>

#include "server/app/application.h"
#include "server/app/out/status_registers.h"
#include "server/cli/serve_options.h"
#include "server/io/peer_listener.h"

namespace dripfeed::cli {

class Readers {
 public:
  // Listens where the options say so. The application must outlive this. Errors: invalid.
  app::Result<void> start(app::Application& application, const json::ServerOptions& options, const ServePlan& plan);
  // Who may read from now on; connections of others end. Errors: invalid.
  app::Result<void> set_allowed(const json::ServerOptions& options);

 private:
  std::optional<app::StatusRegisters> registers_;
  std::unique_ptr<io::PeerListener> plcs_;
  std::unique_ptr<io::PeerListener> agents_;
};

}  // namespace dripfeed::cli

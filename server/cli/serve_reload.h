// SIGHUP: a running server reads its options again and takes over those that it can. Nothing of it touches a line.
#pragma once

#include <functional>
#include <mutex>

#include "server/cli/serve_options.h"

namespace dripfeed::cli {

class Reload {
 public:
  using Read = std::function<app::Result<json::ServerOptions>()>;
  // Takes the live options over; or why not, and then none is.
  using TakeOver = std::function<app::Result<void>(const json::ServerOptions&)>;

  // `now`: with which the server starts. `read`: as options_of().
  Reload(json::ServerOptions now, Read read) : now_(std::move(now)), read_(std::move(read)) {}

  // From the signals' thread. Logs what is taken over, what waits for the next start, or why the file is refused.
  void run();
  // While this lives, run() takes options over; before and after, it says that the server does not run.
  class Running {
   public:
    Running(Reload& reload, TakeOver take_over);
    ~Running();
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

   private:
    Reload& reload_;
  };

 private:
  app::Result<void> take_over();

  std::mutex mutex_;
  json::ServerOptions now_;
  Read read_;
  TakeOver take_over_;
};

}  // namespace dripfeed::cli

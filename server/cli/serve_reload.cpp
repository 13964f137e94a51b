// All or nothing: a file with one mistake changes no option.
#include "server/cli/serve_reload.h"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "server/cli/logging.h"
#include "server/cli/output.h"

namespace dripfeed::cli {

using json::ServerOptions;

Reload::Running::Running(Reload& reload, TakeOver take_over) : reload_(reload) {
  const std::lock_guard lock(reload.mutex_);
  reload.take_over_ = std::move(take_over);
}

Reload::Running::~Running() {
  const std::lock_guard lock(reload_.mutex_);
  reload_.take_over_ = nullptr;
}

void Reload::run() {
  const std::lock_guard lock(mutex_);
  if (!take_over_) return say("SIGHUP: nothing is reloaded while the server starts or stops");
  auto done = take_over();
  if (done) return;
  done.error().text.insert(0, "SIGHUP: no option is changed: ");
  print_error(done.error());
}

app::Result<void> Reload::take_over() {
  auto options = read_();
  if (!options) return std::unexpected(std::move(options.error()));
  if (auto plan = plan_of(*options); !plan) return std::unexpected(std::move(plan.error()));
  const ChangedOptions changed = changed_options(now_, *options);
  if (!changed.live.empty()) {
    ServerOptions next = with_live(now_, *options);
    if (auto done = take_over_(next); !done) return done;
    now_ = std::move(next);
    say(fmt::format("SIGHUP: {} as the options state now", fmt::join(changed.live, ", ")));
  }
  if (!changed.later.empty())
    say(fmt::format("SIGHUP: {}: changed, and used from the next start on", fmt::join(changed.later, ", ")));
  if (changed.live.empty() && changed.later.empty()) say("SIGHUP: no option has changed");
  return {};
}

}  // namespace dripfeed::cli

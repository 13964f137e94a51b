// libpq gives notifications out when it reads the socket.
#include "store/postgresql/listener.h"

#include <thread>

#include <libpq-fe.h>
#include <poll.h>

namespace dripfeed::postgresql {

bool Listener::listens() {
  if (connection_ && connection_->is_usable()) return true;
  connection_.reset();
  auto opened = Connection::open(url_, {}, pulse_);
  if (!opened || !(*opened)->execute("LISTEN dripfeed_event")) return false;
  connection_ = std::move(*opened);
  return true;
}

void Listener::wait(std::chrono::milliseconds patience) {
  if (!listens()) {
    std::this_thread::sleep_for(patience);
    return;
  }
  pollfd polled{PQsocket(connection_->handle()), POLLIN, 0};
  if (::poll(&polled, 1, static_cast<int>(patience.count())) <= 0) return;
  if (PQconsumeInput(connection_->handle()) == 0) return connection_.reset();
  while (PGnotify* const notice = PQnotifies(connection_->handle())) PQfreemem(notice);
}

}  // namespace dripfeed::postgresql

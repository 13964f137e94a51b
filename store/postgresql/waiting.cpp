// libpq's own wait has no end, so this one waits on the socket.
#include "store/postgresql/waiting.h"

#include <libpq-fe.h>
#include <poll.h>
#include <sys/socket.h>

namespace dripfeed::postgresql {
namespace {

constexpr int kLookEvery_ms = 100;

// One step of sending what is left and reading what came. False: the connection is broken.
bool step(pg_conn* handle, bool& is_sent, const std::function<bool()>& gives_up) {
  if (!is_sent) {
    const int rest = PQflush(handle);
    if (rest < 0) return false;
    is_sent = rest == 0;
  }
  pollfd polled{PQsocket(handle), static_cast<short>(is_sent ? POLLIN : POLLIN | POLLOUT), 0};
  const int ready = ::poll(&polled, 1, kLookEvery_ms);
  // Cut, so that the next read finds the end: libpq has no call for it.
  if (ready == 0 && gives_up()) ::shutdown(polled.fd, SHUT_RDWR);
  const bool may_read = ready > 0 && (polled.revents & ~POLLOUT) != 0;
  return !may_read || PQconsumeInput(handle) == 1;
}

}  // namespace

void ResultDrop::operator()(pg_result* result) const { PQclear(result); }

void make_waitable(pg_conn* handle) { PQsetnonblocking(handle, 1); }

ResultPtr wait_for_result(pg_conn* handle, bool is_taken, const std::function<bool()>& gives_up) {
  ResultPtr last;
  if (!is_taken) return last;
  bool is_sent = false;
  while (true) {
    while (PQisBusy(handle) == 1 || !is_sent) {
      if (!step(handle, is_sent, gives_up)) break;
    }
    pg_result* const next = PQgetResult(handle);
    if (next == nullptr) return last;
    last.reset(next);
  }
}

}  // namespace dripfeed::postgresql

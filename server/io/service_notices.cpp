// A datagram socket that is connected once and never waits.
#include "server/io/service_notices.h"

#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace dripfeed::io {

namespace {

std::string_view in_environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

std::optional<std::uint64_t> number_in(const char* name) {
  const std::string_view text = in_environment(name);
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// A path, or with @ in front a name in the abstract namespace, which begins with a zero byte.
int connected_to(std::string_view name) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (name.size() < 2 || name.size() >= sizeof address.sun_path || (name[0] != '/' && name[0] != '@')) return -1;
  std::memcpy(address.sun_path, name.data(), name.size());
  if (name[0] == '@') address.sun_path[0] = '\0';
  const int made = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): how the system wants addresses
  if (made >= 0 && ::connect(made, reinterpret_cast<const sockaddr*>(&address), length) != 0) {
    ::close(made);
    return -1;
  }
  return made;
}

}  // namespace

ServiceNotices::ServiceNotices() : socket_(connected_to(in_environment("NOTIFY_SOCKET"))) {}

ServiceNotices::~ServiceNotices() {
  if (socket_ >= 0) ::close(socket_);
}

void ServiceNotices::notify(std::string_view notice) const {
  if (socket_ >= 0) ::send(socket_, notice.data(), notice.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
}

std::optional<feed::Time> ServiceNotices::wants_life_every() {
  const auto every_us = number_in("WATCHDOG_USEC");
  if (!every_us || *every_us == 0) return std::nullopt;
  // For this process, and not for the one that started it.
  if (const auto process = number_in("WATCHDOG_PID"); process && *process != static_cast<std::uint64_t>(::getpid()))
    return std::nullopt;
  return std::chrono::microseconds(*every_us);
}

}  // namespace dripfeed::io

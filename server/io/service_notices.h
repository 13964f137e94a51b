// Notices to the service manager that started this process (systemd), by the datagrams of sd_notify(3). None waits: the
// thread of the lines sends some, and must not stand still because the service manager does.
#pragma once

#include <optional>
#include <string_view>

#include "protocol/feed/settings.h"

namespace dripfeed::io {

class ServiceNotices {
 public:
  // As the environment names it (NOTIFY_SOCKET); without it every notice is dropped.
  ServiceNotices();
  ~ServiceNotices();
  ServiceNotices(const ServiceNotices&) = delete;
  ServiceNotices& operator=(const ServiceNotices&) = delete;

  // A notice as sd_notify(3) lists them, "READY=1"; no allocation. One that the socket does not take at once is lost.
  void notify(std::string_view notice) const;
  // How often it wants a sign of life, at least (WATCHDOG_USEC); nothing where it watches no process or another one.
  [[nodiscard]] static std::optional<feed::Time> wants_life_every();

 private:
  int socket_ = -1;
};

}  // namespace dripfeed::io

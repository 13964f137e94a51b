// What the system says of a serial port without opening it: opening one raises its DTR, which a control may take for a
// partner that is there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace dripfeed::io {

struct PortState {
  bool exists = false;
  bool is_device = false;                  // a character device
  bool may_use = false;                    // by the user who runs this
  std::string group;                       // of the device, "dialout"
  bool has_uart = true;                    // false: a name of the system with no hardware at it
  std::optional<std::uint32_t> base_baud;  // the highest rate; rates are whole parts of it. Nothing: not known
};

// `path` may be a link. `sysfs` is /sys, or a tree of its shape.
PortState look_at_port(const std::string& path, const std::string& sysfs = "/sys");
// Whether a UART that divides `base_baud` by a whole number comes within 2 % of this rate.
bool divides_to(std::uint32_t base_baud, std::uint32_t baud);

}  // namespace dripfeed::io

// Which device a serial port is, as the system knows it: /dev/ttyUSB0 may be another adapter, and so another machine,
// after a re-plug. Nothing is opened; a few small files of sysfs are read.
#pragma once

#include <string>

namespace dripfeed::io {

struct SerialIdentity {
  std::string device;      // where the path leads now, "/dev/ttyUSB0"; "": nothing is there
  std::string text;        // "USB 0403:6001, serial number A50285BI, interface 00, port 0"; "": not known (a pty)
  std::string unique_key;  // the same device wherever it is plugged in; "" where it has no serial number of its own
};

// `path` may be a link as udev makes them (/dev/serial/by-id/...). `sysfs` is /sys, or a tree of its shape.
SerialIdentity identify_serial(const std::string& path, const std::string& sysfs = "/sys");

// The name under which a USB adapter stays findable, where `path` is another one: "/dev/serial/by-id/usb-…" for
// "/dev/ttyUSB0". Empty where `path` is such a name, or there is none.
std::string lasting_name(const std::string& path, const std::string& by_id = "/dev/serial/by-id");

// A pseudo-terminal: its number is given to another process once it is closed.
bool is_pty(const std::string& device);

// Absolute, without "." and "..", links not followed.
std::string plain_path(const std::string& path);

// Empty, or "another device is at this port: was X, is Y". Where one of both is not known nothing is claimed.
std::string other_device(const std::string& was, const std::string& is);

}  // namespace dripfeed::io

// sysfs: /sys/class/tty/ttyUSB0/device leads into the tree of devices. Above it stand the interface (bInterfaceNumber)
// and the USB device (idVendor, idProduct, serial).
#include "server/io/serial_identity.h"

#include <array>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

namespace dripfeed::io {

namespace {

namespace fs = std::filesystem;

// The first line of a small file, without what stands at its end; "" where there is none.
std::string read_attribute(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.pop_back();
  return line;
}

// The nearest folder that has such a file, from `from` upward, not above `root`.
fs::path above_with(fs::path from, const char* file, const fs::path& root) {
  std::error_code error;
  while (from != root && from.has_relative_path()) {
    if (fs::exists(from / file, error)) return from;
    from = from.parent_path();
  }
  return {};
}

void identify_usb(const fs::path& at, const fs::path& usb, const fs::path& root, SerialIdentity& identity) {
  const std::string serial = read_attribute(usb / "serial");
  const fs::path interface = above_with(at, "bInterfaceNumber", root);
  const std::string number = interface.empty() ? std::string() : read_attribute(interface / "bInterfaceNumber");
  const std::string port = read_attribute(at / "port_number");
  const std::string model = fmt::format("{}:{}", read_attribute(usb / "idVendor"), read_attribute(usb / "idProduct"));
  identity.text = fmt::format("USB {}", model);
  for (const auto& [name, value] :
       {std::pair<const char*, const std::string&>{"serial number", serial}, {"interface", number}, {"port", port}}) {
    if (!value.empty()) identity.text += fmt::format(", {} {}", name, value);
  }
  if (!serial.empty()) identity.unique_key = fmt::format("usb:{}:{}:{}:{}", model, serial, number, port);
}

}  // namespace

bool is_pty(const std::string& device) { return device.starts_with("/dev/pts/"); }

std::string plain_path(const std::string& path) { return fs::absolute(path).lexically_normal().string(); }

SerialIdentity identify_serial(const std::string& path, const std::string& sysfs) {
  std::error_code error;
  SerialIdentity identity;
  const fs::path device = fs::canonical(path, error);
  if (error) return identity;
  identity.device = device.string();
  if (is_pty(identity.device)) return identity;
  const fs::path root = fs::canonical(sysfs, error);
  if (error) return identity;
  const fs::path at = fs::canonical(root / "class/tty" / device.filename() / "device", error);
  if (error) return identity;
  const fs::path usb = above_with(at, "idVendor", root);
  if (usb.empty()) {
    // A port of the computer itself: its place names it.
    identity.text = fmt::format("port {}", at.lexically_relative(root).string());
  } else {
    identify_usb(at, usb, root, identity);
  }
  return identity;
}

std::string lasting_name(const std::string& path, const std::string& by_id) {
  std::error_code error;
  const fs::path device = fs::canonical(path, error);
  if (error || plain_path(path) != device.string()) return {};  // a link is a name that a person chose
  for (fs::directory_iterator entry(by_id, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code unreadable;
    if (fs::canonical(entry->path(), unreadable) == device) return entry->path().string();
  }
  return {};
}

std::string other_device(const std::string& was, const std::string& is) {
  if (was.empty() || is.empty() || was == is) return {};
  return fmt::format("another device is at this port: was {}, is {}", was, is);
}

}  // namespace dripfeed::io

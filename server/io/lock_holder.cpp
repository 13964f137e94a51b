// A row of /proc/locks, see proc(5): "1: FLOCK  ADVISORY  WRITE 1234 08:01:5678 0 EOF": the process, then device and
// inode of the file. A row that waits has "->" after its number.
#include "server/io/lock_holder.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

namespace dripfeed::io {

std::optional<std::int64_t> lock_holder(const std::string& path, const std::string& locks) {
  struct stat file{};
  if (::stat(path.c_str(), &file) != 0) return std::nullopt;
  const std::string wanted = fmt::format("{:02x}:{:02x}:{}", major(file.st_dev), minor(file.st_dev), file.st_ino);
  std::ifstream rows(locks);
  for (std::string row; std::getline(rows, row);) {
    std::istringstream words(row);
    std::string number, kind, manner, access, place;
    std::int64_t process = 0;
    words >> number >> kind >> manner >> access >> process >> place;
    if (words && kind == "FLOCK" && place == wanted) return process;
  }
  return std::nullopt;
}

std::string command_of(std::int64_t process) {
  std::ifstream file(fmt::format("/proc/{}/cmdline", process), std::ios::binary);
  std::string line((std::istreambuf_iterator<char>(file)), {});
  while (!line.empty() && line.back() == '\0') line.pop_back();
  std::ranges::replace(line, '\0', ' ');
  return line;
}

}  // namespace dripfeed::io

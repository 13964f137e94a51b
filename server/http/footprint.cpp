// /proc/self/stat, see proc(5): what comes after the command's name, which may hold blanks and brackets, is counted
// from its last bracket.
#include "server/http/footprint.h"

#include <charconv>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace dripfeed::http {

namespace {

std::string read_small_file(const char* path) {
  std::string text(16384, '\0');
  const int file = ::open(path, O_RDONLY | O_CLOEXEC);
  const ssize_t count = file < 0 ? -1 : ::read(file, text.data(), text.size());
  if (file >= 0) ::close(file);
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return text;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    if (end > 0) words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

double number_of(std::string_view text) {
  std::uint64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return static_cast<double>(number);
}

// When the system was started, in seconds since 1970. It does not change while the process lives.
double system_started_at_s() {
  static const double kAt = [] {
    const std::string all = read_small_file("/proc/stat");
    const std::size_t at = all.find("\nbtime ");
    return at == std::string::npos ? 0.0 : number_of(std::string_view(all).substr(at + 7));
  }();
  return kAt;
}

std::uint64_t count_open_files() {
  std::error_code error;
  std::filesystem::directory_iterator files("/proc/self/fd", error);
  std::uint64_t count = 0;
  for (; !error && files != std::filesystem::directory_iterator(); files.increment(error)) ++count;
  return count > 0 ? count - 1 : 0;  // but the one that reads the folder
}

}  // namespace

std::optional<Footprint> footprint() {
  // Places in proc(5) less 3: the first word after the bracket is its third.
  enum Place : std::size_t {
    user_ticks = 11,
    system_ticks = 12,
    threads = 17,
    start_ticks = 19,
    virtual_size = 20,
    resident_pages = 21
  };
  const std::string all = read_small_file("/proc/self/stat");
  const std::size_t bracket = all.rfind(')');
  if (bracket == std::string::npos) return std::nullopt;
  const auto words = words_of(std::string_view(all).substr(bracket + 1));
  if (words.size() <= resident_pages) return std::nullopt;
  const auto ticks_s = static_cast<double>(::sysconf(_SC_CLK_TCK));
  Footprint use;
  use.cpu_s = (number_of(words[user_ticks]) + number_of(words[system_ticks])) / ticks_s;
  use.threads = static_cast<std::uint64_t>(number_of(words[threads]));
  use.started_at_s = system_started_at_s() + number_of(words[start_ticks]) / ticks_s;
  use.virtual_bytes = static_cast<std::uint64_t>(number_of(words[virtual_size]));
  use.resident_bytes = static_cast<std::uint64_t>(number_of(words[resident_pages])) *
                       static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  use.open_files = count_open_files();
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) == 0) use.most_files = files.rlim_cur;
  return use;
}

}  // namespace dripfeed::http

// The name is the kernel's; a file is read whole, as programs are.
#include "server/cli/host.h"

#include <array>

#include <unistd.h>

#include "server/cli/inputs.h"

namespace dripfeed::cli {

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "localhost";
}

app::Result<std::string> password_in(const std::string& path) {
  if (path.empty()) return std::string();
  const auto file = read_source(path);
  if (!file) return std::unexpected(file.error());
  return std::string(file->text().substr(0, file->text().find_first_of("\r\n")));
}

}  // namespace dripfeed::cli

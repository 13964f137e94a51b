// The first write makes the file. Splices are in the order of the file, so that it is read from its start to its end.
#include "server/cli/text_spool.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "server/cli/output.h"

namespace dripfeed::cli {

void TextSpool::fail() {
  if (fault_.empty()) fault_ = fmt::format("temporary file: {}", std::strerror(errno));
}

void TextSpool::write(std::string_view text) {
  if (text.empty() || !fault_.empty()) return;
  if (!file_) file_.reset(std::tmpfile());
  if (!file_ || std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail();
}

bool TextSpool::copy(const compile::Splice& splice, std::FILE* to) {
  std::array<char, std::size_t{1} << 16U> buffer;
  if (std::fseek(file_.get(), static_cast<long>(splice.begin), SEEK_SET) != 0) return false;
  for (std::uint64_t left = splice.end - splice.begin; left > 0;) {
    const std::size_t size = std::min<std::uint64_t>(left, buffer.size());
    if (std::fread(buffer.data(), 1, size, file_.get()) != size) return false;
    if (std::fwrite(buffer.data(), 1, size, to) != size) return false;
    left -= size;
  }
  return true;
}

bool TextSpool::write_output(const std::string& path, std::string_view text,
                             const std::vector<compile::Splice>& splices) {
  if (!fault_.empty()) {
    print_error(fault_);
    return false;
  }
  return write_output_by(path, [&](std::FILE* to) {
    const auto write = [&](std::string_view piece) {
      return std::fwrite(piece.data(), 1, piece.size(), to) == piece.size();
    };
    std::size_t at = 0;
    for (const compile::Splice& splice : splices) {
      if (!write(text.substr(at, splice.at - at)) || !copy(splice, to)) return false;
      at = splice.at;
    }
    return write(text.substr(at));
  });
}

}  // namespace dripfeed::cli

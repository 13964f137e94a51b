// The tree is walked in the order of names, so that two imports of a folder do the same.
#include "server/cli/folder_files.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

namespace dripfeed::cli {

namespace {

namespace fs = std::filesystem;

std::unexpected<app::Error> cannot(std::string_view what, const fs::path& path, std::string_view why) {
  return app::fail(app::ErrorCode::unavailable, fmt::format("{} cannot be {}: {}", path.string(), what, why));
}

std::string why_not(const fs::directory_entry& entry) {
  std::error_code fault;
  if (entry.path().filename().string().starts_with('.')) return "is hidden";
  if (entry.is_symlink(fault)) return "is a link";
  return entry.is_regular_file(fault) ? "" : "is not a file";
}

app::Result<void> look_into(const fs::path& folder, const std::string& before, std::vector<FoundFile>& into) {
  std::error_code fault;
  std::vector<fs::directory_entry> entries;
  for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) entries.push_back(*at);
  if (fault) return cannot("read", folder, fault.message());
  std::ranges::sort(entries, {}, [](const fs::directory_entry& entry) { return entry.path().filename().string(); });
  for (const fs::directory_entry& entry : entries) {
    const std::string name = entry.path().filename().string();
    const std::string path = before.empty() ? name : fmt::format("{}/{}", before, name);
    const bool enters = !entry.is_symlink(fault) && entry.is_directory(fault) && !name.starts_with('.');
    if (!enters) {
      into.push_back({.path = path, .why_not = why_not(entry)});
    } else if (auto looked = look_into(entry.path(), path, into); !looked) {
      // One folder that may not be read keeps no other from being read.
      into.push_back({.path = path, .why_not = looked.error().text});
    }
  }
  return {};
}

}  // namespace

app::Result<std::vector<FoundFile>> files_below(const fs::path& folder) {
  std::vector<FoundFile> found;
  if (auto looked = look_into(folder, "", found); !looked) return std::unexpected(looked.error());
  return found;
}

app::Result<std::string> read_file(const fs::path& file, std::uint64_t most_bytes) {
  std::error_code fault;
  if (!fs::is_regular_file(fs::symlink_status(file, fault))) return cannot("read", file, "it is not a file");
  const std::uint64_t bytes = fs::file_size(file, fault);
  if (fault) return cannot("read", file, fault.message());
  if (bytes > most_bytes) return cannot("read", file, fmt::format("it has {} bytes, at most {}", bytes, most_bytes));
  std::ifstream in(file, std::ios::binary);
  std::string text(static_cast<std::size_t>(bytes), '\0');
  if (!in || (bytes > 0 && !in.read(text.data(), static_cast<std::streamsize>(bytes))))
    return cannot("read", file, "the system refuses it");
  return text;
}

app::Result<void> write_new_file(const fs::path& file, std::string_view bytes) {
  std::error_code fault;
  fs::create_directories(file.parent_path(), fault);
  if (fault) return cannot("made", file.parent_path(), fault.message());
  if (fs::exists(fs::symlink_status(file, fault))) return cannot("written", file, "it is there already");
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  return out ? app::Result<void>{} : cannot("written", file, "the system refuses it");
}

std::string file_step(std::string_view name) {
  constexpr std::string_view kOthers = "/\\:*?\"<>|%";
  std::string step;
  for (const char c : name) {
    const bool is_plain = (c < 0 || c >= ' ') && c != '\x7f' && kOthers.find(c) == std::string_view::npos;
    const bool hides = c == '.' && step.empty();
    if (is_plain && !hides) {
      step += c;
    } else {
      step += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return step;
}

}  // namespace dripfeed::cli

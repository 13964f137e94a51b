// Called programs and definition files in folders, by name: whatever the case, with the usual endings, and as the
// SINUMERIK itself names its files (_N_SHAFT_SPF).
#include "server/cli/program_folders.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "server/cli/inputs.h"

namespace dripfeed::cli {

namespace {

namespace fs = std::filesystem;

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

// What stands before and after a program's name in the name of its file, in the order in which it is looked for.
struct Affixes {
  std::string_view before;
  std::string_view after;
};
constexpr std::array<Affixes, 12> kAffixes = {{{"", ""},
                                               {"", ".nc"},
                                               {"", ".ngc"},
                                               {"", ".spf"},
                                               {"", ".mpf"},
                                               {"", ".cnc"},
                                               {"", ".txt"},
                                               {"", ".cyc"},
                                               {"", ".def"},
                                               {"_n_", "_spf"},
                                               {"_n_", "_mpf"},
                                               {"_n_", "_def"}}};

// The directories in which the SINUMERIK looks, in its order; all lie next to one another.
constexpr std::array<std::string_view, 6> kDirectories = {"spf", "cus", "cma", "cst", "mpf", "def"};

// "CMA.DIR" -> "cma"
std::string directory_name(const fs::path& folder) {
  std::string name = lower(folder.filename().string());
  if (name.ends_with(".dir")) name.resize(name.size() - 4);
  return name;
}

bool is_directory_of_control(const fs::path& folder) {
  return std::ranges::find(kDirectories, directory_name(folder)) != kDirectories.end();
}

// The other directories of the control that `folder` is one of; a workpiece lies one level deeper.
std::vector<std::string> sibling_directories(const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::absolute(folder, error).lexically_normal();
  const bool is_workpiece = lower(whole.filename().string()).ends_with(".wpd");
  const fs::path own = is_workpiece ? whole.parent_path() : whole;
  if (error || (!is_workpiece && !is_directory_of_control(own))) return {};
  std::vector<std::string> found(kDirectories.size());
  for (const fs::directory_entry& entry : fs::directory_iterator(own.parent_path(), error)) {
    const auto known = std::ranges::find(kDirectories, directory_name(entry.path()));
    if (known != kDirectories.end() && entry.path() != whole && entry.is_directory(error))
      found[static_cast<std::size_t>(known - kDirectories.begin())] = entry.path().string();
  }
  std::erase(found, std::string());
  return found;
}

// O0012 is kept as O0012, O12, 0012 or 12; other names as they are.
std::vector<std::string> spellings(std::string_view name) {
  std::vector<std::string> result = {lower(name)};
  const bool numbered =
      name.size() > 1 && name.front() == 'O' && name.find_first_not_of("0123456789", 1) == std::string_view::npos;
  if (!numbered) return result;
  const std::string_view digits = name.substr(1);
  const std::string_view shortest = digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
  result.emplace_back(digits);
  result.emplace_back(shortest);
  result.push_back("o" + std::string(shortest));
  return result;
}

}  // namespace

std::vector<std::string> folders_for(const TextOptions& options, const std::string& file) {
  std::vector<std::string> folders = options.paths;
  if (file == "-" || file == "<stdin>") return folders;
  const fs::path own = fs::path(file).parent_path();
  folders.push_back(own.empty() ? "." : own.string());
  std::ranges::move(sibling_directories(folders.back()), std::back_inserter(folders));
  return folders;
}

ProgramFolder::ProgramFolder(const std::string& path) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, error)) {
    const auto [known, is_new] = files_.try_emplace(lower(entry.path().filename().string()), entry.path().string());
    if (!is_new) known->second = std::min(known->second, entry.path().string());
  }
}

std::string ProgramFolder::find(std::string_view name) const {
  for (const Affixes& affixes : kAffixes) {
    for (const std::string& spelled : spellings(name)) {
      const auto file = files_.find(std::string(affixes.before) + spelled + std::string(affixes.after));
      std::error_code error;
      if (file != files_.end() && fs::is_regular_file(file->second, error)) return file->second;
    }
  }
  return {};
}

}  // namespace dripfeed::cli

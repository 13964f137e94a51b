// The files of a folder are read for their programs once, when a name is asked for that no file has.
#include "server/cli/called_programs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "server/cli/inputs.h"
#include "server/cli/program_folders.h"

namespace dripfeed::cli {

namespace {

namespace fs = std::filesystem;

// Larger ones are toolpaths, and a folder of many files is an archive.
constexpr std::uintmax_t kMostBytesOfFile = std::uintmax_t{4} << 20U;
constexpr std::uintmax_t kMostBytesOfFolder = std::uintmax_t{64} << 20U;
constexpr std::size_t kMostFiles = 4000;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_number_name(std::string_view name) {
  return name.size() > 1 && name.front() == 'O' && std::ranges::all_of(name.substr(1), is_digit);
}

// O12 and O0012 are one program.
std::string without_zeros(std::string_view digits) {
  return std::string(digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1)));
}

// What a call names it by: "O12", "PROBE"; "" for a line that begins no program.
std::string name_in_head(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t%"), line.size()));
  if (line.empty()) return {};
  const bool lettered = line.front() == 'O' || line.front() == ':';
  if (lettered) line.remove_prefix(1);
  if (!line.empty() && line.front() == '<') {
    const std::size_t end = line.find('>');
    return end == std::string_view::npos ? std::string() : std::string(line.substr(1, end - 1));
  }
  const auto digits_end = std::ranges::find_if_not(line, is_digit);
  const auto count = static_cast<std::size_t>(digits_end - line.begin());
  return lettered && count > 0 ? "O" + without_zeros(line.substr(0, count)) : std::string();
}

// A program in a file: its own lines, behind as many empty ones as stand before it, so that messages count as the file
// does.
struct Piece {
  std::string path;
  std::string text;
  bool is_ambiguous = false;
};

class FolderIndex {
 public:
  explicit FolderIndex(const std::string& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
      if (entry.is_regular_file(error) && entry.file_size(error) <= kMostBytesOfFile) files.push_back(entry.path());
    if (files.size() > kMostFiles) return;
    std::ranges::sort(files);
    std::uintmax_t bytes = 0;
    for (const fs::path& path : files) {
      bytes += fs::file_size(path, error);
      if (bytes > kMostBytesOfFolder) return;
      if (auto source = read_source(path.string())) add(path.string(), source->text());
    }
  }

  // nullptr: no file of the folder has it, or several have.
  [[nodiscard]] const Piece* find(const std::string& name) const {
    const auto found = pieces_.find(is_number_name(name) ? "O" + without_zeros(name.substr(1)) : name);
    return found == pieces_.end() || found->second.is_ambiguous ? nullptr : &found->second;
  }

 private:
  void add(const std::string& path, std::string_view text) {
    if (text.find('\0') != std::string_view::npos) return;
    std::string name;
    std::size_t begin = 0;
    std::size_t lines = 0;
    std::size_t lines_before = 0;
    for (std::size_t at = 0; at < text.size(); ++lines) {
      const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
      if (std::string here = name_in_head(text.substr(at, end - at)); !here.empty()) {
        keep(path, name, text.substr(begin, at - begin), lines_before);
        name = std::move(here);
        begin = at;
        lines_before = lines;
      }
      at = end == text.size() ? end : end + text::eob_length(text, end);
    }
    keep(path, name, text.substr(begin), lines_before);
  }

  void keep(const std::string& path, const std::string& name, std::string_view text, std::size_t lines_before) {
    if (name.empty()) return;
    const auto [entry, is_new] = pieces_.try_emplace(name, Piece{path, {}, false});
    if (is_new)
      entry->second.text = std::string(lines_before, '\n') + std::string(text);
    else
      entry->second.is_ambiguous = true;
  }

  std::map<std::string, Piece, std::less<>> pieces_;
};

}  // namespace

compile::FindText find_in(std::vector<std::string> folders) {
  // Read when the first program is asked for.
  struct Contents {
    std::vector<ProgramFolder> files;
    std::map<std::string, FolderIndex> programs;
  };
  return [folders = std::move(folders),
          read = std::make_shared<Contents>()](std::string_view name) -> std::optional<text::Source> {
    if (read->files.empty())
      for (const std::string& folder : folders) read->files.emplace_back(folder);
    for (const ProgramFolder& folder : read->files) {
      const std::string path = folder.find(name);
      if (path.empty()) continue;
      if (auto text = read_source(path)) return std::move(*text);
    }
    for (const std::string& folder : folders) {
      const auto index = read->programs.try_emplace(folder, folder).first;
      if (const Piece* piece = index->second.find(std::string(name))) return text::Source(piece->path, piece->text);
    }
    return std::nullopt;
  };
}

}  // namespace dripfeed::cli

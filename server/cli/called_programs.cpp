// The files of a folder are read for their programs once, when a name is asked for that no file has.
#include "server/cli/called_programs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "server/app/shop/program_pieces.h"
#include "server/cli/inputs.h"
#include "server/cli/program_folders.h"

namespace dripfeed::cli {

namespace {

namespace fs = std::filesystem;

// Larger ones are toolpaths, and a folder of many files is an archive.
constexpr std::uintmax_t kMostBytesOfFile = std::uintmax_t{4} << 20U;
constexpr std::uintmax_t kMostBytesOfFolder = std::uintmax_t{64} << 20U;
constexpr std::size_t kMostFiles = 4000;

// A program in a file.
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
    const auto found = pieces_.find(app::number_name(name));
    return found == pieces_.end() || found->second.is_ambiguous ? nullptr : &found->second;
  }

 private:
  void add(const std::string& path, std::string_view text) {
    if (text.find('\0') != std::string_view::npos) return;
    for (const app::ProgramPiece& piece : app::pieces_of(text)) {
      const auto [entry, is_new] = pieces_.try_emplace(piece.name, Piece{path, {}, false});
      if (is_new)
        entry->second.text = piece.in_place();
      else
        entry->second.is_ambiguous = true;
    }
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

// Files of one folder that differ by their ending alone keep it, so that each has a name of its own.
#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "server/app/library/split_text.h"
#include "server/cli/folder_files.h"
#include "server/cli/import_folder.h"
#include "server/io/steady_clock.h"
#include "server/json/documents.h"

namespace dripfeed::cli {

namespace {

struct Place {
  std::string folder;  // of the library
  std::string file;    // its name
};

Place place_of(const std::string& path, const std::string& under) {
  const std::size_t slash = path.rfind('/');
  std::string folder = slash == std::string::npos ? std::string() : path.substr(0, slash);
  if (!under.empty()) folder = folder.empty() ? under : under + "/" + folder;
  return {.folder = std::move(folder), .file = slash == std::string::npos ? path : path.substr(slash + 1)};
}

app::ImportRow row_of(const std::string& path, app::ImportOutcome outcome, std::string why) {
  return {.file = path, .kind = "file", .of = {.outcome = outcome, .why = std::move(why)}};
}

class TreeImport {
 public:
  TreeImport(store::Store& store, const FolderImport& order, const OnImported& on_imported)
      : order_(order),
        on_imported_(on_imported),
        programs_(store, clock_, documents_),
        importer_(store, programs_, clock_, order.plan) {}

  app::Result<void> run() {
    const auto files = files_below(order_.folder);
    if (!files) return std::unexpected(files.error());
    for (const FoundFile& file : *files)
      if (file.why_not.empty()) ++with_name_[folder_and_name(file.path)];
    for (const FoundFile& file : *files) bring(file);
    return {};
  }

 private:
  [[nodiscard]] std::string folder_and_name(const std::string& path) const {
    const Place place = place_of(path, order_.under);
    return place.folder + "/" + app::program_name_of(place.file);
  }

  void bring(const FoundFile& file) {
    if (!file.why_not.empty()) return on_imported_(row_of(file.path, app::ImportOutcome::skipped, file.why_not));
    const auto text = read_file(order_.folder / file.path, app::kLargestProgram_bytes);
    if (!text) return on_imported_(row_of(file.path, app::ImportOutcome::failed, text.error().text));
    if (std::string why = app::why_no_program(*text); !why.empty())
      return on_imported_(row_of(file.path, app::ImportOutcome::skipped, std::move(why)));
    bring_text(file.path, *text);
  }

  void bring_text(const std::string& path, const std::string& text) {
    const Place place = place_of(path, order_.under);
    const bool is_alone = with_name_[folder_and_name(path)] == 1;
    const std::string name = is_alone ? app::program_name_of(place.file) : place.file;
    const auto parts = app::split_text(text);
    if (parts.size() < 2)
      return on_imported_({.file = path, .of = importer_.import({.name = name, .folder = place.folder, .text = text})});
    const std::string folder = place.folder.empty() ? name : place.folder + "/" + name;
    std::map<std::string, std::vector<std::string_view>> texts;  // by the name that they give themselves
    for (std::size_t i = 0; i < parts.size(); ++i) {
      std::string own = parts[i].name.empty() ? fmt::format("{} {}", name, i + 1) : parts[i].name;
      // A name that comes again with another text is numbered, so that none is lost.
      std::vector<std::string_view>& of_name = texts[own];
      const auto same = std::ranges::find(of_name, parts[i].text);
      const auto nth = static_cast<std::size_t>(same - of_name.begin()) + 1;
      if (same == of_name.end()) of_name.emplace_back(parts[i].text);
      if (nth > 1) own += fmt::format(" {}", nth);
      on_imported_({.file = path, .of = importer_.import({.name = own, .folder = folder, .text = parts[i].text})});
    }
  }

  const FolderImport& order_;
  const OnImported& on_imported_;
  io::SteadyClock clock_;
  json::JsonDocuments documents_;
  app::Programs programs_;
  app::Importer importer_;
  std::map<std::string, int> with_name_;  // files by folder and name
};

}  // namespace

app::Result<void> import_tree(store::Store& store, const FolderImport& order, const OnImported& on_imported) {
  return TreeImport(store, order, on_imported).run();
}

}  // namespace dripfeed::cli

// Files of one folder that differ by their ending alone keep it, so that each has a name of its own.
#include <map>
#include <string>

#include "server/app/library/import_file.h"
#include "server/cli/folder_files.h"
#include "server/cli/import_folder.h"
#include "server/io/steady_clock.h"
#include "server/json/documents.h"

namespace dripfeed::cli {

namespace {

app::ImportRow row_of(const std::string& path, app::ImportOutcome outcome, std::string why) {
  return {.file = path, .kind = "file", .of = {.outcome = outcome, .why = std::move(why)}};
}

class TreeImport {
 public:
  TreeImport(store::Store& store, const FolderImport& order, const app::OnImported& on_imported)
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
  [[nodiscard]] static std::string folder_and_name(const std::string& path) {
    const app::PlaceOfFile place = app::place_of_file(path, {});
    return place.folder + "/" + app::program_name_of(place.file);
  }

  void bring(const FoundFile& file) {
    if (!file.why_not.empty()) return on_imported_(row_of(file.path, app::ImportOutcome::skipped, file.why_not));
    const auto text = read_file(order_.folder / file.path, app::kLargestProgram_bytes);
    if (!text) return on_imported_(row_of(file.path, app::ImportOutcome::failed, text.error().text));
    app::import_file(importer_,
                     {.path = file.path,
                      .under = order_.under,
                      .bytes = *text,
                      .keeps_ending = with_name_[folder_and_name(file.path)] > 1},
                     on_imported_);
  }

  const FolderImport& order_;
  const app::OnImported& on_imported_;
  io::SteadyClock clock_;
  json::JsonDocuments documents_;
  app::Programs programs_;
  app::Importer importer_;
  std::map<std::string, int> with_name_;  // files by folder and name
};

}  // namespace

app::Result<void> import_tree(store::Store& store, const FolderImport& order, const app::OnImported& on_imported) {
  return TreeImport(store, order, on_imported).run();
}

}  // namespace dripfeed::cli

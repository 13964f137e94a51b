// What `dripfeed import` does with a folder: programs of any folder tree, or all that an export has.
#pragma once

#include <filesystem>
#include <string>

#include "server/app/library/import_file.h"
#include "store/store.h"

namespace dripfeed::cli {

struct FolderImport {
  std::filesystem::path folder;
  std::string under{};  // the library's folder in which the tree's folders lie; "": none
  app::ImportPlan plan{};
};

// The tree's folders become folders of the library. A file with several programs becomes a folder with each of them.
// Errors: unavailable (the folder cannot be read); all else is a row.
app::Result<void> import_tree(store::Store& store, const FolderImport& order, const app::OnImported& on_imported);

// The folder has the manifest of an export. Errors: unavailable, malformed, invalid (the manifest); all else is a row.
app::Result<void> import_export(store::Store& store, const FolderImport& order, const app::OnImported& on_imported);

}  // namespace dripfeed::cli

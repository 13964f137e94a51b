// What a shop has, as files of a folder with one manifest: plain data. Who writes and reads the files is the command;
// how the manifest is written is server/json's.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/library/importing.h"
#include "store/store.h"

namespace dripfeed::app {

inline constexpr std::string_view kManifestFile = "dripfeed-export.json";
inline constexpr std::uint64_t kManifestVersion = 1;

// A file of the folder: a revision of a text, a family, a part's values or a profile; or an attached file.
struct ShopFile {
  std::string path;  // in the folder, with slashes
  std::string sha256;
  std::uint64_t bytes = 0;
  store::Revision revision = 1;
  std::string by{};        // who brought it
  std::int64_t at_ms = 0;  // when
};

struct ShopProgram {
  store::Id id = 0;  // in the shop that it comes from: attachments name it
  std::string name;
  std::string dialect;
  std::string folder{};
  std::vector<std::string> tags{};
  store::Archived archived{};
  std::vector<ShopFile> revisions{};  // oldest first
};

// A family, part or machine: revisions of one document.
struct ShopDocument {
  std::string name;
  std::string family{};  // of a part
  std::vector<ShopFile> revisions{};
};

struct ShopAttachment {
  store::AttachedTo to{};  // a program by its id there; orders are not in it
  std::string name;
  std::string media_type;
  ShopFile file{};
};

struct ShopManifest {
  std::int64_t made_at_ms = 0;
  std::vector<ShopProgram> programs{};
  std::vector<ShopDocument> families{};
  std::vector<ShopDocument> parts{};
  std::vector<ShopDocument> machines{};
  std::vector<ShopAttachment> attachments{};
};

// What a row of a report is about; "file": it is none of the others.
inline constexpr std::array<std::string_view, 6> kImportKinds{"program", "family",     "part",
                                                              "machine", "attachment", "file"};

// What became of one thing of a folder that was imported.
struct ImportRow {
  std::string file;              // in the folder
  std::string kind = "program";  // of kImportKinds
  Imported of{};
};

}  // namespace dripfeed::app

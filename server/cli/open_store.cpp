// A file in the folder says that the store is elsewhere. It does not say where: an address may have a password in it.
#include "server/cli/open_store.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "server/cli/data_folder.h"
#include "store/postgresql/open.h"
#include "store/sqlite/open.h"

namespace dripfeed::cli {

namespace {

namespace fs = std::filesystem;

using store::Error;
using store::ErrorCode;
using store::Result;

fs::path mark_of(const std::string& data) { return fs::path(data) / "store-is-elsewhere"; }

std::unexpected<Error> refuse(std::string why) {
  return std::unexpected(Error{ErrorCode::cannot_open, std::move(why)});
}

}  // namespace

Result<void> know_place(const StorePlace& place) {
  std::error_code unknown;
  if (place.url.empty() && fs::exists(mark_of(place.data), unknown))
    return refuse(fmt::format("the store of {} is on PostgreSQL: name it with --store", place.data));
  if (!place.url.empty() && fs::exists(store_path(place.data), unknown))
    return refuse(fmt::format("{} is a store, too: use another folder with --store", store_path(place.data)));
  return {};
}

Result<void> mark_elsewhere(const StorePlace& place) {
  std::ofstream file(mark_of(place.data));
  file << "The store of this folder's server is on PostgreSQL. Its address is the option --store of dripfeed serve.\n";
  file.close();
  if (file) return {};
  return std::unexpected(
      Error{ErrorCode::io_failed, fmt::format("{} cannot be written", mark_of(place.data).string())});
}

Result<std::unique_ptr<store::Store>> open_to_serve(const StorePlace& place) {
  if (auto known = know_place(place); !known) return std::unexpected(known.error());
  if (place.url.empty()) return sqlite::open(store_path(place.data), {.own = true, .checkpoints_aside = true});
  auto opened = postgresql::open(place.url, {.own = true, .node = place.node, .local_folder = place.data});
  if (!opened) return opened;
  if (auto marked = mark_elsewhere(place); !marked) return std::unexpected(marked.error());
  return opened;
}

Result<std::unique_ptr<store::Store>> open_existing(const StorePlace& place) {
  if (!place.url.empty()) return postgresql::open(place.url, {.create = false});
  if (auto known = know_place(place); !known) return std::unexpected(known.error());
  return sqlite::open(store_path(place.data), {.create = false});
}

}  // namespace dripfeed::cli

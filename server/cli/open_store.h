// Opens the store of a data folder: in its file, or in a PostgreSQL database that an option names. A folder has one of
// the two: a server that was started without its option must not feed lines by an empty store.
#pragma once

#include <memory>
#include <string>

#include "store/store.h"

namespace dripfeed::cli {

inline constexpr const char* kStoreOption =
    "postgresql://USER@HOST/DATABASE: where the store is, if not in its folder; see --store of dripfeed serve";

struct StorePlace {
  std::string data;    // the folder
  std::string url{};   // of the database; "": the store is in the folder
  std::string node{};  // of several servers of it, this one
};

// As the one server of the store. It is made where there is none. Errors: as sqlite::open() and postgresql::open();
// cannot_open where the store of this folder is at the other place.
store::Result<std::unique_ptr<store::Store>> open_to_serve(const StorePlace& place);
// The store of a folder is in one place. Errors: cannot_open where it is not the one that `place` names.
store::Result<void> know_place(const StorePlace& place);
// From here on a server of this folder does not start without its database. Errors: io_failed.
store::Result<void> mark_elsewhere(const StorePlace& place);
// A wrong folder or database must not become a new store.
store::Result<std::unique_ptr<store::Store>> open_existing(const StorePlace& place);

}  // namespace dripfeed::cli

// store/postgresql: the store on a PostgreSQL server. It alone names libpq. This header is all that others need: it
// opens a store, making its tables where there are none.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "store/store.h"

namespace dripfeed::postgresql {

struct OpenSettings {
  bool own = false;                      // be the one server of this store: others that want to own it get in_use
  bool create = true;                    // make the tables when they are not there
  std::uint32_t busy_timeout_ms = 5000;  // how long to wait for another process's write
  // One of several servers of this store, by its name; with `own`. "": the only one.
  std::string node{};
  // Folder on this computer, for one store and one server: what a feed needs while the database does not answer is kept
  // there, see store/journal/entry.h. "": a feed waits for the database.
  std::string local_folder{};
};

// Opens the database that `url` names ("postgresql://user@host/database", all that libpq takes), brings its schema up
// to date. A connection that breaks is made again by the next call. With `own` nothing is changed any more once another
// server has owned the store. With a local folder what
// was left there is booked first. Store::backup() is refused (invalid_value): the server has means of its own. Errors:
// cannot_open, in_use, not_a_store, newer_schema, migration_failed, disk_full, io_failed, no_answer, busy.
store::Result<std::unique_ptr<store::Store>> open(const std::string& url, const OpenSettings& settings = {});

}  // namespace dripfeed::postgresql

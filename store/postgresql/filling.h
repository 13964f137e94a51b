// A store that was elsewhere, put into an empty database: what a shop does that outgrows the file of its store.
#pragma once

#include <span>
#include <string>

#include "store/postgresql/migrations.h"
#include "store/postgresql/open.h"
#include "store/sql/connection.h"

namespace dripfeed::postgresql {

// Makes the tables in the database that `url` names, and puts every row of `from` into them: a store of another engine
// with the newest schema, which no one changes meanwhile. All of it is one transaction. Errors: as open(), in_use where
// a server runs on the database; exists where a shop is in it already; internal where the tables of the two engines
// differ. `known`: the tables as of these migrations, for a `from` that is as old.
store::Result<void> fill(const std::string& url, sql::Connection& from,
                         std::span<const sql::Migration> known = migrations());

}  // namespace dripfeed::postgresql

// A PostgreSQL server for tests: in a folder that goes away, at a socket in it. It ends with the test, however that
// ends.
#pragma once

#include <string>

namespace dripfeed::store_test {

// Where the database with this name is, for libpq. The first call starts the server; without one the program ends with
// a reason.
std::string database_url(const std::string& name);
// A database that is a copy of another one, which no one may be connected to.
void make_database(const std::string& name, const std::string& copy_of = "template1");
// Runs SQL; the server's words, "" when it went well.
std::string run_sql(const std::string& database, const std::string& text);
// Ends the connections to a database, as a server that is started again does.
void cut_connections(const std::string& database);

}  // namespace dripfeed::store_test

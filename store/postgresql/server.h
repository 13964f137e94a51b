// Opens connections to one database. With `own` the connection that writes holds the lock of the one server of a store,
// or of the one process of a node's name: it goes with the connection, and is taken again with the next one, unless
// another had it meanwhile.
#pragma once

#include <string>

#include "store/postgresql/connection.h"

namespace dripfeed::postgresql {

// As the one program that has the database: no server may run on it. It brings no schema up to date. Errors: as open(),
// in_use.
store::Result<std::unique_ptr<Connection>> connect_alone(const std::string& url);

class Server final : public sql::Engine {
 public:
  // Takes the lock, where it is asked for, and brings the schema up to date.
  static store::Result<std::unique_ptr<Server>> open(const std::string& url, const OpenSettings& settings);
  // Takes no lock, and never writes.
  static std::unique_ptr<Server> only_read(const std::string& url);
  store::Result<std::unique_ptr<sql::Connection>> connect_to_read() override;
  store::Result<std::unique_ptr<sql::Connection>> connect_to_write() override;
  // Null for one that only reads, and for programs that do not own the store: they wait as long as it takes.
  [[nodiscard]] const std::shared_ptr<const Pulse>& pulse() const { return pulse_; }

 private:
  Server(std::string url, OpenSettings settings) : url_(std::move(url)), settings_(std::move(settings)) {}
  store::Result<void> lock(Connection& connection) const;
  store::Result<void> lock_as_node(Connection& connection) const;
  store::Result<void> begin_epoch(Connection& connection);
  store::Result<void> know_epoch(Connection& connection) const;

  std::string url_;
  OpenSettings settings_;
  std::uint64_t epoch_ = 0;  // of the owner: larger with each server that owned the store
  std::shared_ptr<const Pulse> pulse_;
  std::unique_ptr<Connection> first_;  // that open() used: the first one to write with
};

}  // namespace dripfeed::postgresql

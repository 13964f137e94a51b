// What a repository writes its queries with, inside one transaction: parameters in, columns out. The first fault of the
// engine sticks: what follows does nothing, and the transaction is undone by whoever began it.
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>

#include "store/basics.h"
#include "store/error.h"
#include "store/sql/connection.h"

namespace dripfeed::sql {

// Parameters that are no text, number or named enum.
struct Bytes {
  std::string_view data;  // a BLOB
};
struct OrNull {
  std::string_view text;  // NULL when empty
};
struct NumberOrNull {
  std::uint64_t number;  // NULL when 0
};

class Session;

// A statement that runs. Columns are read in their order, each once a row.
class Query {
 public:
  // The text of the SQL, and of Bytes, must live as long as the query.
  template <class... P>
  Query(Session& session, std::string_view sql, const P&... parameters) : Query(Prepared{}, session, sql) {
    (bind_any(parameters), ...);
  }
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;
  ~Query();

  // The next row. False at the end, and on a fault, which the session keeps.
  bool next();
  std::string text();  // "" for NULL
  std::uint64_t number();
  std::int64_t signed_number();
  bool flag() { return number() != 0; }
  std::span<const std::byte> bytes();  // until the next call of next()
  template <store::Named E>
  E value() {
    const std::optional<E> found = store::named<E>(text());
    if (!found) unknown_name();
    return found.value_or(E{});
  }

 private:
  struct Prepared {};
  Query(Prepared tag, Session& session, std::string_view sql);
  void bind(std::string_view text);
  void bind(Bytes bytes);
  void bind(OrNull text);
  void bind(NumberOrNull number);
  void bind_number(std::uint64_t number);
  void bind_signed(std::int64_t number);
  template <class T>
  void bind_any(const T& value) {
    if constexpr (store::Named<T>) {
      bind(store::name_of(value));
    } else if constexpr (std::unsigned_integral<T>) {
      bind_number(value);
    } else if constexpr (std::signed_integral<T>) {
      bind_signed(value);
    } else if constexpr (std::convertible_to<T, std::string_view>) {
      bind(std::string_view(value));
    } else {
      bind(value);
    }
  }
  void check(bool bound);
  void unknown_name();

  Session& session_;
  std::string_view sql_;
  std::unique_ptr<Statement> statement_;
  int parameter_ = 0;
  int column_ = 0;
};

class Session {
 public:
  // `about` names the row that all this is for, as the audit does: "machine/mill-3".
  Session(Connection& connection, std::string_view about) : connection_(connection), about_(about) {}
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Runs a statement that gives no rows. False on a fault.
  template <class... P>
  bool run(std::string_view sql, const P&... parameters) {
    Query(*this, sql, parameters...).next();
    return ok();
  }
  [[nodiscard]] std::uint64_t changed_rows() const { return connection_.changed_rows(); }
  [[nodiscard]] store::Id last_id() const { return connection_.last_id(); }
  [[nodiscard]] const Words& words() const { return connection_.words(); }

  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  [[nodiscard]] const store::Error& error() const { return *error_; }
  [[nodiscard]] std::string_view about() const { return about_; }
  // What a body returns to undo its transaction. The detail names the row when it is empty.
  [[nodiscard]] std::unexpected<store::Error> refuse(store::ErrorCode code, std::string detail = {}) const;

 private:
  friend class Query;
  void fail();

  Connection& connection_;
  std::string about_;
  std::optional<store::Error> error_;
};

}  // namespace dripfeed::sql

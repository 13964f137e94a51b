// Binding, stepping, reading columns.
#include "store/sqlite/session.h"

#include <limits>

#include <fmt/format.h>
#include <sqlite3.h>

#include "store/sqlite/fault.h"

namespace dripfeed::sqlite {

Query::Query(Prepared /*tag*/, Session& session, std::string_view sql)
    : session_(session), sql_(sql), statement_(session.ok() ? session.connection_.take(sql) : nullptr) {
  if (statement_ == nullptr && session_.ok()) session_.fail();
}

Query::~Query() { session_.connection_.give_back(sql_, statement_); }

bool Query::next() {
  column_ = 0;
  if (!session_.ok()) return false;
  const int result = sqlite3_step(statement_);
  if (result == SQLITE_ROW) return true;
  if (result != SQLITE_DONE) session_.fail();
  return false;
}

std::string Query::text() {
  const auto data = bytes();
  return {reinterpret_cast<const char*>(data.data()), data.size()};
}

std::uint64_t Query::number() {
  const std::int64_t value = signed_number();
  return value < 0 ? 0 : static_cast<std::uint64_t>(value);  // the schema's CHECKs keep these from being negative
}

std::int64_t Query::signed_number() { return session_.ok() ? sqlite3_column_int64(statement_, column_++) : 0; }

std::span<const std::byte> Query::bytes() {
  if (!session_.ok()) return {};
  const int column = column_++;
  const void* data = sqlite3_column_blob(statement_, column);  // before its size: this converts
  return {static_cast<const std::byte*>(data), static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

void Query::bind(std::string_view text) {
  if (!session_.ok()) return;
  // A null pointer would bind NULL where an empty text is meant.
  check(sqlite3_bind_text64(statement_, ++parameter_, text.data() == nullptr ? "" : text.data(), text.size(),
                            SQLITE_TRANSIENT, SQLITE_UTF8));
}

void Query::bind(Bytes bytes) {
  if (!session_.ok()) return;
  check(sqlite3_bind_blob64(statement_, ++parameter_, bytes.data.data() == nullptr ? "" : bytes.data.data(),
                            bytes.data.size(), SQLITE_STATIC));
}

void Query::bind(OrNull text) {
  if (!text.text.empty()) return bind(text.text);
  if (session_.ok()) check(sqlite3_bind_null(statement_, ++parameter_));
}

void Query::bind(NumberOrNull number) {
  if (number.number != 0) return bind_number(number.number);
  if (session_.ok()) check(sqlite3_bind_null(statement_, ++parameter_));
}

void Query::bind_number(std::uint64_t number) {
  if (!session_.ok()) return;
  if (number > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    session_.error_ = store::Error{store::ErrorCode::invalid_value, fmt::format("{} is too large", number)};
    return;
  }
  bind_signed(static_cast<std::int64_t>(number));
}

void Query::bind_signed(std::int64_t number) {
  if (session_.ok()) check(sqlite3_bind_int64(statement_, ++parameter_, number));
}

void Query::check(int result) {
  if (result != SQLITE_OK) session_.fail();
}

void Query::unknown_name() {
  if (!session_.ok()) return;
  session_.error_ =
      store::Error{store::ErrorCode::corrupt, fmt::format("{}: a name that is not known", session_.about_)};
}

std::uint64_t Session::changed_rows() const {
  return static_cast<std::uint64_t>(sqlite3_changes64(connection_.handle()));
}

store::Id Session::last_id() const { return static_cast<store::Id>(sqlite3_last_insert_rowid(connection_.handle())); }

std::unexpected<store::Error> Session::refuse(store::ErrorCode code, std::string detail) const {
  return std::unexpected(store::Error{code, detail.empty() ? about_ : std::move(detail)});
}

void Session::fail() {
  if (!error_) error_ = fault_of(connection_.handle(), about_);
}

}  // namespace dripfeed::sqlite

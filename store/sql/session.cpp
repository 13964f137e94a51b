// Binding, stepping, reading columns.
#include "store/sql/session.h"

#include <limits>
#include <utility>

#include <fmt/format.h>

namespace dripfeed::sql {

Query::Query(Prepared /*tag*/, Session& session, std::string_view sql)
    : session_(session), sql_(sql), statement_(session.ok() ? session.connection_.take(sql) : nullptr) {
  if (statement_ == nullptr && session_.ok()) session_.fail();
}

Query::~Query() { session_.connection_.give_back(sql_, std::move(statement_)); }

bool Query::next() {
  column_ = 0;
  if (!session_.ok()) return false;
  const Statement::Step step = statement_->step();
  if (step == Statement::Step::fault) session_.fail();
  return step == Statement::Step::row;
}

std::string Query::text() {
  const auto data = bytes();
  return {reinterpret_cast<const char*>(data.data()), data.size()};
}

std::uint64_t Query::number() {
  const std::int64_t value = signed_number();
  return value < 0 ? 0 : static_cast<std::uint64_t>(value);  // the schema's CHECKs keep these from being negative
}

std::int64_t Query::signed_number() { return session_.ok() ? statement_->number(column_++) : 0; }

std::span<const std::byte> Query::bytes() {
  if (!session_.ok()) return {};
  return statement_->bytes(column_++);
}

void Query::bind(std::string_view text) {
  if (session_.ok()) check(statement_->bind_text(++parameter_, text));
}

void Query::bind(Bytes bytes) {
  if (session_.ok()) check(statement_->bind_bytes(++parameter_, bytes.data));
}

void Query::bind(OrNull text) {
  if (!text.text.empty()) return bind(text.text);
  if (session_.ok()) check(statement_->bind_null(++parameter_));
}

void Query::bind(NumberOrNull number) {
  if (number.number != 0) return bind_number(number.number);
  if (session_.ok()) check(statement_->bind_null(++parameter_));
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
  if (session_.ok()) check(statement_->bind_number(++parameter_, number));
}

void Query::check(bool bound) {
  if (!bound) session_.fail();
}

void Query::unknown_name() {
  if (!session_.ok()) return;
  session_.error_ =
      store::Error{store::ErrorCode::corrupt, fmt::format("{}: a name that is not known", session_.about_)};
}

std::unexpected<store::Error> Session::refuse(store::ErrorCode code, std::string detail) const {
  return std::unexpected(store::Error{code, detail.empty() ? about_ : std::move(detail)});
}

void Session::fail() {
  if (!error_) error_ = connection_.fault(about_);
}

}  // namespace dripfeed::sql

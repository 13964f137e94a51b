// Binding, stepping, reading columns.
#include "store/sqlite/statement.h"

#include <sqlite3.h>

namespace dripfeed::sqlite {
namespace {

// A null pointer would bind NULL where an empty text is meant.
const char* begin_of(std::string_view text) { return text.data() == nullptr ? "" : text.data(); }

}  // namespace

Statement::~Statement() { sqlite3_finalize(statement_); }

bool Statement::bind_text(int parameter, std::string_view text) {
  return sqlite3_bind_text64(statement_, parameter, begin_of(text), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8) ==
         SQLITE_OK;
}

bool Statement::bind_bytes(int parameter, std::string_view bytes) {
  return sqlite3_bind_blob64(statement_, parameter, begin_of(bytes), bytes.size(), SQLITE_STATIC) == SQLITE_OK;
}

bool Statement::bind_number(int parameter, std::int64_t number) {
  return sqlite3_bind_int64(statement_, parameter, number) == SQLITE_OK;
}

bool Statement::bind_null(int parameter) { return sqlite3_bind_null(statement_, parameter) == SQLITE_OK; }

Statement::Step Statement::step() {
  const int result = sqlite3_step(statement_);
  if (result == SQLITE_ROW) return Step::row;
  return result == SQLITE_DONE ? Step::end : Step::fault;
}

std::int64_t Statement::number(int column) { return sqlite3_column_int64(statement_, column); }

std::span<const std::byte> Statement::bytes(int column) {
  const void* data = sqlite3_column_blob(statement_, column);  // before its size: this converts
  return {static_cast<const std::byte*>(data), static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

void Statement::reset() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

}  // namespace dripfeed::sqlite

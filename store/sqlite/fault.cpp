// The table of result codes.
#include "store/sqlite/fault.h"

#include <array>

#include <fmt/format.h>
#include <sqlite3.h>

namespace dripfeed::sqlite {
namespace {

using store::ErrorCode;

struct Row {
  int result;
  ErrorCode code;
};

// Extended codes before the primary ones that they belong to: the first match counts.
constexpr std::array kRows{
    Row{SQLITE_CONSTRAINT_UNIQUE, ErrorCode::exists},
    Row{SQLITE_CONSTRAINT_PRIMARYKEY, ErrorCode::exists},
    Row{SQLITE_CONSTRAINT_ROWID, ErrorCode::exists},
    Row{SQLITE_CONSTRAINT_FOREIGNKEY, ErrorCode::broken_reference},
    Row{SQLITE_CONSTRAINT_TRIGGER, ErrorCode::append_only},  // all triggers of the schema say so
    Row{SQLITE_CONSTRAINT, ErrorCode::invalid_value},
    Row{SQLITE_TOOBIG, ErrorCode::invalid_value},
    Row{SQLITE_BUSY, ErrorCode::busy},
    Row{SQLITE_LOCKED, ErrorCode::busy},
    Row{SQLITE_FULL, ErrorCode::disk_full},
    Row{SQLITE_IOERR, ErrorCode::io_failed},
    Row{SQLITE_READONLY, ErrorCode::io_failed},
    Row{SQLITE_CORRUPT, ErrorCode::corrupt},
    Row{SQLITE_NOTADB, ErrorCode::not_a_store},
    Row{SQLITE_CANTOPEN, ErrorCode::cannot_open},
    Row{SQLITE_PERM, ErrorCode::cannot_open},
};

}  // namespace

ErrorCode code_of(int extended_result_code) {
  constexpr int kPrimary = 0xFF;
  for (const Row& row : kRows) {
    if (row.result == extended_result_code || row.result == (extended_result_code & kPrimary)) return row.code;
  }
  return ErrorCode::internal;
}

store::Error fault_of(sqlite3* connection, std::string_view about) {
  const int result = sqlite3_extended_errcode(connection);
  const std::string_view words = sqlite3_errmsg(connection);
  return {code_of(result), about.empty() ? std::string(words) : fmt::format("{}: {}", about, words)};
}

}  // namespace dripfeed::sqlite

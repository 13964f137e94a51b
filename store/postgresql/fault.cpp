// The table of error codes: Appendix A of PostgreSQL's manual, and DF001 and DF002, which the triggers of the schema
// raise.
#include "store/postgresql/fault.h"

#include <array>

namespace dripfeed::postgresql {
namespace {

using store::ErrorCode;

struct Row {
  std::string_view state;  // or how it begins: two letters name a class
  ErrorCode code;
};

// A code before the class that it belongs to: the first match counts.
constexpr std::array kRows{
    Row{"DF001", ErrorCode::append_only},
    Row{"DF002", ErrorCode::not_leased},
    Row{"23505", ErrorCode::exists},
    Row{"23503", ErrorCode::broken_reference},
    Row{"23001", ErrorCode::broken_reference},
    Row{"23", ErrorCode::invalid_value},  // other constraints
    Row{"22", ErrorCode::invalid_value},  // data, as bytes that are no UTF-8
    Row{"54", ErrorCode::invalid_value},  // limits of the program
    Row{"55P03", ErrorCode::busy},        // lock_timeout
    Row{"57014", ErrorCode::busy},        // statement_timeout, or an administrator
    Row{"40", ErrorCode::busy},           // serialization, deadlock
    Row{"53100", ErrorCode::disk_full},
    Row{"53300", ErrorCode::cannot_open},  // too many connections
    Row{"XX001", ErrorCode::corrupt},
    Row{"XX002", ErrorCode::corrupt},
    Row{"28", ErrorCode::cannot_open},     // authorization
    Row{"3D", ErrorCode::cannot_open},     // no such database
    Row{"42501", ErrorCode::cannot_open},  // privileges
    Row{"57P03", ErrorCode::cannot_open},  // it starts or stops
    Row{"25006", ErrorCode::io_failed},    // a standby that is only read
    Row{"08", ErrorCode::no_answer},       // the connection
    Row{"53", ErrorCode::io_failed},
    Row{"57", ErrorCode::no_answer},  // it was ended, or the server ends
    Row{"58", ErrorCode::io_failed},
};

}  // namespace

ErrorCode code_of(std::string_view sql_state) {
  if (sql_state.empty()) return ErrorCode::no_answer;  // libpq's own fault: there is no connection
  for (const Row& row : kRows) {
    if (sql_state.starts_with(row.state)) return row.code;
  }
  return ErrorCode::internal;
}

}  // namespace dripfeed::postgresql

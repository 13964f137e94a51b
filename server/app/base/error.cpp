// One row a code of the store.
#include "server/app/base/error.h"

#include <array>

namespace dripfeed::app {

namespace {

struct Row {
  store::ErrorCode store;
  ErrorCode app;
};
constexpr std::array kRows = {
    Row{store::ErrorCode::not_found, ErrorCode::not_found},
    Row{store::ErrorCode::exists, ErrorCode::exists},
    Row{store::ErrorCode::stale_revision, ErrorCode::stale},
    Row{store::ErrorCode::broken_reference, ErrorCode::invalid},
    Row{store::ErrorCode::invalid_value, ErrorCode::invalid},
    Row{store::ErrorCode::refused_transition, ErrorCode::refused},
    Row{store::ErrorCode::no_verdict, ErrorCode::refused},
    Row{store::ErrorCode::verdict_not_passed, ErrorCode::refused},
    Row{store::ErrorCode::verdict_stale, ErrorCode::refused},
    Row{store::ErrorCode::not_released, ErrorCode::refused},
    Row{store::ErrorCode::transfers_used_up, ErrorCode::refused},
    Row{store::ErrorCode::sign_off_missing, ErrorCode::refused},
    Row{store::ErrorCode::not_proved, ErrorCode::refused},
    Row{store::ErrorCode::not_signed_off, ErrorCode::refused},
    Row{store::ErrorCode::four_eyes, ErrorCode::refused},
    Row{store::ErrorCode::machine_busy, ErrorCode::refused},
    Row{store::ErrorCode::not_leased, ErrorCode::refused},
    Row{store::ErrorCode::machine_torn, ErrorCode::refused},
    Row{store::ErrorCode::too_early, ErrorCode::refused},
    Row{store::ErrorCode::on_hold, ErrorCode::refused},
    Row{store::ErrorCode::end_not_confirmed, ErrorCode::refused},
    Row{store::ErrorCode::key_reused, ErrorCode::invalid},
    Row{store::ErrorCode::append_only, ErrorCode::refused},
    Row{store::ErrorCode::busy, ErrorCode::unavailable},
    Row{store::ErrorCode::in_use, ErrorCode::unavailable},
    Row{store::ErrorCode::disk_full, ErrorCode::unavailable},
    Row{store::ErrorCode::io_failed, ErrorCode::unavailable},
    Row{store::ErrorCode::no_answer, ErrorCode::unavailable},
    Row{store::ErrorCode::cannot_open, ErrorCode::unavailable},  // a database server that does not answer
};

}  // namespace

Error from_store(const store::Error& error) {
  for (const Row& row : kRows) {
    if (row.store == error.code) return {row.app, store::message_of(error), {}};
  }
  return {ErrorCode::internal, store::message_of(error), {}};
}

}  // namespace dripfeed::app

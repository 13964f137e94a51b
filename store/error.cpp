// The table of errors: name and sentence.
#include "store/error.h"

#include <array>
#include <cerrno>
#include <cstddef>

namespace dripfeed::store {
namespace {

struct Row {
  ErrorCode code;
  std::string_view name;
  std::string_view text;
};

constexpr std::array kRows{
    Row{ErrorCode::not_found, "not-found", "it does not exist"},
    Row{ErrorCode::exists, "exists", "it exists already"},
    Row{ErrorCode::stale_revision, "stale-revision", "another change came first"},
    Row{ErrorCode::broken_reference, "broken-reference", "it refers to something that is not there"},
    Row{ErrorCode::invalid_value, "invalid-value", "a value is missing or out of range"},
    Row{ErrorCode::refused_transition, "refused-transition", "this state cannot follow the present one"},
    Row{ErrorCode::no_verdict, "no-verdict", "the text was never checked for this machine and delivery"},
    Row{ErrorCode::verdict_not_passed, "verdict-not-passed", "the newest verdict of the text does not clear it"},
    Row{ErrorCode::verdict_stale, "verdict-stale", "what it rests on changed after the verdict"},
    Row{ErrorCode::not_released, "not-released", "no release lets this text go to this machine"},
    Row{ErrorCode::transfers_used_up, "transfers-used-up", "the transfers of the proving are used up"},
    Row{ErrorCode::sign_off_missing, "sign-off-missing", "an approval needs a note of who signs it off"},
    Row{ErrorCode::not_proved, "not-proved", "no transfer has ended well since the proving began"},
    Row{ErrorCode::not_signed_off, "not-signed-off", "no operator has signed the proving off"},
    Row{ErrorCode::four_eyes, "four-eyes", "whoever wrote or released a text may not approve it on this machine"},
    Row{ErrorCode::machine_busy, "machine-busy", "another job has the machine's line"},
    Row{ErrorCode::not_leased, "not-leased", "the machine's line is with another server of this store"},
    Row{ErrorCode::machine_torn, "machine-torn",
        "a block was torn on this machine: a person must confirm that the control was reset"},
    Row{ErrorCode::too_early, "too-early", "the job may not be armed before its time"},
    Row{ErrorCode::on_hold, "on-hold", "a person put the job on hold"},
    Row{ErrorCode::end_not_confirmed, "end-not-confirmed",
        "a person must first confirm the end of another job of this machine"},
    Row{ErrorCode::key_reused, "key-reused", "the idempotency key was used for another request"},
    Row{ErrorCode::append_only, "append-only", "what is written there never changes"},
    Row{ErrorCode::busy, "busy", "another program holds the database for too long"},
    Row{ErrorCode::in_use, "in-use", "another server runs on this database"},
    Row{ErrorCode::disk_full, "disk-full", "the disk is full"},
    Row{ErrorCode::io_failed, "io-failed", "the disk could not be read or written"},
    Row{ErrorCode::no_answer, "no-answer", "the database does not answer"},
    Row{ErrorCode::corrupt, "corrupt", "the database is damaged"},
    Row{ErrorCode::not_a_store, "not-a-store", "the file is not a database of dripfeed"},
    Row{ErrorCode::newer_schema, "newer-schema", "the database was written by a newer dripfeed"},
    Row{ErrorCode::migration_failed, "migration-failed", "the database could not be brought up to date"},
    Row{ErrorCode::cannot_open, "cannot-open", "the database cannot be opened"},
    Row{ErrorCode::internal, "internal", "the database refused for a reason that should not exist"},
};

constexpr bool in_order() {
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (static_cast<std::size_t>(kRows[i].code) != i) return false;
  }
  return static_cast<std::size_t>(ErrorCode::internal) + 1 == kRows.size();
}
static_assert(in_order(), "one row per code, in the order of the enum");

}  // namespace

std::string_view name_of(ErrorCode code) { return kRows[static_cast<std::size_t>(code)].name; }

std::string_view text_of(ErrorCode code) { return kRows[static_cast<std::size_t>(code)].text; }

std::string message_of(const Error& error) {
  std::string message(text_of(error.code));
  if (!error.detail.empty()) message.append(" (").append(error.detail).append(")");
  return message;
}

ErrorCode code_of_file_fault(int error_number) {
  return error_number == ENOSPC || error_number == EDQUOT ? ErrorCode::disk_full : ErrorCode::io_failed;
}

}  // namespace dripfeed::store

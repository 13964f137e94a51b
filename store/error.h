// What can go wrong in a store, as one list. `detail` names the row or says what the engine said; the text of a code
// comes from one table. No exception leaves the store.
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

namespace dripfeed::store {

enum class ErrorCode : std::uint8_t {
  not_found,           // no such row
  exists,              // the name, number or key is taken
  stale_revision,      // the caller changed another revision than the newest
  broken_reference,    // the row names one that is not there
  invalid_value,       // an empty name, a negative size, a bad cursor: the call makes no sense
  refused_transition,  // the table of states has no such row
  no_verdict,          // the text was never checked for this machine and delivery
  verdict_not_passed,  // its newest verdict is fail, or unknown without a waiver
  verdict_stale,       // something newer makes the verdict worthless (Verdict::stale)
  not_released,        // no release lets this text go to this machine
  transfers_used_up,   // a release in proving has had its transfers
  sign_off_missing,    // a release is approved by a person with a note
  not_proved,          // an operator signs off what a transfer has shown
  not_signed_off,      // a release is approved after its operator signed the proving off
  four_eyes,           // who wrote or released a text wants to approve it
  machine_busy,        // another job of the machine is armed or runs
  not_leased,          // the machine's line is another node's
  machine_torn,        // a block was torn; a person must confirm the reset of the control first
  too_early,           // a job may not be armed before its time
  on_hold,             // a person put the job on hold
  end_not_confirmed,   // the end of another job of the machine waits for a person
  key_reused,          // an idempotency key came back with another request
  append_only,         // the row may never change
  busy,                // another process holds the write lock for too long
  in_use,              // another server owns this store
  disk_full,
  io_failed,
  no_answer,     // of a database server: it fell silent, or the connection broke; what was asked may have been done
  corrupt,       // the file is damaged, or bytes do not have their hash
  not_a_store,   // the file is something else
  newer_schema,  // written by a newer program than this
  migration_failed,
  cannot_open,
  internal,  // the engine refused for a reason that should not exist
};

// What a system's error number (errno) of a file means: disk_full, or io_failed.
ErrorCode code_of_file_fault(int error_number);

struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string detail;
};

template <class T>
using Result = std::expected<T, Error>;

// Short and stable, for logs and clients: "stale-revision".
std::string_view name_of(ErrorCode code);
// One sentence for people.
std::string_view text_of(ErrorCode code);
// The sentence and the detail.
std::string message_of(const Error& error);

}  // namespace dripfeed::store

// Receipts: programs that controls punched, and requests that operators made from there. A receipt never overwrites
// anything: its text becomes a program's revision only when a person accepts it. A broken one keeps its bytes as they
// came, in quarantine.
#pragma once

#include <optional>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

enum class ReceiptState : std::uint8_t { stored, quarantined, accepted, discarded };
template <>
inline constexpr std::array<std::string_view, 4> kNames<ReceiptState>{"stored", "quarantined", "accepted", "discarded"};

struct NewReceipt {
  std::string machine{};
  std::string name{};    // as the program names itself, or by its time
  std::string style{};   // how the name was found
  std::string sha256{};  // the text, or the bytes as they came of a quarantined one; put before
  std::uint64_t raw_bytes = 0;
  std::string code{};      // "iso", "ascii", "eia"
  std::string ended_by{};  // the sign that ended it
  bool quarantined = false;
  std::string reason{};  // why it is in quarantine
};

struct Receipt {
  Id id = 0;
  NewReceipt of;
  ReceiptState state = ReceiptState::stored;
  std::uint64_t bytes = 0;  // of the content
  std::int64_t at_ms = 0;
  Id program = 0;         // once it is accepted
  Revision revision = 0;  // of that program
  std::string decided_by;
  std::string decided_reason;
  std::int64_t decided_at_ms = 0;  // 0: not yet
};

struct ReceiptFilter {
  std::string machine{};  // empty: all
  std::optional<ReceiptState> state{};
};

// What an operator asked for, and the result.
struct NewRequest {
  std::string machine{};
  std::string verb{};
  std::string argument{};
  std::string text{};     // the program that asked, as it came
  std::string outcome{};  // "answered", "queued", "armed", "refused"
  std::string detail{};   // for people
  Id job = 0;             // that it made; 0: none
};
struct Request {
  Id id = 0;
  NewRequest of;
  std::int64_t at_ms = 0;
};

class Receipts : public Repository {
 public:
  // Errors: broken_reference (no such machine or content).
  virtual Result<Receipt> add(const NewReceipt& receipt, const Stamp& by) = 0;
  // Errors: not_found, refused_transition (it was decided before), broken_reference (no such revision), invalid_value
  // (one in quarantine, without a reason).
  virtual Result<Receipt> accept(Id receipt, Id program, Revision revision, std::string_view reason,
                                 const Stamp& by) = 0;
  // Errors: not_found, refused_transition, invalid_value (no reason).
  virtual Result<Receipt> discard(Id receipt, std::string_view reason, const Stamp& by) = 0;
  // Errors: not_found.
  virtual Result<Receipt> get(Id receipt) = 0;
  // Newest first.
  virtual Result<Page<Receipt>> list(const PageRequest& page, const ReceiptFilter& filter = {}) = 0;
  virtual Result<Request> add_request(const NewRequest& request, const Stamp& by) = 0;
  // Newest first; of one machine when it is not empty.
  virtual Result<Page<Request>> requests(const PageRequest& page, std::string_view machine = {}) = 0;
};

}  // namespace dripfeed::store

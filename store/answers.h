// Answers to operators: short programs that go to a control outside any job, because its operator asked. One is booked
// before a byte of it may leave, so that an answer that broke off inside a block is known after a restart, too. A torn
// answer leaves its machine torn until a person confirms that the control was reset, as a torn job does.
#pragma once

#include <optional>
#include <vector>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

enum class AnswerState : std::uint8_t {
  sending,  // bytes may have left
  whole,    // it ended between two blocks
  torn,     // it broke off inside a block, or no one lived to say how it ended
};
template <>
inline constexpr std::array<std::string_view, 3> kNames<AnswerState>{"sending", "whole", "torn"};

struct Answer {
  Id id = 0;
  std::string machine;
  std::uint64_t bytes_total = 0;  // wire bytes
  AnswerState state = AnswerState::sending;
  std::string reason;  // how it ended
  std::int64_t begun_at_ms = 0;
  std::int64_t ended_at_ms = 0;  // 0: not yet
  std::string confirmed_by;      // who said that the control was reset
  std::string confirm_reason;
  std::int64_t confirmed_at_ms = 0;  // 0: never

  // Nothing may leave on the machine's line until a person confirms.
  [[nodiscard]] bool needs_confirmation() const { return state == AnswerState::torn && confirmed_at_ms == 0; }
};

class Answers : public Repository {
 public:
  // Bytes of it may leave when this returns. Waits for no other writer but the ledger. Errors: broken_reference.
  virtual Result<Answer> begin(std::string_view machine, std::uint64_t bytes_total, const Stamp& by) = 0;
  // `to` is whole or torn. Errors: not_found, refused_transition (it ended before), invalid_value.
  virtual Result<Answer> end(Id answer, AnswerState to, std::string_view reason, const Stamp& by) = 0;
  // The torn answer that waits for a confirmation.
  virtual Result<std::optional<Answer>> torn_on(std::string_view machine) = 0;
  // A person says that the control of this machine was reset. Errors: not_found (nothing waits), invalid_value (no
  // reason).
  virtual Result<Answer> confirm_reset(std::string_view machine, std::string_view reason, const Stamp& by) = 0;
  // For the start of a server: what was being sent to these machines when the one before it ended is torn.
  virtual Result<std::vector<Answer>> tear_unfinished(const Stamp& by, const OfMachines& of = {}) = 0;
  // Newest first; of one machine when it is not empty.
  virtual Result<Page<Answer>> list(const PageRequest& page, std::string_view machine = {}) = 0;
};

}  // namespace dripfeed::store

// An answer's begin and its end are entries of their own.
#include "store/journal/journaled_answers.h"

#include <utility>

#include <fmt/format.h>

namespace dripfeed::journal {
namespace {

using store::Answer;
using store::AnswerState;
using store::Error;
using store::ErrorCode;
using store::Result;

constexpr std::chrono::seconds kPatience{5};

Entry entry_of(AnswerStep step, std::int64_t at_ms) {
  return {.serial = 0, .at_ms = at_ms, .rows = {}, .answer = std::move(step)};
}

}  // namespace

Result<Answer> JournaledAnswers::begin(std::string_view machine, std::uint64_t bytes_total, const store::Stamp& by) {
  const auto serial = journal_.keep(entry_of({.machine = std::string(machine),
                                              .to = AnswerState::sending,
                                              .bytes_total = bytes_total,
                                              .reason = {},
                                              .actor = by.actor},
                                             by.at_ms));
  if (!serial) return std::unexpected(serial.error());
  Answer answer;
  answer.id = *serial;
  answer.machine = machine;
  answer.bytes_total = bytes_total;
  answer.begun_at_ms = by.at_ms;
  const std::lock_guard lock(mutex_);
  begun_[answer.id] = answer;
  return answer;
}

Result<Answer> JournaledAnswers::end(store::Id answer, AnswerState to, std::string_view reason,
                                     const store::Stamp& by) {
  if (to == AnswerState::sending) return std::unexpected(Error{ErrorCode::invalid_value, "an answer ends"});
  const std::lock_guard lock(mutex_);
  const auto begun = begun_.find(answer);
  if (begun == begun_.end()) return std::unexpected(Error{ErrorCode::not_found, fmt::format("answer/{}", answer)});
  const auto serial = journal_.keep(entry_of({.machine = begun->second.machine,
                                              .to = to,
                                              .bytes_total = begun->second.bytes_total,
                                              .reason = std::string(reason),
                                              .actor = by.actor},
                                             by.at_ms));
  if (!serial) return std::unexpected(serial.error());
  Answer ended = std::move(begun->second);
  begun_.erase(begun);
  ended.state = to;
  ended.reason = reason;
  ended.ended_at_ms = by.at_ms;
  return ended;
}

Result<std::optional<Answer>> JournaledAnswers::torn_on(std::string_view machine) {
  std::optional<Answer> torn;
  journal_.each_waiting([&](const Entry& entry) {
    if (!entry.answer || entry.answer->machine != machine || entry.answer->to != AnswerState::torn) return;
    torn.emplace();
    torn->machine = machine;
    torn->bytes_total = entry.answer->bytes_total;
    torn->state = AnswerState::torn;
    torn->reason = entry.answer->reason;
    torn->ended_at_ms = entry.at_ms;
  });
  if (torn) return torn;
  return booked_.torn_on(machine);
}

Result<Answer> JournaledAnswers::confirm_reset(std::string_view machine, std::string_view reason,
                                               const store::Stamp& by) {
  if (!journal_.wait_until_booked(kPatience))
    return std::unexpected(Error{ErrorCode::busy, "the database does not answer, so what it must know is not booked"});
  return booked_.confirm_reset(machine, reason, by);
}

}  // namespace dripfeed::journal

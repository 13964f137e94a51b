// Beginning and ending an answer are the ledger's business: both go before other writers.
#include "store/sql/answer_table.h"

#include <fmt/format.h>

#include "store/sql/audit_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::Answer;
using store::AnswerState;
using store::ErrorCode;
using store::Id;
using store::Result;
using store::Stamp;

std::string subject_of(Id answer) { return fmt::format("answer/{}", answer); }

// In the audit what concerns the line stands under its machine.
std::string machine_subject(std::string_view machine) { return fmt::format("machine/{}", machine); }

std::string answers_where(std::string_view rest) {
  return fmt::format(
      "SELECT id, machine, bytes_total, state, reason, begun_at_ms, ended_at_ms, confirmed_by, confirm_reason, "
      "confirmed_at_ms FROM answer WHERE {}",
      rest);
}

Answer read_answer(Query& query) {
  Answer answer;
  answer.id = query.number();
  answer.machine = query.text();
  answer.bytes_total = query.number();
  answer.state = query.value<AnswerState>();
  answer.reason = query.text();
  answer.begun_at_ms = query.signed_number();
  answer.ended_at_ms = query.signed_number();
  answer.confirmed_by = query.text();
  answer.confirm_reason = query.text();
  answer.confirmed_at_ms = query.signed_number();
  return answer;
}

std::optional<Answer> find(Session& session, Id id) {
  static const std::string kSql = answers_where("id = ?");
  Query query(session, kSql, id);
  if (!query.next()) return std::nullopt;
  return read_answer(query);
}

std::optional<Answer> find_torn(Session& session, std::string_view machine) {
  static const std::string kSql =
      answers_where("machine = ? AND state = 'torn' AND confirmed_at_ms = 0 ORDER BY id DESC LIMIT 1");
  Query query(session, kSql, machine);
  if (!query.next()) return std::nullopt;
  return read_answer(query);
}

void write_end(Session& session, const Answer& answer, const Stamp& by) {
  session.run("UPDATE answer SET state = ?, reason = ?, ended_at_ms = ? WHERE id = ?", answer.state, answer.reason,
              answer.ended_at_ms, answer.id);
  if (answer.state != AnswerState::torn) return;
  add_audit_row(session,
                {.action = "answer.torn",
                 .subject = machine_subject(answer.machine),
                 .detail = fmt::format("answer {}: {}", answer.id, answer.reason)},
                by);
}

}  // namespace

Result<Answer> AnswerTable::begin(std::string_view machine, std::uint64_t bytes_total, const Stamp& by) {
  return database_.write_first(fmt::format("machine/{}", machine), [&](Session& session) -> Result<Answer> {
    session.run("INSERT INTO answer (machine, bytes_total, state, begun_at_ms) VALUES (?, ?, 'sending', ?)", machine,
                bytes_total, by.at_ms);
    Answer answer;
    answer.id = session.last_id();
    answer.machine = machine;
    answer.bytes_total = bytes_total;
    answer.begun_at_ms = by.at_ms;
    return answer;
  });
}

Result<Answer> AnswerTable::end(Id id, AnswerState to, std::string_view reason, const Stamp& by) {
  return database_.write_first(subject_of(id), [&](Session& session) -> Result<Answer> {
    if (to == AnswerState::sending) return session.refuse(ErrorCode::invalid_value, "an answer ends whole or torn");
    auto answer = find(session, id);
    if (!answer) return session.refuse(ErrorCode::not_found);
    if (answer->state != AnswerState::sending) return session.refuse(ErrorCode::refused_transition);
    answer->state = to;
    answer->reason = reason;
    answer->ended_at_ms = by.at_ms;
    write_end(session, *answer, by);
    return *answer;
  });
}

Result<std::optional<Answer>> AnswerTable::torn_on(std::string_view machine) {
  return database_.read(fmt::format("machine/{}", machine),
                        [&](Session& session) -> Result<std::optional<Answer>> { return find_torn(session, machine); });
}

Result<Answer> AnswerTable::confirm_reset(std::string_view machine, std::string_view reason, const Stamp& by) {
  return database_.write(fmt::format("machine/{}", machine), [&](Session& session) -> Result<Answer> {
    if (reason.empty() || by.actor.empty())
      return session.refuse(ErrorCode::invalid_value, "a confirmation needs a reason and a name");
    auto answer = find_torn(session, machine);
    if (!answer) return session.refuse(ErrorCode::not_found);
    answer->confirmed_by = by.actor;
    answer->confirm_reason = reason;
    answer->confirmed_at_ms = by.at_ms;
    // Older ones of this machine were torn on the same line: the same reset ends them.
    session.run(
        "UPDATE answer SET confirmed_by = ?, confirm_reason = ?, confirmed_at_ms = ? WHERE machine = ? AND state = "
        "'torn' AND confirmed_at_ms = 0",
        by.actor, reason, by.at_ms, machine);
    add_audit_row(
        session,
        {.action = "machine.confirm-reset", .subject = machine_subject(machine), .detail = std::string(reason)}, by);
    return *answer;
  });
}

Result<std::vector<Answer>> AnswerTable::tear_unfinished(const Stamp& by, const store::OfMachines& of) {
  return database_.write("answers", [&](Session& session) -> Result<std::vector<Answer>> {
    std::vector<Answer> answers;
    {
      static const std::string kSql = answers_where("state = 'sending' ORDER BY id");
      Query query(session, kSql);
      while (query.next()) answers.push_back(read_answer(query));
    }
    if (of) std::erase_if(answers, [&](const Answer& answer) { return !of(answer.machine); });
    for (Answer& answer : answers) {
      answer.state = AnswerState::torn;
      answer.reason = "the server stopped while it was sent";
      answer.ended_at_ms = by.at_ms;
      write_end(session, answer, by);
    }
    return answers;
  });
}

Result<store::Page<Answer>> AnswerTable::list(const store::PageRequest& page, std::string_view machine) {
  return database_.read("answers", [&](Session& session) -> Result<store::Page<Answer>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    const std::string sql = answers_where(
        fmt::format("{} AND id < ? ORDER BY id DESC LIMIT ?", machine.empty() ? "? = ''" : "machine = ?"));
    Query query(session, sql, machine, from->after, from->rows);
    return collect(query, page, read_answer, [](const Answer& answer) { return fmt::format("{}", answer.id); });
  });
}

}  // namespace dripfeed::sql

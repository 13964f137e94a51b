// What was made is the sum of the reports; what was fed is counted from the jobs.
#include "store/sql/order_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "store/sql/audit_table.h"
#include "store/sql/event_table.h"
#include "store/sql/job_rows.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::Error;
using store::ErrorCode;
using store::Id;
using store::Order;
using store::OrderPlan;
using store::OrderState;
using store::Page;
using store::Result;
using store::Stamp;

std::string subject_of(Id order) { return fmt::format("order/{}", order); }

std::string select_where(std::string_view rest) {
  return fmt::format(
      "SELECT o.id, o.number, o.operation, o.part, o.quantity, o.machine, o.due_at_ms, o.priority, o.metadata, o.state,"
      " o.reason, o.revision, o.created_by, o.created_at_ms, o.changed_at_ms,"
      " coalesce((SELECT CAST(sum(good) AS BIGINT) FROM parts_report r WHERE r.work_order = o.id), 0),"
      " coalesce((SELECT CAST(sum(scrap) AS BIGINT) FROM parts_report r WHERE r.work_order = o.id), 0),"
      " (SELECT count(*) FROM job j WHERE j.work_order = o.id AND j.state = 'done'),"
      " (SELECT count(DISTINCT coalesce(j.choice, j.id)) FROM job j WHERE j.work_order = o.id AND j.state = 'queued')"
      " FROM work_order o WHERE {}",
      rest);
}

Order read_order(Query& query) {
  Order order;
  order.id = query.number();
  order.of.number = query.text();
  order.of.operation = query.text();
  order.of.plan.part = query.text();
  order.of.plan.quantity = query.number();
  order.of.plan.machine = query.text();
  order.of.plan.due_at_ms = query.signed_number();
  order.of.plan.priority = static_cast<std::uint32_t>(query.number());
  order.of.plan.metadata = query.text();
  order.state = query.value<OrderState>();
  order.reason = query.text();
  order.revision = query.number();
  order.created_by = query.text();
  order.created_at_ms = query.signed_number();
  order.changed_at_ms = query.signed_number();
  order.good = query.number();
  order.scrap = query.number();
  order.transfers = query.number();
  order.waiting = query.number();
  return order;
}

void log_event(Session& session, const Order& order, std::string word, const Stamp& by) {
  add_event_row(session,
                {.topic = store::EventTopic::order,
                 .word = std::move(word),
                 .subject = order.id,
                 .machine = order.of.plan.machine,
                 .text = order.of.number},
                by);
}

std::string words_of(const OrderPlan& plan) {
  return fmt::format("{} of {}{}{}", plan.quantity, plan.part, plan.machine.empty() ? "" : " on ", plan.machine);
}

std::optional<store::Error> fault_of(const store::NewOrder& order) {
  if (order.number.empty()) return store::Error{ErrorCode::invalid_value, "an order needs a number"};
  if (order.plan.part.empty() || order.plan.quantity == 0)
    return store::Error{ErrorCode::invalid_value, "an order needs a part and a quantity"};
  return std::nullopt;
}

bool has_line(Session& session, Id order) {
  Query query(session,
              "SELECT 1 FROM job WHERE work_order = ? AND state IN ('armed', 'feeding', 'held', 'draining') LIMIT 1",
              order);
  return query.next();
}

// The database refuses it, too, in its own words.
Result<void> refuse_no_machine(Session& session, const std::string& machine) {
  if (machine.empty()) return {};
  Query query(session, "SELECT 1 FROM machine WHERE name = ?", machine);
  if (query.next()) return {};
  return session.refuse(ErrorCode::broken_reference, fmt::format("there is no machine {}", machine));
}

bool is_closed(OrderState state) { return state == OrderState::done || state == OrderState::cancelled; }

}  // namespace

Result<Order> OrderTable::add(const store::NewOrder& order, const Stamp& by) {
  return database_.write(fmt::format("order {}", order.number), [&](Session& session) -> Result<Order> {
    if (const auto fault = fault_of(order)) return std::unexpected(*fault);
    {
      static const std::string kSql = select_where("o.number = ? AND o.operation = ?");
      Query known(session, kSql, order.number, order.operation);
      if (known.next()) {
        Order found = read_order(known);
        if (found.of.plan == order.plan) return found;
        return session.refuse(ErrorCode::exists, fmt::format("order {} with another plan", found.id));
      }
    }
    const OrderPlan& plan = order.plan;
    if (auto known = refuse_no_machine(session, plan.machine); !known) return std::unexpected(known.error());
    session.run(
        "INSERT INTO work_order (number, operation, part, quantity, machine, due_at_ms, priority, metadata, state,"
        " reason, revision, created_by, created_at_ms, changed_at_ms)"
        " VALUES (?, ?, ?, ?, ?, ?, ?, ?, 'open', '', 1, ?, ?, ?)",
        order.number, order.operation, plan.part, plan.quantity, OrNull{plan.machine}, plan.due_at_ms,
        std::uint64_t{plan.priority}, plan.metadata, by.actor, by.at_ms, by.at_ms);
    const Id id = session.last_id();
    add_audit_row(session, {.action = "order.add", .subject = subject_of(id), .detail = words_of(plan)}, by);
    if (!session.ok()) return std::unexpected(session.error());
    auto added = get(id);
    if (added) log_event(session, *added, "added", by);
    return added;
  });
}

Result<Order> OrderTable::change(Id order, store::Revision expected, const OrderPlan& plan, const Stamp& by) {
  return database_.write(subject_of(order), [&](Session& session) -> Result<Order> {
    const auto old = get(order);
    if (!old) return old;
    if (old->revision != expected) return session.refuse(ErrorCode::stale_revision);
    if (is_closed(old->state))
      return session.refuse(ErrorCode::refused_transition, fmt::format("it is {}", store::name_of(old->state)));
    if (const auto fault = fault_of({old->of.number, old->of.operation, plan})) return std::unexpected(*fault);
    if (auto known = refuse_no_machine(session, plan.machine); !known) return std::unexpected(known.error());
    session.run(
        "UPDATE work_order SET part = ?, quantity = ?, machine = ?, due_at_ms = ?, priority = ?, metadata = ?,"
        " revision = revision + 1, changed_at_ms = ? WHERE id = ?",
        plan.part, plan.quantity, OrNull{plan.machine}, plan.due_at_ms, std::uint64_t{plan.priority}, plan.metadata,
        by.at_ms, order);
    add_audit_row(session, {.action = "order.change", .subject = subject_of(order), .detail = words_of(plan)}, by);
    if (!session.ok()) return std::unexpected(session.error());
    auto changed = get(order);
    if (changed) log_event(session, *changed, "changed", by);
    return changed;
  });
}

Result<Order> OrderTable::move(Id order, OrderState to, std::string_view reason, const Stamp& by) {
  return database_.write(subject_of(order), [&](Session& session) -> Result<Order> {
    const auto old = get(order);
    if (!old) return old;
    const bool allowed = std::ranges::any_of(store::order_transitions(), [&](const store::OrderTransition& one) {
      return one.from == old->state && one.to == to;
    });
    if (!allowed) {
      return session.refuse(ErrorCode::refused_transition,
                            fmt::format("{} to {}", store::name_of(old->state), store::name_of(to)));
    }
    if (is_closed(to) && has_line(session, order))
      return session.refuse(ErrorCode::machine_busy, "a job of the order has a line");
    if (to == OrderState::held) {
      if (auto free = refuse_armed(session, "work_order", order); !free) return std::unexpected(free.error());
    }
    session.run("UPDATE work_order SET state = ?, reason = ?, changed_at_ms = ? WHERE id = ?", to, reason, by.at_ms,
                order);
    add_audit_row(session,
                  {.action = "order.move",
                   .subject = subject_of(order),
                   .detail = fmt::format("{} to {}: {}", store::name_of(old->state), store::name_of(to), reason)},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    auto moved = get(order);
    if (moved) log_event(session, *moved, std::string(store::name_of(to)), by);
    return moved;
  });
}

Result<Order> OrderTable::report(Id order, const store::PartsReport& parts, const Stamp& by) {
  return database_.write(subject_of(order), [&](Session& session) -> Result<Order> {
    const auto old = get(order);
    if (!old) return old;
    if (parts.good == 0 && parts.scrap == 0) return session.refuse(ErrorCode::invalid_value, "no part is reported");
    if (old->state == OrderState::cancelled) return session.refuse(ErrorCode::refused_transition, "it is cancelled");
    session.run(
        "INSERT INTO parts_report (work_order, n, good, scrap, note, actor, at_ms) VALUES (?, 1 + (SELECT count(*) FROM"
        " parts_report WHERE work_order = ?), ?, ?, ?, ?, ?)",
        order, order, parts.good, parts.scrap, parts.note, by.actor, by.at_ms);
    add_audit_row(session,
                  {.action = "order.parts",
                   .subject = subject_of(order),
                   .detail = fmt::format("{} good, {} scrap: {}", parts.good, parts.scrap, parts.note)},
                  by);
    if (!session.ok()) return std::unexpected(session.error());
    auto reported = get(order);
    if (reported) log_event(session, *reported, "parts", by);
    return reported;
  });
}

Result<Order> OrderTable::get(Id order) {
  return database_.read(subject_of(order), [&](Session& session) -> Result<Order> {
    static const std::string kSql = select_where("o.id = ?");
    Query query(session, kSql, order);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_order(query);
  });
}

Result<Page<Order>> OrderTable::list(const store::PageRequest& page, const store::OrderFilter& filter) {
  return database_.read("orders", [&](Session& session) -> Result<Page<Order>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    const auto equals = [](std::string_view column, bool is_given) {
      return is_given ? fmt::format("o.{} = ?", column) : std::string("? = ''");
    };
    const std::string sql = select_where(
        fmt::format("{} AND {} AND {} AND {} AND o.id < ? ORDER BY o.id DESC LIMIT ?",
                    equals("number", !filter.number.empty()), equals("part", !filter.part.empty()),
                    equals("machine", !filter.machine.empty()), equals("state", filter.state.has_value())));
    const std::string_view state = filter.state ? store::name_of(*filter.state) : std::string_view();
    Query query(session, sql, filter.number, filter.part, filter.machine, state, from->after, from->rows);
    return collect(query, page, read_order, [](const Order& order) { return fmt::format("{}", order.id); });
  });
}

Result<void> refuse_unfit(Session& session, const store::Job& job) {
  if (job.order == 0) return {};
  const auto refuse = [&](std::string why) {
    return std::unexpected(Error{ErrorCode::refused_transition, std::move(why)});
  };
  Query query(
      session,
      "SELECT o.state, o.machine, o.part, coalesce(r.part, '') FROM work_order o LEFT JOIN program_revision r ON "
      "r.program = ? AND r.revision = ? WHERE o.id = ?",
      job.program, job.revision, job.order);
  if (!query.next()) return session.refuse(ErrorCode::broken_reference, fmt::format("there is no order {}", job.order));
  const auto state = query.value<OrderState>();
  const std::string machine = query.text();
  const std::string part = query.text();
  const std::string of_program = query.text();
  if (state != OrderState::open) return refuse(fmt::format("order {} is {}", job.order, store::name_of(state)));
  if (!machine.empty() && machine != job.machine) return refuse(fmt::format("order {} is for {}", job.order, machine));
  if (!of_program.empty() && part != of_program)
    return refuse(
        fmt::format("the program is rendered from part {}, and order {} is of part {}", of_program, job.order, part));
  return {};
}

std::uint64_t priority_of(Session& session, Id order) {
  if (order == 0) return 0;
  Query query(session, "SELECT priority FROM work_order WHERE id = ?", order);
  return query.next() ? query.number() : 0;
}

}  // namespace dripfeed::sql

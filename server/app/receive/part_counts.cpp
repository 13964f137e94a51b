// Parts that a control, or its PLC, counted. They belong to the order of the program that went to the machine last:
// what the control runs otherwise is not known here, and a count without such an order is refused and not guessed at.
#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "server/app/receive/receiving.h"

namespace dripfeed::app {

namespace {

constexpr std::uint64_t kMostAtOnce = 100'000;
constexpr std::uint32_t kJobsLookedAt = 100;

// 0: it is none, or no number of parts that anyone makes between two messages.
std::uint64_t count_in(std::string_view argument) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(argument.data(), argument.data() + argument.size(), count);
  const bool is_whole = error == std::errc() && end == argument.data() + argument.size();
  return is_whole && count <= kMostAtOnce ? count : 0;
}

}  // namespace

Receiving::Outcome Receiving::count_parts(const std::string& machine, const receive::Request& request) {
  const std::string what = fmt::format("{} {}", request.argument, receive::name(request.verb));
  const auto refused = [&](std::string why, modbus::BellReason reason) {
    why = fmt::format("{}: not counted: {}", what, why);
    alarm(machine, AlarmKind::request_failed, why);
    return Outcome{.outcome = "refused", .detail = std::move(why), .job = 0, .answer = {}, .reason = reason};
  };
  const std::uint64_t count = count_in(request.argument);
  if (count == 0) return refused(fmt::format("use 1 to {} parts", kMostAtOnce), modbus::BellReason::not_allowed);
  const auto jobs = store_.jobs().list({.limit = kJobsLookedAt, .after = {}}, {.machine = machine, .state = {}});
  if (!jobs) return refused(store::message_of(jobs.error()), modbus::BellReason::busy);
  const auto last = std::ranges::max_element(jobs->items, {}, &store::Job::started_at_ms);
  if (last == jobs->items.end() || last->started_at_ms == 0)
    return refused("nothing went to the machine yet", modbus::BellReason::no_order);
  if (last->order == 0)
    return refused(fmt::format("job {}, which went to the machine last, is of no order", last->id),
                   modbus::BellReason::no_order);
  const bool is_good = request.verb == receive::Verb::parts;
  const auto order = store_.orders().report(
      last->order, {.good = is_good ? count : 0, .scrap = is_good ? 0 : count, .note = "counted at the control"},
      stamp(operator_at(machine)));
  if (!order) return refused(store::message_of(order.error()), modbus::BellReason::no_order);
  return {.outcome = "answered",
          .detail = fmt::format("order {}: {} good of {}, {} scrap", order->of.number, order->good,
                                order->of.plan.quantity, order->scrap),
          .job = last->id,
          .answer = {}};
}

}  // namespace dripfeed::app

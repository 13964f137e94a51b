// A value that did not change is no observation.
#include "server/app/out/observations.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

constexpr std::chrono::milliseconds kLookEvery{500};

using enum DataItem;
constexpr std::array<DataItemRow, kDataItems> kItems = {{
    {availability, "_avail", "AVAILABILITY", "Availability", "", ""},
    {line_state, "_dnc", "MESSAGE", "Message", "", "controller"},
    {execution, "_exec", "EXECUTION", "Execution", "", "path"},
    {mode, "_mode", "CONTROLLER_MODE", "ControllerMode", "", "path"},
    {program, "_prog", "PROGRAM", "Program", "", "path"},
    {line, "_line", "LINE_NUMBER", "LineNumber", "ABSOLUTE", "path"},
    {system, "_sys", "SYSTEM", "", "", "controller", ItemCategory::condition},
    {communications, "_comm", "COMMUNICATIONS", "", "", "controller", ItemCategory::condition},
}};

constexpr bool items_in_order() {
  for (std::size_t i = 0; i < kItems.size(); ++i)
    if (static_cast<std::size_t>(kItems[i].item) != i) return false;
  return true;
}
static_assert(items_in_order());

// What a machine's own state says of its control in the words of MTConnect. "held" may be a feed hold or a program
// stop: in either case it is interrupted.
struct StateRow {
  std::string_view state;
  std::string_view execution;
  std::string_view mode;
};
constexpr StateRow kStates[] = {
    {"idle", "READY", kUnavailable},
    {"running", "ACTIVE", "AUTOMATIC"},
    {"held", "INTERRUPTED", "AUTOMATIC"},
    {"manual", kUnavailable, "MANUAL"},
};

void observe_machine(const MachineReport& machine, ObservedItems& items) {
  const auto at = [&](DataItem item) -> Observed& { return items[static_cast<std::size_t>(item)]; };
  const auto* const row = std::ranges::find(kStates, machine.state, &StateRow::state);
  if (row != std::end(kStates)) {
    at(execution).value = row->execution;
    at(mode).value = row->mode;
  }
  if (machine.program != 0) at(program).value = fmt::format("{}", machine.program);
  if (machine.line != 0) at(line).value = fmt::format("{}", machine.line);
  if (machine.state == "unknown") return;
  const bool has_alarm = machine.alarm != 0 || machine.state == "alarm" || machine.state == "emergency_stop";
  at(system).value = has_alarm ? "Fault" : "Normal";
  if (!has_alarm) return;
  at(system).text = alarm_text(machine);
  if (at(system).text.empty()) at(system).text = std::string(machine.state);
  if (machine.alarm != 0) at(system).code = fmt::format("{}", machine.alarm);
}

}  // namespace

std::span<const DataItemRow, kDataItems> data_items() { return kItems; }

// An id of XML: letters, digits and _ stay, all else is a number.
std::string device_id(std::string_view machine) {
  std::string id = "m_";
  for (const char c : machine) {
    const bool stays = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (stays) {
      id += c;
    } else {
      id += fmt::format("_{:02X}", static_cast<unsigned char>(c));
    }
  }
  return id;
}

std::string data_item_id(std::string_view machine, DataItem item) {
  return device_id(machine) + std::string(kItems[static_cast<std::size_t>(item)].id);
}

ObservedItems observed_of(const LineReport& report) {
  ObservedItems items;
  const auto at = [&](DataItem item) -> Observed& { return items[static_cast<std::size_t>(item)]; };
  const bool is_up = report.state != LineState::disconnected;
  at(availability).value = is_up ? "AVAILABLE" : kUnavailable;
  at(line_state).value = report.stall.empty() ? std::string(name_of(report.state))
                                              : fmt::format("{}, {}", name_of(report.state), report.stall);
  at(communications).value = !report.link_error.empty()        ? "Fault"
                             : report.state == LineState::torn ? "Warning"
                             : !report.link_note.empty()       ? "Warning"
                             : is_up                           ? "Normal"
                                                               : kUnavailable;
  at(communications).text = !report.link_error.empty()        ? report.link_error
                            : report.state == LineState::torn ? "a block broke off: confirm that the control was reset"
                                                              : report.link_note;
  if (report.machine) observe_machine(*report.machine, items);
  return items;
}

Observations::Observations(const Clock& clock, Look look)
    : clock_(clock),
      look_(std::move(look)),
      instance_(clock.wall_ms() / 1000),
      thread_("mtconnect", kLookEvery, Urgency::usual, [this] { round(); }) {
  static_cast<void>(thread_.wait_for_round(std::chrono::seconds(2)));  // the first answer has values already
}

void Observations::round() {
  const auto reports = look_();
  const std::int64_t now_ms = clock_.wall_ms();
  const std::lock_guard lock(mutex_);
  for (const auto& [machine, report] : reports) {
    const bool is_new = !newest_.contains(machine);
    auto& newest = newest_[machine];
    ObservedItems items = observed_of(report);
    for (std::size_t i = 0; i < kDataItems; ++i) {
      if (!is_new && newest[i].observed == items[i]) continue;
      newest[i] = {.sequence = ++last_,
                   .at_ms = now_ms,
                   .machine = machine,
                   .item = static_cast<DataItem>(i),
                   .observed = std::move(items[i])};
      kept_.push_back(newest[i]);
    }
  }
  while (kept_.size() > kKept) kept_.pop_front();
}

std::vector<std::string> Observations::machines() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> names;
  names.reserve(newest_.size());
  for (const auto& [machine, items] : newest_) names.push_back(machine);
  return names;
}

// With the lock.
ObservationBatch Observations::empty_batch() const {
  return {.first = kept_.empty() ? last_ + 1 : kept_.front().sequence,
          .last = last_,
          .next = last_ + 1,
          .observations = {}};
}

ObservationBatch Observations::current(std::string_view machine) const {
  const std::lock_guard lock(mutex_);
  ObservationBatch batch = empty_batch();
  for (const auto& [name, items] : newest_)
    if (machine.empty() || machine == name)
      batch.observations.insert(batch.observations.end(), items.begin(), items.end());
  return batch;
}

std::optional<ObservationBatch> Observations::sample(std::string_view machine, std::optional<std::uint64_t> from,
                                                     std::size_t count) const {
  const std::lock_guard lock(mutex_);
  ObservationBatch batch = empty_batch();
  const std::uint64_t begin = from.value_or(batch.first);
  if (begin < batch.first || begin > last_ + 1) return std::nullopt;
  for (const Observation& one : kept_) {
    if (one.sequence < begin || (!machine.empty() && machine != one.machine)) continue;
    if (batch.observations.size() == count) {
      batch.next = one.sequence;
      break;
    }
    batch.observations.push_back(one);
  }
  return batch;
}

}  // namespace dripfeed::app

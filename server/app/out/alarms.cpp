// No lock is held over a call of the store: a person's acknowledgement may run inside a transaction of its own.
#include "server/app/out/alarms.h"

#include <algorithm>
#include <array>
#include <chrono>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/app/lines/line_history.h"

namespace dripfeed::app {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kRound{250};
constexpr feed::Time kWriteEvery = 1s;  // for one machine and kind
constexpr feed::Time kLookEvery = 1s;   // at torn blocks that wait, at shelves
constexpr feed::Time kForgetEvery = 10min;
constexpr std::int64_t kKept_ms = 90LL * 24 * 3600 * 1000;
constexpr std::uint64_t kKeptAtMost = 10'000;
constexpr std::uint32_t kForgottenAtOnce = 500;
constexpr std::size_t kTextsAtOnce = 16;  // of one machine and kind, between two writes
constexpr std::string_view kMore = "more alarms of this kind came within a second than are listed one by one";

constexpr std::array<AlarmKindRow, kAlarmKinds> kKinds = {{
    {AlarmKind::torn_block, "torn_block", Severity::critical, true},
    {AlarmKind::reset_suspected, "reset_suspected", Severity::critical, true},
    {AlarmKind::line_refused, "line_refused", Severity::critical, true},
    {AlarmKind::ledger_failed, "ledger_failed", Severity::critical, true},
    {AlarmKind::link_lost, "link_lost", Severity::warning, true},
    {AlarmKind::line_flooded, "line_flooded", Severity::warning, true},
    {AlarmKind::link_note, "link_note", Severity::warning, true},
    {AlarmKind::machine_alarm, "machine_alarm", Severity::warning, true},
    {AlarmKind::person_called, "person_called", Severity::warning, false},
    {AlarmKind::reception_lost, "reception_lost", Severity::critical, false},
    {AlarmKind::quarantined, "quarantined", Severity::warning, false},
    {AlarmKind::device_text, "device_text", Severity::notice, false},
    {AlarmKind::request_failed, "request_failed", Severity::warning, false},
    {AlarmKind::request_expired, "request_expired", Severity::notice, false},
    {AlarmKind::read_back_differs, "read_back_differs", Severity::warning, false},
    {AlarmKind::read_back_expired, "read_back_expired", Severity::notice, false},
}};

constexpr bool kinds_in_order() {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (static_cast<std::size_t>(kKinds[i].kind) != i) return false;
  }
  return true;
}
static_assert(kinds_in_order());

const AlarmKindRow* row_named(std::string_view name) {
  const auto* const row = std::ranges::find(kKinds, name, &AlarmKindRow::name);
  return row == kKinds.end() ? nullptr : row;
}

// What no later try makes better.
bool is_final(store::ErrorCode code) {
  return code == store::ErrorCode::broken_reference || code == store::ErrorCode::invalid_value;
}

}  // namespace

std::string_view name_of(Severity severity) {
  static constexpr std::array<std::string_view, 3> kNames = {"critical", "warning", "notice"};
  return kNames[static_cast<std::size_t>(severity)];
}

const AlarmKindRow& row_of(AlarmKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

Severity severity_of(std::string_view kind) {
  const AlarmKindRow* const row = row_named(kind);
  return row == nullptr ? Severity::warning : row->severity;
}

Alarms::Alarms(store::Store& store, Events& events, const Clock& clock)
    : store_(store), events_(events), clock_(clock), thread_("alarms", kRound, Urgency::usual, [this] { round(); }) {}

// --- what others leave
// ------------------------------------------------------------------------------------------------------------------

void Alarms::raise(const std::string& machine, AlarmKind kind, std::string text, store::Id job) {
  const std::int64_t at_ms = clock_.wall_ms();
  {
    const std::lock_guard lock(mutex_);
    Pending& pending = pending_[{machine, kind}];
    auto known = std::ranges::find(pending.raised, text, &Raised::text);
    if (known == pending.raised.end() && pending.raised.size() >= kTextsAtOnce) {
      text = kMore;
      known = std::ranges::find(pending.raised, text, &Raised::text);
    }
    if (known == pending.raised.end()) {
      spdlog::warn("{}: {}", machine, text);  // once between two writes, however often it comes
      known = pending.raised.insert(known, Raised{.text = text, .job = job});
    }
    ++known->count;
    known->at_ms = at_ms;
    pending.is_over = false;
    pending.last = std::move(text);
  }
  thread_.wake();
}

void Alarms::clear(const std::string& machine, AlarmKind kind) {
  const std::int64_t at_ms = clock_.wall_ms();
  {
    const std::lock_guard lock(mutex_);
    Pending& pending = pending_[{machine, kind}];
    pending.is_over = true;
    pending.over_at_ms = at_ms;
  }
  thread_.wake();
}

void Alarms::line_is_torn(const std::string& machine, bool torn, std::string why) {
  {
    const std::lock_guard lock(mutex_);
    torn_news_[machine] = {.on_line = torn, .why = std::move(why)};
  }
  thread_.wake();
}

Result<void> Alarms::start() {
  store::PageRequest page{.limit = store::kPageLimitMax, .after = {}};
  do {
    const auto rows = lift(store_.machines().list(page));
    if (!rows) return std::unexpected(rows.error());
    {
      const std::lock_guard lock(mutex_);
      for (const store::Machine& machine : rows->items) torn_news_.try_emplace(machine.name);  // a line's word stays
    }
    page.after = rows->next;
  } while (!page.after.empty());
  thread_.wake();
  return {};
}

// --- the thread
// ------------------------------------------------------------------------------------------------------------------

void Alarms::round() {
  if (!is_loaded_ && !load()) return;
  look_at_torn();
  std::map<Key, Pending> due;
  {
    const std::lock_guard lock(mutex_);
    for (auto it = pending_.begin(); it != pending_.end();) {
      if (is_due(it->first)) {
        due.insert(pending_.extract(it++));
      } else {
        ++it;
      }
    }
  }
  std::erase_if(next_write_, [now = clock_.now()](const auto& row) { return row.second <= now; });
  for (auto& [key, pending] : due) {
    if (!write(key, pending)) keep(key, std::move(pending));
  }
  end_shelves();
  forget();
}

// What a server before this one left on.
bool Alarms::load() {
  const auto rows = store_.alarms().lasting();
  if (!rows) {
    if (!std::exchange(is_failing_, true)) spdlog::error("alarms: {}", store::message_of(rows.error()));
    return false;
  }
  is_failing_ = false;
  for (const store::Alarm& alarm : *rows) {
    if (const AlarmKindRow* const row = row_named(alarm.kind)) lasting_[{alarm.machine, row->kind}] = alarm.text;
  }
  is_loaded_ = true;
  return true;
}

bool Alarms::is_due(const Key& key) const {
  const auto next = next_write_.find(key);
  return next == next_write_.end() || clock_.now() >= next->second;
}

// The text that stands is raised last, after all others of its kind are over.
bool Alarms::write(const Key& key, Pending& pending) {
  const bool lasts = row_of(key.second).lasts;
  const bool stays = lasts && !pending.is_over;
  const auto on = lasting_.find(key);
  const bool is_replaced = stays && on != lasting_.end() && !pending.last.empty() && on->second != pending.last;
  if (pending.raised.empty() && (!lasts || on == lasting_.end())) return true;
  next_write_[key] = clock_.now() + kWriteEvery;
  const auto standing = stays ? std::ranges::find(pending.raised, pending.last, &Raised::text) : pending.raised.end();
  bool any_other = is_replaced;
  for (auto it = pending.raised.begin(); it != pending.raised.end(); ++it) {
    if (it == standing) continue;
    if (!write_raised(key, *it)) return false;
    any_other = true;
  }
  const std::int64_t over_at_ms = stays && standing != pending.raised.end() ? standing->at_ms : pending.over_at_ms;
  if (lasts && (pending.is_over || any_other) && !write_cleared(key, over_at_ms)) return false;
  return standing == pending.raised.end() || write_raised(key, *standing);
}

bool Alarms::write_raised(const Key& key, Raised& raised) {
  if (raised.count == 0) return true;  // by a try before this one
  const AlarmKindRow& row = row_of(key.second);
  const auto alarm = store_.alarms().raise({.machine = key.first,
                                            .kind = std::string(row.name),
                                            .text = raised.text,
                                            .lasts = row.lasts,
                                            .job = raised.job,
                                            .count = raised.count},
                                           raised.at_ms);
  if (!alarm) {
    publish_unwritten(key, raised);
    if (!std::exchange(is_failing_, true))
      spdlog::error("{}: an alarm cannot be written: {}", key.first, store::message_of(alarm.error()));
    return is_final(alarm.error().code);
  }
  is_failing_ = false;
  raised.count = 0;
  if (row.lasts) lasting_[key] = raised.text;
  publish(*alarm);
  return true;
}

bool Alarms::write_cleared(const Key& key, std::int64_t at_ms) {
  if (!lasting_.contains(key)) return true;
  const auto over = store_.alarms().clear(key.first, row_of(key.second).name, at_ms);
  if (!over) {
    if (!std::exchange(is_failing_, true))
      spdlog::error("{}: an alarm's end cannot be written: {}", key.first, store::message_of(over.error()));
    return false;
  }
  is_failing_ = false;
  lasting_.erase(key);
  for (const store::Alarm& alarm : *over) publish(alarm);
  return true;
}

// Back for the next try, before what came meanwhile.
void Alarms::keep(const Key& key, Pending pending) {
  const std::lock_guard lock(mutex_);
  Pending& now = pending_[key];
  std::erase_if(pending.raised, [](const Raised& raised) { return raised.count == 0; });
  const bool is_silent = now.raised.empty() && !now.is_over;  // nothing came meanwhile
  for (const Raised& news : now.raised) {
    const auto known = std::ranges::find(pending.raised, news.text, &Raised::text);
    if (known == pending.raised.end()) {
      if (pending.raised.size() <= kTextsAtOnce) pending.raised.push_back(news);
      continue;
    }
    known->count += news.count;
    known->at_ms = news.at_ms;
  }
  if (!is_silent) {
    pending.is_over = now.is_over;
    pending.over_at_ms = now.over_at_ms;
    if (!now.last.empty()) pending.last = now.last;
  }
  now = std::move(pending);
}

// The store does not take it, and that may be what the alarm is about: those who watch hear it all the same, once.
void Alarms::publish_unwritten(const Key& key, Raised& raised) {
  if (std::exchange(raised.is_published, true)) return;
  store::Alarm alarm;
  alarm.machine = key.first;
  alarm.kind = row_of(key.second).name;
  alarm.text = raised.text;
  alarm.count = raised.count;
  alarm.raised_at_ms = alarm.last_at_ms = raised.at_ms;
  alarm.cleared_at_ms = row_of(key.second).lasts ? 0 : raised.at_ms;
  alarm.job = raised.job;
  publish(alarm);
}

// A line's word comes when it changes; what the store says is looked at again while an alarm waits for its end.
void Alarms::look_at_torn() {
  std::map<std::string, Torn> news;
  {
    const std::lock_guard lock(mutex_);
    news.swap(torn_news_);
  }
  std::map<std::string, Torn> looked = news;
  for (auto& [machine, torn] : news) torn_[machine] = std::move(torn);
  if (clock_.now() >= next_look_) {
    for (const auto& [key, text] : lasting_) {
      if (key.second == AlarmKind::torn_block) looked.try_emplace(key.first);
    }
  }
  for (const auto& [machine, unused] : looked) {
    const Torn& line = torn_[machine];
    const auto known = torn_in_store(store_, machine);
    if (!known) {
      const std::lock_guard lock(mutex_);
      torn_news_.try_emplace(machine, line);
      continue;
    }
    const bool is_on = lasting_.contains({machine, AlarmKind::torn_block});
    const bool is_torn = *known || line.on_line;
    if (is_on && !is_torn) clear(machine, AlarmKind::torn_block);
    if (!is_on && is_torn) {
      std::string text = *known ? (*known)->text : line.why;
      if (text.empty()) text = "a block broke off on this line";
      if (text.find("reset the control") == std::string::npos) text += ": reset the control and confirm it";
      raise(machine, AlarmKind::torn_block, std::move(text), *known ? (*known)->job : 0);
    }
  }
}

void Alarms::end_shelves() {
  if (clock_.now() < next_look_) return;
  next_look_ = clock_.now() + kLookEvery;
  const auto ended = store_.alarms().end_shelves(clock_.wall_ms());
  if (!ended) return;  // tried again
  for (const store::Alarm& alarm : *ended) publish(alarm);
}

// In short transactions, one a round.
void Alarms::forget() {
  if (clock_.now() < next_forget_) return;
  const auto gone = store_.alarms().forget(clock_.wall_ms() - kKept_ms, kKeptAtMost, kForgottenAtOnce);
  if (!gone || *gone < kForgottenAtOnce) next_forget_ = clock_.now() + kForgetEvery;
}

// --- what people decide
// ------------------------------------------------------------------------------------------------------------------

Result<store::Alarm> Alarms::acknowledge(store::Id id, std::string_view actor) {
  const auto before = lift(store_.alarms().get(id));
  if (!before || before->acknowledged_at_ms != 0) return before;
  auto alarm = lift(store_.alarms().acknowledge(id, {std::string(actor), clock_.wall_ms()}));
  if (alarm) publish(*alarm);
  return alarm;
}

Result<store::Alarm> Alarms::shelve(store::Id id, std::uint32_t minutes, std::string_view reason,
                                    std::string_view actor) {
  const auto before = lift(store_.alarms().get(id));
  if (!before) return before;
  if (severity_of(before->kind) == Severity::critical) {
    return fail(ErrorCode::refused, fmt::format("alarm {} ({}) is critical: it may not be shelved; acknowledge it "
                                                "and end its cause",
                                                id, before->kind));
  }
  const std::int64_t now_ms = clock_.wall_ms();
  auto alarm =
      lift(store_.alarms().shelve(id, now_ms + std::int64_t{minutes} * 60'000, reason, {std::string(actor), now_ms}));
  if (alarm) publish(*alarm);
  return alarm;
}

Result<store::Alarm> Alarms::unshelve(store::Id id, std::string_view actor) {
  const auto before = lift(store_.alarms().get(id));
  if (!before || before->shelved_until_ms == 0) return before;
  auto alarm = lift(store_.alarms().unshelve(id, {std::string(actor), clock_.wall_ms()}));
  if (alarm) publish(*alarm);
  return alarm;
}

void Alarms::publish(const store::Alarm& alarm) {
  events_.publish({.id = 0,
                   .kind = EventKind::alarm,
                   .machine = alarm.machine,
                   .job = {},
                   .verdict = 0,
                   .outcome = {},
                   .text = alarm.text,
                   .alarm = alarm});
}

}  // namespace dripfeed::app

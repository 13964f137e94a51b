// The lease in the store decides, and the store refuses to move a job of another node's machine. What is done here lets
// the lines follow.
#include "server/app/shop/node_lines.h"

#include <chrono>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace dripfeed::app {

namespace {

constexpr std::chrono::milliseconds kBeat{1000};
constexpr std::chrono::milliseconds kBetween{10};
constexpr std::string_view kActor = "dripfeed";

std::string elsewhere(std::string_view node) { return fmt::format("the line is with node {}", node); }

bool has_running_job(const LineReport& report) { return report.job != 0 && report.end == JobEnd::none; }

}  // namespace

NodeLines::NodeLines(store::Store& store, store::Nodes& nodes, Lines& lines, Catalog& catalog, Events& events,
                     const Clock& clock, std::string version)
    : store_(store),
      nodes_(nodes),
      lines_(lines),
      catalog_(catalog),
      events_(events),
      clock_(clock),
      version_(std::move(version)) {}

store::Stamp NodeLines::stamp(std::string_view actor) const { return {std::string(actor), clock_.wall_ms()}; }

Result<void> NodeLines::start() {
  if (auto claimed = nodes_.claim_free(stamp(kActor)); !claimed) return std::unexpected(from_store(claimed.error()));
  const auto newest = lift(store_.event_log().newest());
  if (!newest) return std::unexpected(newest.error());
  seen_ = *newest;
  return read_leases();
}

Result<void> NodeLines::read_leases() {
  auto leases = lift(nodes_.leases());
  if (!leases) return std::unexpected(leases.error());
  const std::lock_guard lock(mutex_);
  leases_.clear();
  for (store::Lease& lease : *leases) leases_.emplace(lease.machine, std::move(lease));
  return {};
}

bool NodeLines::is_ours(std::string_view machine) const {
  const std::lock_guard lock(mutex_);
  const auto lease = leases_.find(machine);
  return lease == leases_.end() || lease->second.node == nodes_.own();
}

void NodeLines::announce(std::string url) {
  const std::lock_guard lock(mutex_);
  url_ = std::move(url);
}

// A round ends when there is news, or after a while, so the next one begins soon.
void NodeLines::follow() {
  thread_.emplace("nodes", kBetween, Urgency::usual, [this] {
    if (ends_.load()) return;
    round();
    nodes_.wait_for_news(kBeat);
  });
}

void NodeLines::stop() {
  ends_.store(true);
  if (thread_) thread_->stop();
}

// News come with every change of any server; the beat is a change of its own and is not made for each.
void NodeLines::round() {
  if (clock_.now() >= beat_at_) {
    beat_at_ = clock_.now() + kBeat;
    beat();
    follow_leases();
  }
  follow_news();
}

void NodeLines::follow_leases() {
  auto read = read_leases();
  const std::string complaint = read ? std::string() : read.error().text;
  if (complaint != complaint_ && !complaint.empty()) spdlog::warn("nodes: {}", complaint);
  complaint_ = complaint;
  if (!read) return;
  std::vector<store::Lease> leases;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [machine, lease] : leases_) leases.push_back(lease);
  }
  for (const store::Lease& lease : leases) look_at(lease);
}

// A node that cannot say that it is there leads no longer.
void NodeLines::beat() {
  std::string url;
  {
    const std::lock_guard lock(mutex_);
    url = url_;
  }
  const auto beat = nodes_.beat(url, version_);
  leads_.store(beat && beat->leads);
}

void NodeLines::look_at(const store::Lease& lease) {
  if (lease.node != nodes_.own()) return leave(lease);
  if (lines_.find(lease.machine)) return;
  {
    // A line that could not be opened has its reason and is not tried each second; one that was never here has none.
    const std::lock_guard lock(mutex_);
    if (left_.erase(lease.machine) == 0 && !lines_.why_none(lease.machine).empty()) return;
  }
  if (const auto opened = catalog_.open_line(lease.machine); !opened)
    return spdlog::error("{} has no line: {}", lease.machine, opened.error().text);
  spdlog::info("{}: its line is this node's now: {}", lease.machine, lease.reason);
}

Result<void> NodeLines::leave_line(const std::string& machine, std::string_view node) {
  if (auto left = lines_.leave(machine, elsewhere(node)); !left) return left;
  const std::lock_guard lock(mutex_);
  left_.insert(machine);
  return {};
}

// A line that a person took over elsewhere. Its job may end at a block until the next round; then nothing more leaves
// here, as a job that the control holds inside a block would end with what is left of it. The line is torn elsewhere.
void NodeLines::leave(const store::Lease& lease) {
  const std::string why = elsewhere(lease.node);
  if (const auto line = lines_.find(lease.machine); line && has_running_job(line->report())) {
    const bool is_first = ending_.insert(lease.machine).second;
    if (is_first) {
      spdlog::warn("{}: {}: its job ends here", lease.machine, why);
      static_cast<void>(line->command(feed::Command::cancel));  // one that ends already refuses it
      return;
    }
  }
  ending_.erase(lease.machine);
  if (!lines_.find(lease.machine) && lines_.why_none(lease.machine) == why) return;
  const auto hold = lines_.hold(lease.machine);
  if (const auto left = leave_line(lease.machine, lease.node); !left)
    spdlog::warn("{}: {}: {}", lease.machine, why, left.error().text);
}

void NodeLines::follow_news() {
  const auto news = nodes_.news(seen_);
  if (!news) return;
  for (const store::NodeNews& one : *news) {
    publish(one);
    seen_ = one.seq;
  }
}

// For who watches this server.
void NodeLines::publish(const store::NodeNews& news) {
  Event event{
      .id = 0, .kind = EventKind::machine, .machine = news.machine, .job = {}, .verdict = 0, .outcome = {}, .text = {}};
  if (news.topic == store::EventTopic::job) {
    const auto job = store_.jobs().get(news.subject);
    if (!job) return;
    event.kind = EventKind::job;
    event.job = *job;
    event.text = job->reason;
  } else if (news.topic == store::EventTopic::alarm) {
    const auto alarm = store_.alarms().get(news.subject);
    if (!alarm) return;
    event.kind = EventKind::alarm;
    event.alarm = *alarm;
    event.text = alarm->text;
  } else if (news.topic == store::EventTopic::receipt) {
    event.kind = EventKind::receipt;
  } else if (news.topic != store::EventTopic::line) {
    return;
  }
  events_.publish(std::move(event));
}

Result<void> NodeLines::hand_over(const std::string& machine, std::string_view node, std::string_view reason,
                                  std::string_view actor) {
  const auto hold = lines_.hold(machine);  // no one arms meanwhile
  if (const auto line = lines_.find(machine); line && has_running_job(line->report()))
    return fail(ErrorCode::refused, fmt::format("job {} is on the line of {}", line->report().job, machine));
  const auto given = lift(nodes_.hand_over(machine, node, reason, stamp(actor)));
  if (!given) return std::unexpected(given.error());
  spdlog::info("{}: handed over to node {} by {}: {}", machine, node, actor, reason);
  if (auto left = leave_line(machine, node); !left) return left;
  return read_leases();
}

Result<void> NodeLines::take_over(const std::string& machine, std::string_view reason, std::string_view actor) {
  const auto jobs = lift(nodes_.take_over(machine, reason, stamp(actor)));
  if (!jobs) return std::unexpected(jobs.error());
  spdlog::warn("{}: taken over by {}: {}", machine, actor, reason);
  if (auto read = read_leases(); !read) return read;
  {
    const std::lock_guard lock(mutex_);
    left_.erase(machine);
  }
  for (const store::Job& job : *jobs) {
    events_.publish({.id = 0,
                     .kind = EventKind::job,
                     .machine = machine,
                     .job = job,
                     .verdict = 0,
                     .outcome = {},
                     .text = job.reason});
  }
  return catalog_.open_line(machine);
}

}  // namespace dripfeed::app

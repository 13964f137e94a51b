// Births and changes go out by QoS 0 and the node's death by QoS 1, as Sparkplug 3.0 has it. What a broken connection
// lost comes again with the births of the next one.
#include "server/app/sparkplug.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace dripfeed::app {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kSparkplugRound{100};
constexpr feed::Time kShowEvery = 1s;
constexpr feed::Time kBirthsEvery = 5s;  // however often a host asks

SparkplugValue text_or_none(std::string_view text) {
  return text.empty() ? SparkplugValue() : SparkplugValue(std::string(text));
}
SparkplugValue whole(std::uint64_t number) { return static_cast<std::int64_t>(number); }
SparkplugValue whole_or_none(std::uint64_t number) { return number == 0 ? SparkplugValue() : whole(number); }

// A PLC's words, where the link brings any.
SparkplugValue of_control(const MachineStatus& status, SparkplugValue (*read)(const MachineReport&)) {
  return status.report.machine ? read(*status.report.machine) : SparkplugValue();
}

SparkplugValue needs_confirmation(const MachineStatus& status) {
  if (status.needs_confirmation) return true;
  return status.is_certain ? SparkplugValue(false) : SparkplugValue();
}

std::string_view word_of(JobEnd end) {
  switch (end) {
    case JobEnd::done: return "done";
    case JobEnd::failed: return "failed";
    case JobEnd::cancelled: return "cancelled";
    case JobEnd::disarmed: return "disarmed";
    case JobEnd::none: break;
  }
  return {};
}

struct MetricRow {
  const char* name;
  SparkplugType type;
  SparkplugValue (*read)(const MachineStatus&);
};

constexpr auto kReal = SparkplugType::real;
constexpr auto kText = SparkplugType::text;
constexpr auto kWhole = SparkplugType::whole;

constexpr std::array kMetricRows{
    MetricRow{"Line/State", kText, [](const MachineStatus& s) { return text_or_none(name_of(s.report.state)); }},
    MetricRow{"Line/Waits For", kText, [](const MachineStatus& s) { return text_or_none(s.report.stall); }},
    MetricRow{"Line/Fault", kText, [](const MachineStatus& s) { return text_or_none(s.report.link_error); }},
    MetricRow{"Line/Needs Confirmation", SparkplugType::boolean, needs_confirmation},
    MetricRow{"Job/Id", kWhole, [](const MachineStatus& s) { return whole_or_none(s.report.job); }},
    MetricRow{"Job/Program", kText, [](const MachineStatus& s) { return text_or_none(s.program); }},
    MetricRow{"Job/End", kText, [](const MachineStatus& s) { return text_or_none(word_of(s.report.end)); }},
    MetricRow{"Job/Cause", kText, [](const MachineStatus& s) { return text_or_none(s.report.cause); }},
    MetricRow{"Job/Bytes", kWhole, [](const MachineStatus& s) { return whole(s.report.total); }},
    MetricRow{"Job/Bytes Sent", kWhole, [](const MachineStatus& s) { return whole(s.report.clocked); }},
    MetricRow{"Job/Bytes Confirmed", kWhole,
              [](const MachineStatus& s) { return s.report.confirms ? whole(s.report.confirmed) : SparkplugValue(); }},
    MetricRow{"Job/Known From Line", kWhole,
              [](const MachineStatus& s) { return whole_or_none(s.report.known.from_line); }},
    MetricRow{"Job/Known To Line", kWhole,
              [](const MachineStatus& s) { return whole_or_none(s.report.known.to_line); }},
    MetricRow{"Job/Holds", kWhole, [](const MachineStatus& s) { return whole(s.report.holds); }},
    MetricRow{"Job/Held Seconds", kReal, [](const MachineStatus& s) { return SparkplugValue(s.report.hold_s); }},
    MetricRow{"Job/Line Use", kReal, [](const MachineStatus& s) { return SparkplugValue(s.report.line_use); }},
    MetricRow{"Control/State", kText,
              [](const MachineStatus& s) {
                return of_control(s, [](const MachineReport& m) { return text_or_none(m.state); });
              }},
    MetricRow{"Control/Program", kWhole,
              [](const MachineStatus& s) {
                return of_control(s, [](const MachineReport& m) { return whole_or_none(m.program); });
              }},
    MetricRow{"Control/Line", kWhole,
              [](const MachineStatus& s) {
                return of_control(s, [](const MachineReport& m) { return whole_or_none(m.line); });
              }},
    MetricRow{"Control/Alarm", kWhole,
              [](const MachineStatus& s) {
                return of_control(s, [](const MachineReport& m) { return whole_or_none(m.alarm); });
              }},
};

// Both have the same metrics in the same order.
std::vector<SparkplugMetric> changed(const std::vector<SparkplugMetric>& before,
                                     const std::vector<SparkplugMetric>& now) {
  std::vector<SparkplugMetric> found;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] != before[i]) found.push_back(now[i]);
  }
  return found;
}

}  // namespace

std::vector<SparkplugMetric> sparkplug_metrics(const MachineStatus& status) {
  std::vector<SparkplugMetric> metrics;
  metrics.reserve(kMetricRows.size());
  for (const MetricRow& row : kMetricRows)
    metrics.push_back({.name = row.name, .type = row.type, .value = row.read(status)});
  return metrics;
}

Sparkplug::Sparkplug(Application& application, Broker& broker, SparkplugNode& node, SparkplugSettings settings)
    : application_(application),
      clock_(application.clock()),
      broker_(broker),
      node_(node),
      settings_(std::move(settings)),
      thread_("sparkplug", kSparkplugRound, Urgency::usual, [this] { round(); }) {}

void Sparkplug::stop() {
  if (ends_.request_stop()) {
    thread_.stop();
    broker_.leave(node_.death(clock_.wall_ms()));
  }
}

void Sparkplug::round() {
  if (ends_.stop_requested()) return;
  const std::uint64_t connection = broker_.connection();
  static_cast<void>(broker_.confirmed());  // nothing is sent again
  if (is_asked_for_rebirth()) is_rebirth_due_ = true;
  if (connection == 0) return;
  const bool is_new = connection != connection_;
  if (is_new || (is_rebirth_due_ && clock_.now() >= next_birth_)) {
    connection_ = connection;
    bear();
  }
  if (clock_.now() >= next_show_) show();
}

bool Sparkplug::is_asked_for_rebirth() {
  const auto commands = broker_.received();
  return std::ranges::any_of(commands, [this](const BrokerMessage& command) {
    return command.topic == node_.command_topic() && settings_.asks_rebirth(command.payload);
  });
}

// The devices are born by the next show(), which is due at once.
void Sparkplug::bear() {
  is_rebirth_due_ = false;
  next_birth_ = clock_.now() + kBirthsEvery;
  next_show_ = {};
  shown_.clear();
  send(node_.birth(settings_.software, clock_.wall_ms()));
}

void Sparkplug::show() {
  next_show_ = clock_.now() + kShowEvery;
  const auto reports = application_.own_reports();
  bury_all_but(reports);
  for (const auto& [machine, report] : reports) {
    Metrics now = sparkplug_metrics(application_.status(machine));
    const auto known = shown_.find(machine);
    const bool is_born = known != shown_.end();
    Metrics news = is_born ? changed(known->second, now) : now;
    if (news.empty()) continue;
    if (!send(node_.of_device(is_born ? "DDATA" : "DBIRTH", machine, std::move(news), clock_.wall_ms()))) return;
    shown_.insert_or_assign(machine, std::move(now));
  }
}

void Sparkplug::bury_all_but(const std::map<std::string, LineReport>& machines) {
  for (auto shown = shown_.begin(); shown != shown_.end();) {
    const bool is_gone = !machines.contains(shown->first);
    if (is_gone) send(node_.of_device("DDEATH", shown->first, {}, clock_.wall_ms()));
    shown = is_gone ? shown_.erase(shown) : std::next(shown);
  }
}

bool Sparkplug::send(const BrokerMessage& message) {
  if (broker_.publish(message) == 0) return false;
  node_.sent();
  return true;
}

}  // namespace dripfeed::app

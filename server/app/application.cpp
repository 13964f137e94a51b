// Start and end, and what several use cases show together.
#include "server/app/application.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include <spdlog/spdlog.h>

#include "dialects/text/source.h"

namespace dripfeed::app {

namespace {

constexpr std::chrono::seconds kCancelAtMost{3};
constexpr std::size_t kBlockAround = 512;  // a block is looked for so far before and after a position

bool runs(const Line& line) {
  const LineReport report = line.report();
  if (report.state == LineState::answering) return true;
  return report.job != 0 && report.end == JobEnd::none && report.state != LineState::idle &&
         report.state != LineState::disconnected;
}

// Positions of a feed count each EOB once. Of a stored text that has more characters a line, as its first line shows,
// the place is after that.
std::uint64_t stored_place(store::Contents& contents, const std::string& sha256, const KnownInterval& known) {
  std::string begin(kBlockAround, '\0');
  const auto count = contents.read(sha256, 0, begin);
  if (!count || known.to_line == 0) return known.to_text;
  begin.resize(*count);
  const std::size_t eob = begin.find_first_of("\r\n");
  if (eob == std::string::npos) return known.to_text;
  return known.to_text + (known.to_line - 1) * (text::eob_length(begin, eob) - 1);
}

// The line of the text that holds the last of its first `end` characters; an EOB belongs to the line that it ends.
std::string block_around(store::Contents& contents, const std::string& sha256, std::uint64_t end) {
  const std::uint64_t at = end == 0 ? 0 : end - 1;
  const std::uint64_t from = at > kBlockAround ? at - kBlockAround : 0;
  std::string window(2 * kBlockAround, '\0');
  const auto count = contents.read(sha256, from, window);
  if (!count || *count == 0) return {};
  window.resize(*count);
  const std::size_t place = std::min<std::size_t>(static_cast<std::size_t>(at - from), window.size() - 1);
  const std::size_t before = place == 0 ? std::string::npos : window.rfind('\n', place - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return window.substr(begin, window.find_first_of("\r\n", begin) - begin);
}

}  // namespace

Application::Application(const Environment& environment)
    : store_(environment.store),
      clock_(environment.clock),
      documents_(environment.documents),
      events_(static_cast<std::uint64_t>(clock_.wall_ms())),
      alarms_(store_, events_, clock_),
      lines_(
          environment.links, environment.take_seat, [this] { line_changed(); }, history_of(store_, environment.claim)),
      books_(store_, lines_, events_, alarms_, clock_, environment.disk_reserve),
      catalog_(store_, lines_, events_, clock_, documents_),
      quota_(store_, environment.limits),
      programs_(store_, clock_, documents_, environment.disk_reserve, environment.workers, &quota_),
      attachments_(store_, clock_, environment.disk_reserve, &quota_),
      line_reading_(store_),
      checking_(store_, events_, clock_, documents_, environment.workers),
      jobs_(store_, lines_, books_, events_, clock_, documents_, CalledPrograms(store_, environment.library),
            environment.hook),
      receiving_({store_, lines_, jobs_, programs_, events_, alarms_, clock_, documents_}),
      maintenance_(environment.maintenance),
      event_source_(environment.event_source),
      shifts_(environment.shifts),
      stop_reasons_(store_, clock_, environment.stop_reasons.empty() ? usual_stop_reasons() : environment.stop_reasons),
      links_(environment.links) {
  store_.verdicts().judge_by(environment.rules);
  if (environment.library != nullptr) library_.emplace(store_, *environment.library, environment.workers);
  if (store::Nodes* const nodes = store_.nodes())
    nodes_.emplace(store_, *nodes, lines_, catalog_, events_, clock_, environment.version);
  if (environment.sender != nullptr) {
    WebhookSettings settings = environment.webhooks;
    if (nodes_) {
      settings.leads = [this] { return nodes_->leads(); };
      settings.is_ours = [this](std::string_view machine) { return nodes_->is_ours(machine); };
    }
    webhooks_.emplace(store_, events_, clock_, *environment.sender, std::move(settings));
  }
}

void Application::line_changed() {
  books_.wake();
  receiving_.wake();
}

Application::~Application() { end_lines(); }

void Application::end_lines() {
  receiving_.stop();
  if (nodes_) nodes_->stop();
  cancel_all();
  static_cast<void>(books_.wait_until_booked());
  // The lines wake the books, so they go before them.
  lines_.close();
  if (library_) library_->stop();
  if (webhooks_) webhooks_->stop();
  if (observations_) observations_->stop();
}

Result<void> Application::start() {
  store::OfMachines ours;
  if (nodes_) {
    if (auto started = nodes_->start(); !started) return started;
    ours = [this](std::string_view machine) { return nodes_->is_ours(machine); };
  }
  const auto interrupted = store_.jobs().interrupt_unfinished({"dripfeed", clock_.wall_ms()}, ours);
  if (!interrupted) return std::unexpected(from_store(interrupted.error()));
  for (const store::Job& job : *interrupted) {
    spdlog::warn("job {} on {} was interrupted: {}", job.id, job.machine, job.reason);
    events_.publish({.id = 0,
                     .kind = EventKind::job,
                     .machine = job.machine,
                     .job = job,
                     .verdict = 0,
                     .outcome = {},
                     .text = job.reason});
  }
  const auto torn = store_.answers().tear_unfinished({"dripfeed", clock_.wall_ms()}, ours);
  if (!torn) return std::unexpected(from_store(torn.error()));
  for (const store::Answer& answer : *torn) spdlog::warn("an answer to {}: {}", answer.machine, answer.reason);
  // Before the lines: what they report is newer.
  if (auto looked = alarms_.start(); !looked) return looked;
  if (auto opened = catalog_.open_lines(ours); !opened) return opened;
  if (nodes_) nodes_->follow();
  return {};
}

namespace {

// What the line itself says, where the store knows of nothing.
std::optional<TornBlock> torn_by_line(const LineFacts& facts) {
  // A job that waits on such a line is cancelled first; a person sees it on the line until then.
  const LineState state = facts.report.state;
  const bool is_free = state == LineState::idle || state == LineState::disconnected;
  if (is_free && !facts.why_refused.empty()) return TornBlock{.text = facts.why_refused, .reason_id = "line_record"};
  if (state != LineState::torn) return std::nullopt;
  return TornBlock{.text = facts.why_torn.empty() ? "a block broke off on this line" : facts.why_torn,
                   .reason_id = "line_torn"};
}

}  // namespace

LineFacts Application::facts(const std::string& machine) {
  LineFacts facts;
  if (const auto line = lines_.find(machine)) {
    facts.report = line->report();
  } else {
    facts.report.link_error = lines_.why_none(machine);
  }
  facts.asks = books_.asks_of(machine);
  facts.why_refused = books_.why_refused(machine);
  if (facts.report.state == LineState::torn) facts.why_torn = lines_.why_torn(machine);
  return facts;
}

MachineStatus Application::status(const std::string& machine, LineFacts facts) {
  MachineStatus status;
  const auto stored = torn_in_store(store_, machine);
  status.is_certain = stored.has_value();
  status.needs_confirmation = stored && *stored ? *stored : torn_by_line(facts);
  status.asks = facts.asks;
  status.report = std::move(facts.report);
  if (status.needs_confirmation && status.report.state != LineState::torn) status.report.state = LineState::torn;
  if (status.report.job == 0) return status;
  const auto job = store_.jobs().get(status.report.job);
  if (!job) return status;
  if (const auto program = store_.programs().get(job->program)) status.program = program->name;
  if (status.report.handed > 0)
    status.block_text = block_around(store_.contents(), job->text_sha256,
                                     stored_place(store_.contents(), job->text_sha256, status.report.known));
  return status;
}

Result<std::shared_ptr<WireTap>> Application::tap(const std::string& machine) {
  const auto known = store_.machines().get(machine);
  if (!known) return std::unexpected(from_store(known.error()));
  const auto line = lines_.find(machine);
  if (!line) return fail(ErrorCode::unavailable, lines_.why_none(machine));
  auto tap = line->tap();
  if (!tap) return fail(ErrorCode::refused, fmt::format("the line of {} carries no characters", machine));
  return tap;
}

Result<Application::LineTested> Application::test_line(const std::string& machine, const LinkTestPlan& plan,
                                                       std::string_view actor) {
  const auto profile = catalog_.profile(machine);
  if (!profile) return std::unexpected(profile.error());
  const MachineStatus now = status(machine);
  if (now.needs_confirmation || !now.is_certain)
    return fail(ErrorCode::refused,
                fmt::format("a person must first confirm that the control of {} was reset", machine));
  if (now.asks.since_ms != 0) {
    return fail(ErrorCode::refused,
                fmt::format("the control of {} asks for a program: take its plug off the line first", machine));
  }
  {
    const auto held = lines_.hold(machine);
    if (auto out = lines_.take_out(machine, fmt::format("the line is being tested by {}", actor)); !out)
      return std::unexpected(out.error());
  }
  auto done = test_link(profile->line, links_, plan);
  const auto held = lines_.hold(machine);
  const auto back = lines_.put_back(*profile);
  const std::string came_of_it = !done                                ? done.error().text
                                 : keeps_budget(*done, profile->line) ? "within the budget"
                                                                      : "not within the budget";
  const auto noted = store_.audit().append({"machine.line-test", fmt::format("machine/{}", machine), came_of_it},
                                           {std::string(actor), clock_.wall_ms()});
  if (!noted) return std::unexpected(from_store(noted.error()));
  if (!back) return std::unexpected(back.error());
  return LineTested{.line = profile->line, .done = std::move(done)};
}

std::map<std::string, LineReport> Application::reports() {
  std::map<std::string, LineReport> all;
  store::PageRequest page{.limit = store::kPageLimitMax, .after = {}};
  do {
    const auto machines = store_.machines().list(page);
    if (!machines) break;
    for (const store::Machine& machine : machines->items) all[machine.name] = facts(machine.name).report;
    page.after = machines->next;
  } while (!page.after.empty());
  return all;
}

std::map<std::string, LineReport> Application::own_reports() {
  std::map<std::string, LineReport> all = reports();
  if (nodes_) std::erase_if(all, [&](const auto& row) { return !nodes_->is_ours(row.first); });
  return all;
}

Observations& Application::observations() {
  std::call_once(observed_, [this] { observations_.emplace(clock_, [this] { return reports(); }); });
  return *observations_;
}

void Application::cancel_all() {
  bool any = false;
  for (const auto& [machine, line, claim, left] : lines_.all()) {
    if (!runs(*line)) continue;
    any = true;
    const LineState state = line->report().state;
    // An answer that no one asked for yet is taken back; one that goes out ends at a block end as everything does.
    if (state == LineState::answering && line->command(feed::Command::disarm)) continue;
    const feed::Command how = state == LineState::armed ? feed::Command::disarm : feed::Command::cancel;
    if (const auto done = line->command(how); !done) spdlog::warn("{}: {}", machine, done.error());
  }
  const auto until = std::chrono::steady_clock::now() + kCancelAtMost;
  while (any && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    any = false;
    for (const auto& [machine, line, claim, left] : lines_.all()) any = any || runs(*line);
  }
}

}  // namespace dripfeed::app

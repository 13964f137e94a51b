// The steps that the tests of the use cases take first.
#include <algorithm>
#include <filesystem>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app::test {

Result<machine::Profile> PlainDocuments::read_profile(std::string_view document) const {
  const std::size_t blank = document.find(' ');
  const auto url =
      machine::parse_link_url(blank == std::string_view::npos ? std::string_view() : document.substr(blank + 1));
  if (!url) return fail(ErrorCode::invalid, url.error(), {{.pointer = "/link/url", .text = url.error()}});
  machine::Profile profile;
  profile.name = document.substr(0, blank);
  profile.control.dialect = profile.name.starts_with("martian") ? "martian" : "fanuc";
  if (profile.name.starts_with("lathe")) profile.control.kind = profile.machine.kind = ir::MachineKind::lathe;
  profile.line = line_settings();
  profile.line.link = *url;
  return profile;
}

Result<Values> PlainDocuments::read_values(std::string_view document) const {
  Values values;
  while (!document.empty()) {
    const std::string_view item = document.substr(0, document.find(';'));
    document.remove_prefix(std::min(document.size(), item.size() + 1));
    const std::size_t equals = item.find('=');
    if (equals == std::string_view::npos) return fail(ErrorCode::invalid, "no value");
    values[std::string(item.substr(0, equals))] = item.substr(equals + 1);
  }
  return values;
}

std::string PlainDocuments::write_values(const Values& values) const {
  std::string text;
  for (const auto& [name, value] : values) text += (text.empty() ? "" : ";") + name + "=" + value;
  return text;
}

std::string PlainDocuments::write_report(const CheckReport& report) const {
  return std::string(checks::name_of(report.verdict));
}

std::optional<double> PlainDocuments::cycle_s(std::string_view /*report*/) const { return std::nullopt; }

std::string PlainDocuments::write_drawing(const std::vector<family::DrawnView>& drawing) const {
  std::string text;
  for (const family::DrawnView& view : drawing) text += std::string(view.axes) + ";";
  return text;
}

store::Release release_text(store::Store& store, const std::string& machine, const std::string& text,
                            store::Delivery delivery) {
  store::NewProgramText row;
  row.sha256 = must(store.contents().put(text)).sha256;
  row.blocks = 1;
  const store::Program program = must(store.programs().add("O0042", "fanuc", row, by("anna")));
  store::NewVerdict verdict;
  verdict.program = program.id;
  verdict.revision = 1;
  verdict.machine = machine;
  verdict.machine_revision = must(store.machines().get(machine)).revision;
  verdict.delivery = delivery;
  verdict.outcome = store::Outcome::pass;
  must(store.verdicts().add(verdict, by("anna")));
  const store::Release release = must(store.releases().add({program.id, 1, machine, delivery}, by("anna")));
  must(store.releases().move(release.id, {store::ReleaseState::in_review, "", 0}, by("anna")));
  must(store.releases().move(release.id, {store::ReleaseState::proving, "", 100}, by("boris")));
  // No operator has to sign it off: nothing is transferred here.
  must(store.users().put_group({"unproved", {machine}, false, false}, by("anna")));
  const store::Release approved =
      must(store.releases().move(release.id, {store::ReleaseState::approved, "measured", 0}, by("boris")));
  must(store.users().remove_group("unproved", by("anna")));
  return approved;
}

std::string killed_copy(const std::string& database) {
  for (const char* ending : {"", "-wal"}) {
    std::filesystem::copy_file(database + ending, database + "-killed" + ending,
                               std::filesystem::copy_options::overwrite_existing);
  }
  return database + "-killed";
}

Shop::Shop(const std::string& database, BusSeatMaker take_seat, DiskReserve* disk_reserve, ClaimLine claim)
    : sqlite_(must(sqlite::open(database, {.own = true}))),
      store(*sqlite_),
      alarms(store, events, links.clock()),
      lines(
          links, take_seat, [this] { books.wake(); }, history_of(store, std::move(claim))),
      books(store, lines, events, alarms, links.clock(), disk_reserve),
      catalog(store, lines, events, links.clock(), documents),
      jobs(store, lines, books, events, links.clock(), documents, CalledPrograms(store, nullptr)) {}

Shop::~Shop() {
  store.watched_ledger().watch({});
  lines.close();  // they wake the books
}

void Shop::add_machine(const std::string& name, const std::string& url) {
  must(catalog.add_machine(name + " " + (url.empty() ? url_of(name) : url), "anna"));
  links.run_posted();
}

store::Job Shop::add_job(const std::string& machine, const std::string& text) {
  return must(jobs.add(release_text(store, machine, text).id, "anna"));
}

store::Job Shop::start_job(const std::string& machine, const std::string& text) {
  const store::Job added = add_job(machine, text);
  must(jobs.arm(added.id, std::nullopt, "olga"));
  links.receive(url_of(machine), kDc1);
  round();
  return added;
}

void Shop::run(feed::Time span) {
  constexpr feed::Time kStep = std::chrono::milliseconds(50);
  for (feed::Time passed{}; passed < span; passed += kStep) {
    links.advance(std::min(kStep, span - passed));
    round();
  }
}

void Shop::round() {
  books.read_ahead(std::chrono::seconds(10));
  books.wait_until_booked();
  alarms.wait_for_round(std::chrono::seconds(10));
  links.run_posted();
}

std::string Shop::written(const std::string& machine) { return text_of(links.cable(url_of(machine)).written); }

std::vector<std::string> Shop::published() const {
  static constexpr const char* kKinds[] = {"job", "machine", "verdict", "alarm", "receipt"};
  std::vector<std::string> all;
  for (const Event& event : events.since(0).events) {
    all.push_back(std::string(kKinds[static_cast<std::size_t>(event.kind)]) + " " + event.machine + " " + event.text);
  }
  return all;
}

std::string Shop::last_published() const {
  std::vector<std::string> all = published();
  std::erase_if(all, [](const std::string& text) { return text.starts_with("machine "); });
  return all.empty() ? std::string() : all.back();
}

std::vector<std::string> Shop::audited(store::Id id) {
  std::vector<std::string> all;
  const auto page =
      must(store.audit().list({.limit = store::kPageLimitMax, .after = {}}, {.subject = "job/" + std::to_string(id)}));
  for (const store::AuditRow& row : page.items) all.push_back(row.entry.action + ": " + row.entry.detail);
  std::ranges::reverse(all);
  return all;
}

std::vector<store::LedgerRow> Shop::ledger_of(store::Id id) {
  return must(store.ledger().rows(id, {.limit = store::kPageLimitMax, .after = {}})).items;
}

}  // namespace dripfeed::app::test

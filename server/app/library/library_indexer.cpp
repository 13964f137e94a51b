// A few programs at a time: read, digested by a worker, put into the library, which then says up to which change it
// goes.
#include "server/app/library/library_indexer.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::app {

namespace {

constexpr std::chrono::milliseconds kLookEvery{250};
constexpr std::uint32_t kAtOnce = 32;
constexpr std::size_t kMostOfText = std::size_t{4} << 20U;
constexpr std::size_t kMostOfAll = std::size_t{8} << 20U;
constexpr int kNice = 10;  // the disk and the processor are for those who wait
constexpr std::uint32_t kMachinesNamed = 200;

// The beginning of a text, up to a block's end where it is longer.
Result<std::string> beginning_of(store::Contents& contents, const store::ProgramRevision& revision) {
  if (revision.revision == 0) return std::string();  // of a program that was deleted
  std::string text(std::min<std::uint64_t>(revision.bytes, kMostOfText), '\0');
  const auto count = lift(contents.read(revision.sha256, 0, text));
  if (!count) return std::unexpected(count.error());
  text.resize(*count);
  if (revision.bytes > text.size()) text.resize(std::min(text.find_last_of("\r\n"), text.size() - 1) + 1);
  return text;
}

// The machines for which it is released, or for which it was rendered.
Result<std::string> machines_of(store::Store& store, const store::Program& program) {
  const auto releases = lift(store.releases().list({.limit = kMachinesNamed, .after = {}}, {.program = program.id}));
  if (!releases) return std::unexpected(releases.error());
  std::set<std::string> names;
  for (const store::Release& one : releases->items) names.insert(one.of.machine);
  if (!program.newest.origin.machine.empty()) names.insert(program.newest.origin.machine);
  return fmt::format("{}", fmt::join(names, " "));
}

store::CallKind kind_of(ir::CallKind kind) {
  switch (kind) {
    case ir::CallKind::subprogram: return store::CallKind::subprogram;
    case ir::CallKind::macro: return store::CallKind::macro;
    case ir::CallKind::external: return store::CallKind::external;
  }
  return store::CallKind::subprogram;
}

store::LibraryEntry entry_of(const store::Program& program, ProgramDigest digest, std::string machines) {
  // One that was deleted is taken out, also where history names its text.
  if (program.is_deleted()) return {.program = program.id, .change = program.change};
  store::LibraryEntry entry{.program = program.id,
                            .revision = program.newest.revision,
                            .change = program.change,
                            .sha256 = program.newest.sha256,
                            .name = program.name,
                            .numbers = fmt::format("{}", fmt::join(digest.names, " ")),
                            .labels = fmt::format("{} {}", fmt::join(program.tags, " "), program.folder),
                            .part = program.newest.origin.part,
                            .machines = std::move(machines),
                            .comments = std::move(digest.comments),
                            .text = std::move(digest.words),
                            .is_archived = program.is_archived(),
                            .is_cut = digest.is_cut,
                            .not_read = std::move(digest.not_read),
                            .computed_calls = digest.computed_calls};
  std::set<std::string> keys = {compile::call_key(program.name)};
  for (const std::string& name : digest.names) keys.insert(compile::call_key(name));
  entry.names.assign(keys.begin(), keys.end());
  for (const compile::DigestCall& call : digest.calls)
    entry.calls.push_back({.name = call.name, .kind = kind_of(call.kind), .line = call.line});
  return entry;
}

}  // namespace

LibraryIndexer::LibraryIndexer(store::Store& store, store::Library& library, Workers* workers)
    : store_(store),
      library_(library),
      workers_(workers),
      thread_("library", kLookEvery, Urgency::usual, [this] { round(); }) {}

void LibraryIndexer::stop() {
  ends_.request_stop();
  thread_.stop();
}

Result<std::uint64_t> LibraryIndexer::waiting() {
  const auto state = lift(library_.state());
  if (!state) return std::unexpected(state.error());
  return lift(store_.programs().count_changed_after(state->change));
}

void LibraryIndexer::round() {
  if (ends_.stop_requested()) return;
  const auto version = store_.version();
  if (version && seen_ == *version) return;
  if (!is_ours_) {
    static_cast<void>(::setpriority(PRIO_PROCESS, 0, kNice));
    if (const auto dropped = drop_another_store_s(); !dropped) return spdlog::warn("library: {}", dropped.error().text);
    is_ours_ = true;
  }
  while (!ends_.stop_requested()) {
    const auto more = step();
    if (!more) {
      // Nothing waits for it: a place for the work, or room on the disk, comes by itself.
      if (more.error().code != ErrorCode::unavailable) spdlog::warn("library: {}", more.error().text);
      return;
    }
    if (*more) continue;
    if (version) seen_ = *version;
    return;
  }
}

// A store that was restored from a backup may be older than what the library has.
Result<void> LibraryIndexer::drop_another_store_s() {
  const auto state = lift(library_.state());
  if (!state) return std::unexpected(state.error());
  if (state->change == 0) return {};
  const auto newer = lift(store_.programs().count_changed_after(state->change - 1));
  if (!newer) return std::unexpected(newer.error());
  return *newer > 0 ? Result<void>{} : lift(library_.clear());
}

Result<bool> LibraryIndexer::step() {
  const auto state = lift(library_.state());
  if (!state) return std::unexpected(state.error());
  const auto changed = lift(store_.programs().changed_after(state->change, kAtOnce));
  if (!changed) return std::unexpected(changed.error());
  if (changed->empty()) return false;
  // Nothing is read from the disk while other work keeps the workers from it.
  if (const auto room = digests_of({}); !room) return std::unexpected(room.error());
  std::vector<DigestOrder> orders;
  std::vector<std::string> machines;
  std::size_t bytes = 0;
  for (const store::Program& program : *changed) {
    auto text = beginning_of(store_.contents(), program.newest);
    if (!text) return std::unexpected(text.error());
    if (!orders.empty() && bytes + text->size() > kMostOfAll) break;
    bytes += text->size();
    auto names = machines_of(store_, program);
    if (!names) return std::unexpected(names.error());
    machines.push_back(std::move(*names));
    orders.push_back({.name = program.name,
                      .dialect = program.dialect,
                      .text = std::move(*text),
                      .is_whole = program.newest.bytes <= kMostOfText});
  }
  auto digests = digests_of(orders);
  if (!digests) return std::unexpected(digests.error());
  std::vector<store::LibraryEntry> entries;
  entries.reserve(digests->size());
  for (std::size_t i = 0; i < digests->size(); ++i)
    entries.push_back(entry_of((*changed)[i], std::move((*digests)[i]), std::move(machines[i])));
  if (auto put = lift(library_.put(entries, entries.back().change)); !put) return std::unexpected(put.error());
  return true;
}

// One text that no worker comes through with is put in as it stands; it is not known what it calls then.
Result<std::vector<ProgramDigest>> LibraryIndexer::digests_of(const std::vector<DigestOrder>& orders) {
  const Waiter waiter{.stop = ends_.get_token(),
                      .peer = -1,
                      .work = {.kind = "index", .subject = "programs", .machine = {}, .actor = "dripfeed"}};
  auto all = workers_ != nullptr ? workers_->digest(orders, waiter) : digest_programs(orders);
  if (all || all.error().code == ErrorCode::unavailable || ends_.stop_requested()) return all;
  std::vector<ProgramDigest> each;
  each.reserve(orders.size());
  for (const DigestOrder& order : orders) {
    auto one = orders.size() == 1 ? Result<std::vector<ProgramDigest>>(std::unexpected(all.error()))
                                  : workers_->digest({order}, waiter);
    if (!one && (one.error().code == ErrorCode::unavailable || ends_.stop_requested()))
      return std::unexpected(one.error());
    each.push_back(one ? std::move(one->front()) : undigested(order, one.error().text));
  }
  return each;
}

}  // namespace dripfeed::app

// A control has one program of a name; the library may have several: of other machines, of other customers, of tests.
#include "server/app/shop/called_programs.h"

#include <algorithm>
#include <functional>
#include <ranges>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/program_digest.h"
#include "server/app/shop/program_pieces.h"

namespace dripfeed::app {

namespace {

constexpr std::size_t kMostNamed = 20;  // of those that a sentence lists

// The names that a program may be stored under, if the library has not read it yet.
std::set<std::string> spellings(const std::string& key) {
  std::set<std::string> all{key};
  constexpr std::size_t kDigits = 4;
  if (key.size() > 1 && key.front() == 'O' && key.find_first_not_of("0123456789", 1) == std::string::npos &&
      key.size() <= kDigits)
    all.insert("O" + std::string(kDigits + 1 - key.size(), '0') + key.substr(1));
  return all;
}

std::string list_of(const std::vector<store::Id>& ids) {
  std::string list;
  for (const store::Id id : ids | std::views::take(kMostNamed))
    list += fmt::format("{}{}", list.empty() ? "" : ", ", id);
  return list;
}

}  // namespace

std::optional<text::Source> CalledBy::find(std::string_view name) {
  const std::string key = compile::call_key(name);
  const auto known = std::ranges::find(texts, key, &CalledText::key);
  if (known == texts.end()) missing.insert(key);
  if (known == texts.end() || !known->why_not.empty()) return std::nullopt;
  return text::Source(known->name, known->text);
}

Result<std::vector<CalledPrograms::Found>> CalledPrograms::all_named(const Caller& caller, const std::string& key) {
  std::set<store::Id> ids;
  if (library_ != nullptr) {
    const auto named = lift(library_->named(key));
    if (!named) return std::unexpected(named.error());
    ids.insert(named->begin(), named->end());
  }
  for (const std::string& name : spellings(key)) {
    const auto listed = lift(store_.programs().list({.limit = store::kPageLimitMax, .after = {}}, {.name = name}));
    if (!listed) return std::unexpected(listed.error());
    for (const store::Program& one : listed->items) ids.insert(one.id);
  }
  std::vector<Found> found;
  for (const store::Id id : ids) {
    auto program = store_.programs().get(id);
    if (!program) continue;  // the library is older than the store
    const std::string& made_for = program->newest.origin.machine;
    const bool is_another_s = !made_for.empty() && made_for != caller.machine;
    if (program->dialect != caller.dialect || program->is_archived() || is_another_s) continue;
    Found one{.program = std::move(*program), .revision = 0, .is_released = false};
    one.revision = one.program.newest.revision;
    const auto releases = lift(store_.releases().list({.limit = store::kPageLimitMax, .after = {}},
                                                      {.program = id, .machine = caller.machine}));
    if (!releases) return std::unexpected(releases.error());
    for (const store::Release& release : releases->items) {
      if (release.state != store::ReleaseState::proving && release.state != store::ReleaseState::approved) continue;
      one.is_released = true;
      one.revision = release.of.revision;
      break;  // the newest
    }
    found.push_back(std::move(one));
  }
  return found;
}

Result<CalledText> CalledPrograms::choose(const Caller& caller, std::string_view name) {
  CalledText out{.key = compile::call_key(name), .name = {}, .text = {}, .why_not = {}};
  auto found = all_named(caller, out.key);
  if (!found) return std::unexpected(found.error());
  const auto keep = [&](const std::function<bool(const Found&)>& is_better) {
    if (std::ranges::any_of(*found, is_better))
      std::erase_if(*found, [&](const Found& one) { return !is_better(one); });
  };
  keep([](const Found& one) { return one.is_released; });
  keep([&](const Found& one) { return one.program.folder == caller.folder; });
  if (found->empty()) return out;
  if (found->size() > 1) {
    std::vector<store::Id> ids;
    for (const Found& one : *found) ids.push_back(one.program.id);
    out.why_not = fmt::format("which program {} the control holds: the library has several of this name ({})", out.key,
                              list_of(ids));
    return out;
  }
  const Found& one = found->front();
  out.program = one.program.id;
  out.revision = one.revision;
  out.name = one.program.name;
  return out;
}

Result<CalledText> CalledPrograms::find(const Caller& caller, std::string_view name) {
  auto chosen = choose(caller, name);
  if (!chosen || chosen->program == 0) return chosen;
  const auto revision = lift(store_.programs().get_revision(chosen->program, chosen->revision));
  if (!revision) return std::unexpected(revision.error());
  if (revision->bytes > kMostBytes) {
    chosen->why_not = fmt::format("what {} does: the program has {} bytes, more than are read of a called program",
                                  chosen->key, revision->bytes);
    chosen->program = 0;  // it is not what the text is run with
    return chosen;
  }
  auto text = lift(store::read_whole(store_.contents(), revision->sha256, kMostBytes));
  if (!text) return std::unexpected(text.error());
  const auto pieces = pieces_of(*text);
  const auto piece = std::ranges::find(pieces, chosen->key, &ProgramPiece::name);
  chosen->text = piece != pieces.end() && pieces.size() > 1 ? piece->in_place() : std::move(*text);
  return chosen;
}

Result<void> CalledPrograms::refuse_changed(const store::Verdict& verdict) {
  if (verdict.of.calls.empty()) return {};
  const auto caller = lift(store_.programs().get(verdict.of.program));
  if (!caller) return std::unexpected(caller.error());
  for (const store::VerdictCall& call : verdict.of.calls) {
    const auto now = choose({caller->dialect, verdict.of.machine, caller->folder}, call.name);
    if (!now) return std::unexpected(now.error());
    if (now->program == call.program && now->revision == call.revision) continue;
    return fail(ErrorCode::refused,
                fmt::format("verdict {} was made with {} as revision {} of program {}; now {}: check the text again",
                            verdict.id, call.name, call.revision, call.program,
                            now->program == 0
                                ? "it is not known which one is called"
                                : fmt::format("revision {} of program {} is called", now->revision, now->program)));
  }
  return {};
}

}  // namespace dripfeed::app

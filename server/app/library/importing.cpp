// A program is known by its folder and name.
#include "server/app/library/importing.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "server/app/base/names.h"
#include "store/hash/sha256.h"

namespace dripfeed::app {

namespace {

// As the page has them. Those of SINUMERIK (.MPF, .SPF) belong to the name.
constexpr std::array<std::string_view, 13> kEndings = {".nc",  ".txt", ".tap", ".cnc", ".iso", ".eia",  ".ngc",
                                                       ".min", ".prg", ".h",   ".din", ".g",   ".gcode"};
// How other files begin that are texts all the same.
constexpr std::array<std::string_view, 5> kOtherFiles = {"%PDF-", "{\\rtf", "<!DOCTYPE", "<html", "<?xml"};
constexpr std::size_t kHead_bytes = std::size_t{64} << 10U;  // shows what a file is
constexpr std::size_t kControlsIn = 20;                      // a text has at most one of so many characters

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

// What no control writes: line ends, tabs, reader codes (DC1 to DC4, SO, SI), end of file and escape are.
bool is_strange(char c) {
  constexpr std::string_view kKnown = "\t\n\v\f\r\x0e\x0f\x11\x12\x13\x14\x1a\x1b";
  return c >= 0 && (c < ' ' || c == '\x7f') && kKnown.find(c) == std::string_view::npos;
}

// All programs of that name in just that folder.
Result<std::vector<store::Program>> known_in(store::Store& store, const std::string& folder, const std::string& name) {
  std::vector<store::Program> found;
  store::PageRequest page{.limit = store::kPageLimitMax, .after = {}};
  do {
    auto programs = lift(store.programs().list(page, {.name = name, .folder = folder}));
    if (!programs) return std::unexpected(programs.error());
    for (store::Program& program : programs->items)
      if (program.folder == folder) found.push_back(std::move(program));
    page.after = std::move(programs->next);
  } while (!page.after.empty());
  return found;
}

void end_with(Imported& done, ImportOutcome outcome, std::string why = {}) {
  done.outcome = outcome;
  done.why = std::move(why);
}

Result<void> look_at(const TextToImport& one) {
  if (const std::string why = why_no_name(one.name); !why.empty())
    return fail(ErrorCode::invalid, fmt::format("the name {}", why));
  if (const std::string why = why_no_folder(one.folder); !why.empty())
    return fail(ErrorCode::invalid, fmt::format("the folder {}", why));
  return {};
}

}  // namespace

Imported Importer::import(const TextToImport& one) {
  Imported done{.name = one.name, .folder = one.folder, .bytes = one.text.size()};
  done.sha256 = hash::sha256_hex(one.text);
  if (const auto placed = place(one, done); !placed) end_with(done, ImportOutcome::failed, placed.error().text);
  if (done.outcome != ImportOutcome::failed) brought_[{one.folder, one.name}] = done.sha256;
  return done;
}

Result<bool> Importer::knows(const std::string& folder, const std::string& name) {
  const auto known = known_in(store_, folder, name);
  if (!known) return std::unexpected(known.error());
  return !known->empty();
}

Result<void> Importer::place(const TextToImport& one, Imported& done) {
  if (auto good = look_at(one); !good) return good;
  const auto before = brought_.find(std::pair(one.folder, one.name));
  if (before != brought_.end() && before->second != done.sha256 && !one.follows)
    return fail(ErrorCode::refused, "this import has brought another text of this name into this folder");
  if (before != brought_.end() && !one.follows && plan_.only_look) {
    end_with(done, ImportOutcome::same);
    return {};
  }
  auto known = known_in(store_, one.folder, one.name);
  if (!known) return std::unexpected(known.error());
  const auto archived = std::ranges::find_if(*known, &store::Program::is_archived);
  const std::string why_archived =
      archived == known->end() ? std::string()
                               : fmt::format("archived by {}: {}", archived->archived.by, archived->archived.reason);
  std::erase_if(*known, [](const store::Program& program) { return program.is_archived(); });
  if (known->empty() && !why_archived.empty()) {
    end_with(done, ImportOutcome::skipped, why_archived);
    return {};
  }
  if (known->empty()) return place_new(one, done);
  const auto same = std::ranges::find(*known, done.sha256, [](const store::Program& p) { return p.newest.sha256; });
  if (same == known->end() && known->size() > 1)
    return fail(ErrorCode::refused, fmt::format("{} programs have this name in this folder", known->size()));
  return place_revision(one, same == known->end() ? known->front() : *same, done);
}

Result<void> Importer::place_new(const TextToImport& one, Imported& done) {
  done.dialect = one.dialect.empty() ? plan_.dialect : one.dialect;
  if (done.dialect.empty())
    done.dialect = compile::infer_dialect({one.name, std::string(one.text.substr(0, kHead_bytes))}).name;
  end_with(done, ImportOutcome::added);
  if (plan_.only_look) return {};
  const auto kept = programs_.keep_text(done.dialect, one.text);
  if (!kept) return std::unexpected(kept.error());
  return lift(store_.atomically([&]() -> store::Result<void> {
    const auto added = store_.programs().add(one.name, done.dialect, *kept, stamp());
    if (!added) return std::unexpected(added.error());
    done.program = added->id;
    done.revision = added->newest.revision;
    if (one.folder.empty() && one.tags.empty()) return {};
    const auto labelled = store_.programs().label(added->id, {.tags = one.tags, .folder = one.folder}, stamp());
    return labelled ? store::Result<void>{} : std::unexpected(labelled.error());
  }));
}

Result<void> Importer::place_revision(const TextToImport& one, const store::Program& known, Imported& done) {
  done.dialect = known.dialect;
  done.program = known.id;
  if (known.newest.sha256 == done.sha256) {
    done.revision = known.newest.revision;
    end_with(done, ImportOutcome::same);
    return {};
  }
  if (plan_.known == KnownName::skip) {
    end_with(done, ImportOutcome::skipped, "the name is in use with another text");
    return {};
  }
  end_with(done, ImportOutcome::revised);
  if (plan_.only_look) return {};
  const auto kept = programs_.keep_text(one.text);
  if (!kept) return std::unexpected(kept.error());
  const auto revised = lift(store_.programs().add_revision(known.id, known.newest.revision, *kept, stamp()));
  if (!revised) return std::unexpected(revised.error());
  done.revision = revised->newest.revision;
  return {};
}

std::string why_no_dialect(std::string_view dialect) {
  const bool is_known = dialect.empty() || compile::find_dialect(dialect) != nullptr;
  return is_known ? "" : fmt::format("\"{}\" is not known", dialect);
}

std::string program_name_of(std::string_view file) {
  const std::string small = lower(file);
  const auto* const ending = std::ranges::find_if(
      kEndings, [&](std::string_view one) { return small.ends_with(one) && small.size() > one.size(); });
  if (ending != kEndings.end()) file.remove_suffix(ending->size());
  while (file.ends_with(' ')) file.remove_suffix(1);
  while (file.starts_with(' ')) file.remove_prefix(1);
  return std::string(file);
}

std::string why_no_program(std::string_view bytes) {
  if (bytes.size() > kLargestProgram_bytes)
    return fmt::format("has {} bytes, more than the {} of a program", bytes.size(), kLargestProgram_bytes);
  // Leader and trailer of a punched tape.
  while (bytes.starts_with('\0')) bytes.remove_prefix(1);
  while (bytes.ends_with('\0')) bytes.remove_suffix(1);
  if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) return "is empty";
  const std::string_view head = bytes.substr(0, kHead_bytes);
  const bool is_other =
      std::ranges::any_of(kOtherFiles, [&](std::string_view begin) { return head.starts_with(begin); });
  const auto strange = static_cast<std::size_t>(std::ranges::count_if(head, is_strange));
  return is_other || strange * kControlsIn > head.size() ? "is not a text of a program" : "";
}

}  // namespace dripfeed::app

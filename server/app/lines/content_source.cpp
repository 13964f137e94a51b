// A ring with one reader and one writer. A chunk is released when the next one is asked for, because the feed still
// reads it.
#include "server/app/lines/content_source.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "server/machine/file_drop.h"

namespace dripfeed::app {

namespace {

std::unexpected<Error> refuse_at(std::uint64_t line, std::uint64_t column, const std::string& text) {
  return fail(ErrorCode::refused, fmt::format("line {}, column {}: {}", line, column, text),
              {{.pointer = {},
                .line = static_cast<std::uint32_t>(line),
                .column = static_cast<std::uint32_t>(column),
                .text = text}});
}

}  // namespace

ContentSource::ContentSource(std::shared_ptr<store::ContentReader> text, std::uint32_t rounds, TextPart part)
    : text_(std::move(text)), rounds_left_(rounds), part_(part), offset_(part.begin) {
  refill();
}

void ContentSource::refill() {
  while (!over_.load() && !failed_.load() && filled_.load() - released_.load() < kChunks) {
    fill_one(chunks_[filled_.load() % kChunks]);
  }
}

void ContentSource::fill_one(std::string& chunk) {
  std::string raw(std::min<std::uint64_t>(store::kChunkBytes, part_.end - offset_), '\0');
  const auto count = raw.empty() ? store::Result<std::size_t>(0) : text_->read(offset_, raw);
  if (!count) {
    failed_.store(true);
    return;
  }
  offset_ += *count;
  chunk.clear();
  for (const char c : std::string_view(raw).substr(0, *count)) eobs_.put(c, chunk);
  if (*count == 0) eobs_.finish(chunk);
  if (!chunk.empty()) filled_.fetch_add(1);
  if (*count > 0) return;
  if (--rounds_left_ == 0) over_.store(true);
  offset_ = part_.begin;
  eobs_ = {};
}

tape_code::TextPiece ContentSource::next() noexcept {
  released_.store(taken_);
  // `over_` is read first: what was filled before it was set is seen then.
  const bool over = over_.load();
  if (taken_ < filled_.load()) {
    const std::string& chunk = chunks_[taken_++ % kChunks];
    return {.status = tape_code::SourceStatus::text, .text = chunk};
  }
  if (failed_.load()) return {.status = tape_code::SourceStatus::failed, .text = {}};
  return {.status = over ? tape_code::SourceStatus::end : tape_code::SourceStatus::not_ready, .text = {}};
}

Result<TextPart> part_for(store::Contents& contents, const std::string& sha256, const machine::Profile& profile) {
  if (!machine::drops_bare_files(profile)) return TextPart{};
  const auto known = lift(contents.find(sha256));
  if (!known) return std::unexpected(known.error());
  std::string head(std::min<std::uint64_t>(known->bytes, machine::kArchiveEdge), '\0');
  std::string tail = head;
  const auto first = lift(contents.read(sha256, 0, head));
  const auto last = lift(contents.read(sha256, known->bytes - tail.size(), tail));
  if (!first || !last) return fail(ErrorCode::unavailable, "the stored text cannot be read");
  const std::size_t begin = machine::archive_head(head);
  const std::size_t tail_bytes = machine::archive_tail(tail);
  std::string lines;
  tape_code::EobReader eobs;
  for (const char c : std::string_view(head).substr(0, begin)) eobs.put(c, lines);
  eobs.finish(lines);
  return TextPart{.begin = begin,
                  .end = std::max<std::uint64_t>(begin, known->bytes - tail_bytes),
                  .line = 1 + static_cast<std::uint64_t>(std::ranges::count(lines, '\n'))};
}

Result<feed::ProgramFacts> check_program(store::Contents& contents, const std::string& sha256,
                                         const machine::Profile& profile, ir::Delivery delivery) {
  const auto part = part_for(contents, sha256, profile);
  if (!part) return std::unexpected(part.error());
  return check_program(store::read_in_place(contents, sha256), *part, profile, delivery);
}

Result<feed::ProgramFacts> check_program(std::shared_ptr<store::ContentReader> text, const TextPart& part,
                                         const machine::Profile& profile, ir::Delivery delivery) {
  const auto line = machine::effective_line(profile.line);
  if (!line) return fail(ErrorCode::refused, line.error());
  ContentSource source(std::move(text), 1, part);
  feed::ProgramCheck check(machine::program_syntax_of(profile, delivery));
  tape_code::CharacterCheck characters(machine::characters_of(*line));
  for (;;) {
    const tape_code::TextPiece piece = source.next();
    if (piece.status == tape_code::SourceStatus::end) break;
    if (piece.status == tape_code::SourceStatus::failed)
      return fail(ErrorCode::unavailable, "the stored text cannot be read");
    if (piece.status == tape_code::SourceStatus::text) {
      check.append(piece.text);
      characters.append(piece.text);
    }
    source.refill();
  }
  if (characters.count() > 0) {
    const tape_code::IllegalCharacter& first = characters.found().front();
    return refuse_at(part.line - 1 + first.line, first.column,
                     fmt::format("{} ({} such)", machine::character_refusal(*line, first), characters.count()));
  }
  const auto facts = check.finish();
  if (facts) return *facts;
  const feed::ProgramRefusal& refusal = facts.error();
  return refuse_at(part.line - 1 + refusal.line, refusal.column, std::string(feed::message(refusal.fault)));
}

}  // namespace dripfeed::app

// A ring with one reader and one writer. A chunk is released when the next one is asked for, because the feed still
// reads it.
#include "server/app/content_source.h"

#include <utility>

#include <fmt/format.h>

namespace dripfeed::app {

ContentSource::ContentSource(store::Contents& contents, std::string sha256)
    : contents_(contents), sha256_(std::move(sha256)) {
  refill();
}

void ContentSource::refill() {
  while (!over_.load() && !failed_.load() && filled_.load() - released_.load() < kChunks) {
    fill_one(chunks_[filled_.load() % kChunks]);
  }
}

void ContentSource::fill_one(std::string& chunk) {
  std::string raw(store::kChunkBytes, '\0');
  const auto count = contents_.read(sha256_, offset_, raw);
  if (!count) {
    failed_.store(true);
    return;
  }
  offset_ += *count;
  chunk.clear();
  for (const char c : std::string_view(raw).substr(0, *count)) eobs_.put(c, chunk);
  if (*count == 0) eobs_.finish(chunk);
  if (!chunk.empty()) filled_.fetch_add(1);
  if (*count == 0) over_.store(true);
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

Result<feed::ProgramFacts> check_program(store::Contents& contents, const std::string& sha256,
                                         const feed::ProgramSyntax& syntax) {
  ContentSource source(contents, sha256);
  feed::ProgramCheck check(syntax);
  for (;;) {
    const tape_code::TextPiece piece = source.next();
    if (piece.status == tape_code::SourceStatus::end) break;
    if (piece.status == tape_code::SourceStatus::failed)
      return fail(ErrorCode::unavailable, "the stored text cannot be read");
    if (piece.status == tape_code::SourceStatus::text) check.append(piece.text);
    source.refill();
  }
  const auto facts = check.finish();
  if (facts) return *facts;
  const feed::ProgramRefusal& refusal = facts.error();
  const std::string text(feed::message(refusal.fault));
  return fail(ErrorCode::refused, fmt::format("line {}, column {}: {}", refusal.line, refusal.column, text),
              {{.pointer = {},
                .line = static_cast<std::uint32_t>(refusal.line),
                .column = static_cast<std::uint32_t>(refusal.column),
                .text = text}});
}

}  // namespace dripfeed::app

// Reading, checking and dropping contents.
#include "store/sql/content_table.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "store/hash/sha256.h"
#include "store/sql/content_writer.h"

namespace dripfeed::sql {
namespace {

using store::Content;
using store::ErrorCode;
using store::kChunkBytes;
using store::Result;

constexpr std::string_view kChunks = "SELECT data FROM content_chunk WHERE content = ? AND n >= ? AND n < ? ORDER BY n";
constexpr std::string_view kUnused =
    "SELECT id FROM content c WHERE sha256 IS NULL OR (NOT EXISTS (SELECT 1 FROM program_revision WHERE sha256 = "
    "c.sha256) "
    "AND NOT EXISTS (SELECT 1 FROM program_revision WHERE places_sha256 = c.sha256) "
    "AND NOT EXISTS (SELECT 1 FROM receipt WHERE sha256 = c.sha256) "
    "AND NOT EXISTS (SELECT 1 FROM attachment WHERE content = c.sha256))";
constexpr std::string_view kDropSome =
    "DELETE FROM content_chunk WHERE content = ? AND n IN "
    "(SELECT n FROM content_chunk WHERE content = ? ORDER BY n LIMIT 64)";

std::string subject_of(std::string_view sha256) { return fmt::format("content/{}", sha256); }

struct Place {
  store::Id id = 0;
  std::uint64_t bytes = 0;
};

Result<Place> place_of(Session& session, std::string_view sha256) {
  Query query(session, "SELECT id, bytes FROM content WHERE sha256 = ?", sha256);
  if (!query.next()) return session.refuse(ErrorCode::not_found);
  return Place{query.number(), query.number()};
}

}  // namespace

Result<std::unique_ptr<store::ContentWriter>> ContentTable::begin() { return std::make_unique<ChunkWriter>(database_); }

Result<Content> ContentTable::put(std::string_view bytes) {
  ChunkWriter writer(database_);
  if (auto taken = writer.append(bytes); !taken) return std::unexpected(taken.error());
  return writer.finish();
}

Result<std::uint64_t> ContentTable::total_bytes() {
  return database_.read("contents", [&](Session& session) -> Result<std::uint64_t> {
    Query query(session, "SELECT CAST(coalesce(sum(bytes), 0) AS BIGINT) FROM content");
    return query.next() ? query.number() : 0;
  });
}

Result<Content> ContentTable::find(std::string_view sha256) {
  return database_.read(subject_of(sha256), [&](Session& session) -> Result<Content> {
    const auto place = place_of(session, sha256);
    if (!place) return std::unexpected(place.error());
    return Content{std::string(sha256), place->bytes};
  });
}

Result<std::size_t> ContentTable::read(std::string_view sha256, std::uint64_t offset, std::span<char> into) {
  return database_.read(subject_of(sha256), [&](Session& session) -> Result<std::size_t> {
    const auto place = place_of(session, sha256);
    if (!place) return std::unexpected(place.error());
    if (offset >= place->bytes || into.empty()) return 0;
    const std::uint64_t wanted = std::min<std::uint64_t>(into.size(), place->bytes - offset);
    Query query(session, kChunks, place->id, offset / kChunkBytes, (offset + wanted + kChunkBytes - 1) / kChunkBytes);
    std::size_t skip = static_cast<std::size_t>(offset % kChunkBytes);  // in the first chunk
    std::size_t done = 0;
    while (done < wanted && query.next()) {
      const auto chunk = query.bytes();
      if (chunk.size() <= skip) break;
      const std::size_t count = std::min(static_cast<std::size_t>(wanted) - done, chunk.size() - skip);
      std::ranges::copy_n(reinterpret_cast<const char*>(chunk.data()) + skip, static_cast<std::ptrdiff_t>(count),
                          into.data() + done);
      done += count;
      skip = 0;
    }
    if (done != wanted) return session.refuse(ErrorCode::corrupt);
    return done;
  });
}

Result<void> ContentTable::verify(std::string_view sha256) {
  hash::Sha256 hash;
  std::vector<char> piece(16 * kChunkBytes);
  std::uint64_t offset = 0;
  while (true) {
    const auto got = read(sha256, offset, piece);
    if (!got) return std::unexpected(got.error());
    if (*got == 0) break;
    hash.add(std::string_view(piece.data(), *got));
    offset += *got;
  }
  if (hash.hex() == sha256) return {};
  return std::unexpected(store::Error{ErrorCode::corrupt, subject_of(sha256)});
}

Result<void> ContentTable::drop_unused() {
  const auto unused = database_.read("content", [&](Session& session) -> Result<std::vector<store::Id>> {
    std::vector<store::Id> found;
    Query query(session, kUnused);
    while (query.next()) found.push_back(query.number());
    return found;
  });
  if (!unused) return std::unexpected(unused.error());
  for (const store::Id content : *unused) {
    if (auto dropped = drop_content(database_, content); !dropped) return dropped;
  }
  return {};
}

Result<void> drop_content(Database& database, store::Id content) {
  while (true) {
    const auto more = database.write("content", [&](Session& session) -> Result<bool> {
      session.run(kDropSome, content, content);
      if (session.changed_rows() > 0) return true;
      session.run("DELETE FROM content WHERE id = ?", content);
      return false;
    });
    if (!more) return std::unexpected(more.error());
    if (!*more) return {};
  }
}

}  // namespace dripfeed::sql

// The first transaction makes the row of the content, without a hash: no one finds it yet. The last one seals it, or
// finds that the same bytes are there already.
#include "store/sql/content_writer.h"

#include <algorithm>

#include "store/sql/content_table.h"

namespace dripfeed::sql {
namespace {

using store::Content;
using store::kChunkBytes;
using store::Result;

constexpr std::size_t kTransactionBytes = 4 * kChunkBytes;  // 256 KiB: the ledger waits for one of these at most

}  // namespace

ChunkWriter::~ChunkWriter() {
  if (content_ != 0) static_cast<void>(drop_content(database_, content_));  // else the next start drops it
}

void ChunkWriter::write_chunks(Session& session, std::string_view bytes, store::Id content, std::uint64_t first) const {
  for (std::uint64_t n = first; !bytes.empty(); ++n) {
    const std::string_view chunk = bytes.substr(0, kChunkBytes);
    session.run("INSERT INTO content_chunk (content, n, data) VALUES (?, ?, ?)", content, n, Bytes{chunk});
    bytes.remove_prefix(chunk.size());
  }
}

Result<void> ChunkWriter::flush() {
  auto written = database_.write("content", [&](Session& session) -> Result<store::Id> {
    store::Id content = content_;
    if (content == 0) {
      session.run("INSERT INTO content (sha256, bytes) VALUES (NULL, 0)");
      content = session.last_id();
    }
    write_chunks(session, waiting_, content, chunks_);
    return content;
  });
  if (!written) return std::unexpected(written.error());
  content_ = *written;
  chunks_ += waiting_.size() / kChunkBytes;
  waiting_.clear();
  return {};
}

Result<void> ChunkWriter::append(std::string_view bytes) {
  hash_.add(bytes);
  bytes_ += bytes.size();
  while (!bytes.empty()) {
    const std::string_view taken = bytes.substr(0, kTransactionBytes - waiting_.size());
    waiting_.append(taken);
    bytes.remove_prefix(taken.size());
    if (waiting_.size() < kTransactionBytes) break;
    if (auto flushed = flush(); !flushed) return flushed;
  }
  return {};
}

Result<Content> ChunkWriter::finish() {
  const Content sealed{hash_.hex(), bytes_};
  const auto known = database_.write("content", [&](Session& session) -> Result<bool> {
    {
      Query same(session, "SELECT 1 FROM content WHERE sha256 = ?", sealed.sha256);
      if (same.next()) return true;
    }
    store::Id content = content_;
    if (content == 0) {
      session.run("INSERT INTO content (sha256, bytes) VALUES (NULL, 0)");
      content = session.last_id();
    }
    write_chunks(session, waiting_, content, chunks_);
    session.run("UPDATE content SET sha256 = ?, bytes = ? WHERE id = ?", sealed.sha256, sealed.bytes, content);
    return false;
  });
  if (!known) return std::unexpected(known.error());
  if (*known && content_ != 0) static_cast<void>(drop_content(database_, content_));
  content_ = 0;
  return sealed;
}

}  // namespace dripfeed::sql

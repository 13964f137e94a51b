// Writes one content: whole chunks in short transactions, sealed with the hash at the end.
#pragma once

#include "store/contents.h"
#include "store/hash/sha256.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class ChunkWriter final : public store::ContentWriter {
 public:
  explicit ChunkWriter(Database& database) : database_(database) {}
  ~ChunkWriter() override;
  store::Result<void> append(std::string_view bytes) override;
  store::Result<store::Content> finish() override;

 private:
  void write_chunks(Session& session, std::string_view bytes, store::Id content, std::uint64_t first) const;
  store::Result<void> flush();

  Database& database_;
  hash::Sha256 hash_;
  std::string waiting_;       // less than kTransactionBytes
  store::Id content_ = 0;     // 0 before the first flush
  std::uint64_t chunks_ = 0;  // written
  std::uint64_t bytes_ = 0;   // appended
};

}  // namespace dripfeed::sql

// Contents in the database, in chunks.
#pragma once

#include "store/contents.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class ContentTable final : public store::Contents {
 public:
  explicit ContentTable(Database& database) : database_(database) {}
  store::Result<std::unique_ptr<store::ContentWriter>> begin() override;
  store::Result<store::Content> put(std::string_view bytes) override;
  store::Result<std::uint64_t> total_bytes() override;
  store::Result<store::Content> find(std::string_view sha256) override;
  store::Result<std::size_t> read(std::string_view sha256, std::uint64_t offset, std::span<char> into) override;
  store::Result<void> verify(std::string_view sha256) override;
  // Drops what a writer left over at a crash, and what nothing refers to. For the one owner of the store, before
  // anything else is done with it.
  store::Result<void> drop_unused();

 private:
  Database& database_;
};

// Drops a content in short transactions, so that others may write meanwhile.
store::Result<void> drop_content(Database& database, store::Id content);

}  // namespace dripfeed::sql

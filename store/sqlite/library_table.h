// The library in its file: entries, two full-text tables (words, and pieces of names), calls.
#pragma once

#include <memory>

#include "store/library.h"
#include "store/sql/database.h"

namespace dripfeed::sqlite {

// The tables; its number stands in the file as PRAGMA user_version.
extern const char* const kLibrarySchema;
inline constexpr std::uint32_t kLibraryVersion = 2;

class LibraryTable final : public store::Library {
 public:
  explicit LibraryTable(std::unique_ptr<sql::Database> database) : database_(std::move(database)) {}
  store::Result<store::LibraryState> state() override;
  store::Result<void> put(const std::vector<store::LibraryEntry>& entries, std::uint64_t reached) override;
  store::Result<void> clear() override;
  store::Result<store::Page<store::LibraryHit>> search(std::string_view words, const store::PageRequest& page,
                                                       bool with_archived) override;
  store::Result<std::vector<store::Caller>> callers_of(store::Id program) override;
  store::Result<store::KnownCalls> calls_of(store::Id program) override;
  store::Result<std::vector<store::Id>> named(std::string_view name) override;

 private:
  std::unique_ptr<sql::Database> database_;
};

}  // namespace dripfeed::sqlite

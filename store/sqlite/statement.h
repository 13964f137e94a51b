// A prepared statement of SQLite.
#pragma once

#include "store/sql/connection.h"

struct sqlite3_stmt;

namespace dripfeed::sqlite {

class Statement final : public sql::Statement {
 public:
  explicit Statement(sqlite3_stmt* statement) : statement_(statement) {}
  ~Statement() override;
  bool bind_text(int parameter, std::string_view text) override;
  bool bind_bytes(int parameter, std::string_view bytes) override;
  bool bind_number(int parameter, std::int64_t number) override;
  bool bind_null(int parameter) override;
  Step step() override;
  std::int64_t number(int column) override;
  std::span<const std::byte> bytes(int column) override;
  void reset() override;

 private:
  sqlite3_stmt* statement_;
};

}  // namespace dripfeed::sqlite

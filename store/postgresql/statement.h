// A statement that the server prepares when it runs first: then it is known what its parameters are.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "store/postgresql/connection.h"

namespace dripfeed::postgresql {

class Statement final : public sql::Statement {
 public:
  // `returns_id`: its one row has the number of the row that it adds, which is no row for the caller.
  Statement(Connection& connection, std::string sql, bool returns_id)
      : connection_(connection), sql_(std::move(sql)), returns_id_(returns_id) {}
  bool bind_text(int parameter, std::string_view text) override;
  bool bind_bytes(int parameter, std::string_view bytes) override;
  bool bind_number(int parameter, std::int64_t number) override;
  bool bind_null(int parameter) override;
  Step step() override;
  std::int64_t number(int column) override;
  std::span<const std::byte> bytes(int column) override;
  void reset() override;

 private:
  // All go in binary form. Its bytes lie in kept_, or with the caller.
  struct Parameter {
    std::uint32_t type = 0;  // 0: the server knows it from where it stands
    std::size_t place = 0;   // in kept_
    std::optional<std::string_view> bytes{};
    std::size_t length = 0;
    bool is_null = true;
  };
  Parameter& at(int parameter);
  void keep(int parameter, std::uint32_t type, std::string_view bytes);
  [[nodiscard]] std::string_view value(int column) const;
  bool prepare();
  bool run();

  Connection& connection_;
  std::string sql_;
  std::string name_;  // empty until it is prepared
  bool returns_id_;
  std::vector<Parameter> parameters_;
  std::string kept_;
  std::vector<const char*> values_;
  std::vector<int> lengths_;
  std::vector<int> formats_;
  ResultPtr result_;
  std::deque<std::string> texts_;  // of the row: those that are not as they came
  int row_ = 0;
};

}  // namespace dripfeed::postgresql

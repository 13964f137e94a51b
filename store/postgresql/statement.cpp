// Binding, running, reading columns. A result comes whole: statements may run while the rows of another one are read,
// and lists have pages.
#include "store/postgresql/statement.h"

#include <array>
#include <limits>

#include <libpq-fe.h>

#include "store/postgresql/texts.h"

namespace dripfeed::postgresql {
namespace {

// Numbers of types, as the server's catalog pg_type has them since ever.
constexpr std::uint32_t kBytea = 17;
constexpr std::uint32_t kInt8 = 20;
constexpr int kBinary = 1;
constexpr std::size_t kNumberBytes = 8;

// The most significant byte first, as on the wire.
std::string_view as_bytes(std::int64_t number, std::span<char, kNumberBytes> into) {
  auto rest = static_cast<std::uint64_t>(number);
  for (std::size_t i = kNumberBytes; i-- > 0; rest >>= 8U) into[i] = static_cast<char>(rest & 0xFFU);
  return {into.data(), into.size()};
}

// A truth value has one byte, numbers have 2, 4 or 8.
std::int64_t as_number(std::span<const std::byte> bytes) {
  if (bytes.empty() || bytes.size() > kNumberBytes) return 0;
  const bool is_negative = bytes.size() > 1 && (bytes.front() & std::byte{0x80}) != std::byte{0};
  std::uint64_t number = is_negative ? std::numeric_limits<std::uint64_t>::max() : 0;
  for (const std::byte byte : bytes) number = (number << 8U) | std::to_integer<std::uint64_t>(byte);
  return static_cast<std::int64_t>(number);
}

}  // namespace

Statement::Parameter& Statement::at(int parameter) {
  const auto index = static_cast<std::size_t>(parameter - 1);
  if (parameters_.size() <= index) parameters_.resize(index + 1);
  return parameters_[index];
}

void Statement::keep(int parameter, std::uint32_t type, std::string_view bytes) {
  at(parameter) = {.type = type, .place = kept_.size(), .length = bytes.size(), .is_null = false};
  kept_ += bytes;
}

bool Statement::bind_text(int parameter, std::string_view text) {
  const std::optional<std::string> other = to_database(text);
  keep(parameter, 0, other ? *other : text);
  return true;
}

bool Statement::bind_bytes(int parameter, std::string_view bytes) {
  const std::string_view there = bytes.data() == nullptr ? std::string_view("") : bytes;
  at(parameter) = {.type = kBytea, .bytes = there, .length = there.size(), .is_null = false};
  return true;
}

bool Statement::bind_number(int parameter, std::int64_t number) {
  std::array<char, kNumberBytes> bytes{};
  keep(parameter, kInt8, as_bytes(number, bytes));
  return true;
}

bool Statement::bind_null(int parameter) {
  at(parameter) = {};
  return true;
}

bool Statement::prepare() {
  std::vector<Oid> types;
  for (const Parameter& one : parameters_) types.push_back(one.type);
  const std::string name = connection_.next_name();
  const ResultPtr prepared = connection_.answer(
      PQsendPrepare(connection_.handle(), name.c_str(), sql_.c_str(), static_cast<int>(types.size()), types.data()));
  if (!connection_.note(prepared.get())) return false;
  name_ = name;
  return true;
}

bool Statement::run() {
  if (name_.empty() && !prepare()) return false;
  values_.clear();
  lengths_.clear();
  for (const Parameter& one : parameters_) {
    const char* const kept = one.bytes ? one.bytes->data() : kept_.c_str() + one.place;
    values_.push_back(one.is_null ? nullptr : kept);
    lengths_.push_back(static_cast<int>(one.length));
  }
  formats_.assign(parameters_.size(), kBinary);
  result_ =
      connection_.answer(PQsendQueryPrepared(connection_.handle(), name_.c_str(), static_cast<int>(parameters_.size()),
                                             values_.data(), lengths_.data(), formats_.data(), kBinary));
  if (!connection_.note(result_.get())) return false;
  connection_.note_changed(result_.get());
  row_ = -1;
  if (!returns_id_) return true;
  row_ = 0;
  if (PQntuples(result_.get()) > 0) connection_.note_id(static_cast<store::Id>(number(0)));
  return true;
}

Statement::Step Statement::step() {
  if (!result_ && !run()) {
    result_.reset();
    return Step::fault;
  }
  if (returns_id_ || row_ + 1 >= PQntuples(result_.get())) return Step::end;
  ++row_;
  texts_.clear();
  return Step::row;
}

std::string_view Statement::value(int column) const {
  return {PQgetvalue(result_.get(), row_, column), static_cast<std::size_t>(PQgetlength(result_.get(), row_, column))};
}

std::int64_t Statement::number(int column) { return as_number(std::as_bytes(std::span(value(column)))); }

std::span<const std::byte> Statement::bytes(int column) {
  std::string_view found = value(column);
  if (PQftype(result_.get(), column) != kBytea) {
    if (auto other = from_database(found)) found = texts_.emplace_back(std::move(*other));
  }
  return std::as_bytes(std::span(found));
}

void Statement::reset() {
  result_.reset();
  texts_.clear();
  parameters_.clear();
  kept_.clear();
}

}  // namespace dripfeed::postgresql

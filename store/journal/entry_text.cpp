// serial at_ms rows { job handed clocked confirmed reserve note } answers { machine state bytes reason actor }
#include "store/journal/entry_text.h"

#include <charconv>
#include <iterator>

#include <fmt/format.h>

namespace dripfeed::journal {
namespace {

void put_text(std::string& into, std::string_view text) {
  fmt::format_to(std::back_inserter(into), "{}:{} ", text.size(), text);
}

// Takes one field after the other; the first that is not there sticks.
class Reader {
 public:
  explicit Reader(std::string_view left) : left_(left) {}

  template <class Number>
  Number number(char end = ' ') {
    Number value = 0;
    const auto [at, error] = std::from_chars(left_.data(), left_.data() + left_.size(), value);
    const auto count = static_cast<std::size_t>(at - left_.data());
    if (error != std::errc() || count >= left_.size() || *at != end) return fail<Number>();
    left_.remove_prefix(count + 1);
    return value;
  }

  std::string text() {
    const auto length = number<std::size_t>(':');
    if (left_.size() <= length || left_[length] != ' ') return fail<std::string>();
    std::string text(left_.substr(0, length));
    left_.remove_prefix(length + 1);
    return text;
  }

  [[nodiscard]] bool is_whole() const { return ok_ && left_.empty(); }
  [[nodiscard]] bool ok() const { return ok_; }

 private:
  template <class Value>
  Value fail() {
    ok_ = false;
    left_ = {};
    return {};
  }

  std::string_view left_;
  bool ok_ = true;
};

store::NewLedgerRow read_row(Reader& from) {
  store::NewLedgerRow row;
  row.job = from.number<store::Id>();
  for (std::uint64_t* const count :
       {&row.counts.handed, &row.counts.clocked, &row.counts.confirmed, &row.counts.reserve})
    *count = from.number<std::uint64_t>();
  row.note = from.text();
  return row;
}

std::optional<AnswerStep> read_answer(Reader& from) {
  AnswerStep step;
  step.machine = from.text();
  const auto state = store::named<store::AnswerState>(from.text());
  step.bytes_total = from.number<std::uint64_t>();
  step.reason = from.text();
  step.actor = from.text();
  if (!state) return std::nullopt;
  step.to = *state;
  return step;
}

}  // namespace

std::string text_of(const Entry& entry) {
  std::string text = fmt::format("{} {} {} ", entry.serial, entry.at_ms, entry.rows.size());
  for (const store::NewLedgerRow& row : entry.rows) {
    const store::LedgerCounts& counts = row.counts;
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} ", row.job, counts.handed, counts.clocked,
                   counts.confirmed, counts.reserve);
    put_text(text, row.note);
  }
  fmt::format_to(std::back_inserter(text), "{} ", entry.answer ? 1 : 0);
  if (!entry.answer) return text;
  put_text(text, entry.answer->machine);
  put_text(text, store::name_of(entry.answer->to));
  fmt::format_to(std::back_inserter(text), "{} ", entry.answer->bytes_total);
  put_text(text, entry.answer->reason);
  put_text(text, entry.answer->actor);
  return text;
}

std::optional<Entry> entry_of(std::string_view text) {
  Reader from(text);
  Entry entry;
  entry.serial = from.number<std::uint64_t>();
  entry.at_ms = from.number<std::int64_t>();
  const auto rows = from.number<std::size_t>();
  for (std::size_t i = 0; i < rows && from.ok(); ++i) entry.rows.push_back(read_row(from));
  if (from.number<int>() == 1) {
    entry.answer = read_answer(from);
    if (!entry.answer) return std::nullopt;
  }
  if (!from.is_whole()) return std::nullopt;
  return entry;
}

}  // namespace dripfeed::journal

// A cell is what stands between separators, without blanks around it.
#include "dialects/compile/render/list_table.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/bind.h"
#include "dialects/family/read.h"

namespace dripfeed::compile {

namespace {

using text::DiagnosticId;

constexpr std::string_view kBlanks = " \t\r";

class Table {
 public:
  explicit Table(const text::Source& source) : text_(source.text()) {
    separator_ = text_.contains(';') ? ';' : text_.contains('\t') ? '\t' : ',';
    std::size_t begin = text_.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    while (begin < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      if (const text::Span line = trimmed(begin, end); !line.empty() && text_[line.begin] != '#') add(line);
      begin = end + 1;
    }
  }

  [[nodiscard]] const std::vector<std::vector<text::Span>>& lines() const { return lines_; }
  [[nodiscard]] std::string_view at(text::Span cell) const { return cell.in(text_); }
  // Whether the first line names the columns.
  [[nodiscard]] bool has_names() const {
    return !lines_.empty() && std::ranges::any_of(lines_.front(), [&](text::Span cell) {
      const std::string_view name = at(cell);
      return !name.empty() &&
             ((name.front() >= 'a' && name.front() <= 'z') || (name.front() >= 'A' && name.front() <= 'Z'));
    });
  }

 private:
  [[nodiscard]] text::Span trimmed(std::size_t begin, std::size_t end) const {
    while (begin < end && kBlanks.contains(text_[begin])) ++begin;
    while (end > begin && kBlanks.contains(text_[end - 1])) --end;
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  }

  void add(text::Span line) {
    std::vector<text::Span> cells;
    for (std::size_t begin = line.begin;; ++begin) {
      const std::size_t end = std::min<std::size_t>(text_.find(separator_, begin), line.end);
      cells.push_back(trimmed(begin, end));
      begin = end;
      if (end >= line.end) break;
    }
    lines_.push_back(std::move(cells));
  }

  std::string_view text_;
  char separator_;
  std::vector<std::vector<text::Span>> lines_;
};

class ColumnReader {
 public:
  ColumnReader(const Table& table, const family::Parameter& parameter) : table_(table), parameter_(parameter) {}

  // Those that read() took.
  [[nodiscard]] const std::vector<std::string>& cells() const { return cells_; }

  TableColumn read(std::string_view name) {
    const std::optional<std::size_t> column = find(name);
    if (!column) return std::move(out_);
    for (std::size_t i = table_.has_names() ? 1 : 0; i < table_.lines().size(); ++i) take(table_.lines()[i], *column);
    if (out_.value.empty() && out_.diagnostics.empty())
      fault({}, fmt::format("{}: the table has no numbers", parameter_.name));
    return std::move(out_);
  }

 private:
  std::optional<std::size_t> find(std::string_view name) {
    if (table_.lines().empty()) return fault({}, "the table is empty");
    const std::vector<text::Span>& first = table_.lines().front();
    const std::string_view wanted = name.empty() ? std::string_view(parameter_.name) : name;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < first.size() && table_.has_names(); ++i) {
      const std::string_view head = table_.at(first[i]);
      const std::string_view own = head.substr(0, head.find_first_of(" \t["));
      names.emplace_back(own);
      if (own == wanted || (name.empty() && first.size() == 1))
        return unit_of(first[i], head.substr(own.size())) ? std::optional(i) : std::nullopt;
    }
    if (!table_.has_names() && name.empty() && first.size() == 1) return 0;
    const text::Span line{first.front().begin, first.back().end};
    if (!table_.has_names()) return fault(line, "the first line names no columns, such as x mm, y mm");
    return fault(line, fmt::format("no column is called {}: there are {}", wanted, fmt::join(names, ", ")));
  }

  // "mm", "[mm]"
  bool unit_of(text::Span cell, std::string_view written) {
    const auto is_edge = [](char c) { return c == ' ' || c == '\t' || c == '[' || c == ']'; };
    while (!written.empty() && is_edge(written.front())) written.remove_prefix(1);
    while (!written.empty() && is_edge(written.back())) written.remove_suffix(1);
    unit_ = written;
    if (unit_.empty() || family::find_unit(unit_) != nullptr) return true;
    fault(cell, fmt::format("'{}' is no unit", unit_));
    return false;
  }

  void take(const std::vector<text::Span>& line, std::size_t column) {
    if (column >= line.size() || line[column].empty()) {
      const text::Span whole{line.front().begin, line.back().end};
      fault(column < line.size() ? line[column] : whole,
            fmt::format("{}: this line has no number in column {}", parameter_.name, column + 1));
      return;
    }
    std::string written(table_.at(line[column]));
    const std::optional<family::Quantity> quantity = family::parse_quantity(written);
    if (quantity && quantity->unit == nullptr && !unit_.empty()) written += fmt::format(" {}", unit_);
    if (auto found = family::read_value(parameter_, written).fault)
      out_.diagnostics.push_back(text::make_diagnostic(found->id, line[column], std::move(found->arguments)));
    out_.value += fmt::format("{}{}", out_.value.empty() ? "" : ", ", written);
    cells_.push_back(std::move(written));
  }

  std::nullopt_t fault(text::Span span, std::string sentence) {
    out_.diagnostics.push_back(text::make_diagnostic(DiagnosticId::family_syntax, span, {std::move(sentence)}));
    return std::nullopt;
  }

  const Table& table_;
  const family::Parameter& parameter_;
  std::string_view unit_;
  std::vector<std::string> cells_;
  TableColumn out_;
};

// One column an axis, row by row.
TableColumn points_of(const Table& table, const family::Family& family, const family::PointParameter& points) {
  TableColumn out;
  std::vector<std::vector<std::string>> columns;
  for (std::size_t i = 0; i < points.axes.size(); ++i) {
    ColumnReader reader(table, family.parameters[points.first + i]);
    TableColumn read = reader.read(points.axes.substr(i, 1));
    out.diagnostics.insert(out.diagnostics.end(), read.diagnostics.begin(), read.diagnostics.end());
    columns.push_back(reader.cells());
  }
  if (text::has_error(out.diagnostics)) return out;
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    out.value += row == 0 ? "(" : ", (";
    for (std::size_t i = 0; i < columns.size(); ++i) out.value += (i == 0 ? "" : ", ") + columns[i][row];
    out.value += ')';
  }
  return out;
}

}  // namespace

TableColumn list_of_column(const text::Source& table, std::string_view column, const text::Source& family,
                           std::string_view parameter) {
  const family::ReadFamilyResult read = family::read_family(family);
  const family::PointParameter* points = read.family.find_points(parameter);
  if (points != nullptr && column.empty()) return points_of(Table(table), read.family, *points);
  const family::Parameter* found = read.family.find_parameter(parameter);
  if (found == nullptr || found->kind != family::ParameterKind::list) return {};
  const Table cells(table);
  return ColumnReader(cells, *found).read(column);
}

}  // namespace dripfeed::compile

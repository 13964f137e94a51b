// A variable that got its last value before the first block is a constant; the others are columns.
#include "dialects/compile/plain/index_places.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "dialects/compile/dialect/printed_lines.h"

namespace dripfeed::compile {

namespace {

constexpr std::uint32_t kNoColumn = std::numeric_limits<std::uint32_t>::max();
constexpr double kNotSet = std::numeric_limits<double>::quiet_NaN();

class Indexer {
 public:
  Indexer(const ir::PrintResult& printed, const ExplicitProgram& made, const std::set<std::string>& own_names)
      : printed_(printed), made_(made), columns_(made.variable_names.size(), kNoColumn) {
    find_columns(own_names);
  }

  PlaceIndex index() {
    for_each_line(printed_.text, [this](const PrintedLine& line) {
      if (is_block(line.text)) add(line);
    });
    return std::move(out_);
  }

 private:
  void find_columns(const std::set<std::string>& own_names) {
    const std::uint64_t first = made_.origins.empty() ? 0 : made_.origins.front().ordinal;
    std::vector<double> last(made_.variable_names.size(), kNotSet);
    std::vector<bool> varies(made_.variable_names.size(), false);
    for (const LoggedChange& logged : made_.changes) {
      last[logged.change.variable] = logged.change.value;
      if (logged.ordinal > first) varies[logged.change.variable] = true;
    }
    for (std::size_t i = 0; i < made_.variable_names.size(); ++i) {
      const std::string& name = made_.variable_names[i];
      if (!own_names.contains(name)) continue;
      if (varies[i]) {
        columns_[i] = static_cast<std::uint32_t>(out_.names.size());
        out_.names.push_back(name);
      } else {
        out_.constants.emplace_back(name, last[i]);
      }
    }
    row_.assign(out_.names.size(), kNotSet);
  }

  void add(const PrintedLine& line) {
    PlaceEntry entry{.offset = line.offset, .line = line.number, .origin = 0};
    const std::uint32_t block =
        line.number <= printed_.origin_lines.size() ? printed_.origin_lines[line.number - 1] : 0;
    if (block != 0 && block <= made_.origins.size()) {
      const BlockOrigin origin = made_.origins[block - 1];
      entry.origin = origin.line;
      change_until(origin.ordinal);
    }
    out_.entries.push_back(entry);
    out_.values.insert(out_.values.end(), row_.begin(), row_.end());
  }

  // Lines are printed in the order of execution, so the row only goes forward.
  void change_until(std::uint64_t ordinal) {
    for (; next_ < made_.changes.size() && made_.changes[next_].ordinal <= ordinal; ++next_) {
      const interpreter::VariableChange& change = made_.changes[next_].change;
      if (columns_[change.variable] != kNoColumn) row_[columns_[change.variable]] = change.value;
    }
  }

  const ir::PrintResult& printed_;
  const ExplicitProgram& made_;
  std::vector<std::uint32_t> columns_;  // by variable
  std::vector<double> row_;
  std::size_t next_ = 0;
  PlaceIndex out_;
};

}  // namespace

PlaceIndex index_places(const ir::PrintResult& printed, const ExplicitProgram& made,
                        const std::set<std::string>& own_names) {
  return Indexer(printed, made, own_names).index();
}

}  // namespace dripfeed::compile

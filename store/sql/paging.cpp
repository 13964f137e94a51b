// Limits and cursors.
#include "store/sql/paging.h"

#include <charconv>
#include <limits>

#include <fmt/format.h>

namespace dripfeed::sql {
namespace {

using store::Error;
using store::ErrorCode;

store::Result<IdPage> id_page(const store::PageRequest& page, std::uint64_t first) {
  const auto rows = rows_of(page);
  if (!rows) return std::unexpected(rows.error());
  IdPage found{.after = first, .rows = *rows};
  if (page.after.empty()) return found;
  const char* const end = page.after.data() + page.after.size();
  const auto [stop, fault] = std::from_chars(page.after.data(), end, found.after);
  if (fault != std::errc() || stop != end) {
    return std::unexpected(Error{ErrorCode::invalid_value, fmt::format("no cursor of this list: {}", page.after)});
  }
  return found;
}

}  // namespace

store::Result<std::uint32_t> rows_of(const store::PageRequest& page) {
  if (page.limit >= 1 && page.limit <= store::kPageLimitMax) return page.limit + 1;
  return std::unexpected(Error{ErrorCode::invalid_value,
                               fmt::format("a page has 1 to {} rows, not {}", store::kPageLimitMax, page.limit)});
}

store::Result<IdPage> newest_first(const store::PageRequest& page) {
  return id_page(page, static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()));
}

store::Result<IdPage> oldest_first(const store::PageRequest& page) { return id_page(page, 0); }

}  // namespace dripfeed::sql

// Pages of a list: one row more than asked for shows whether there is a next page.
#pragma once

#include <type_traits>

#include "store/sql/session.h"

namespace dripfeed::sql {

// Where a page of rows ordered by id begins, and how many rows to ask for.
struct IdPage {
  std::uint64_t after = 0;
  std::uint32_t rows = 0;
};

store::Result<std::uint32_t> rows_of(const store::PageRequest& page);
// Newest first: `after` is larger than every id on the first page.
store::Result<IdPage> newest_first(const store::PageRequest& page);
store::Result<IdPage> oldest_first(const store::PageRequest& page);

// Reads the rows of a query; key(item) is the cursor after an item.
template <class Read, class Key>
auto collect(Query& query, const store::PageRequest& page, Read read, Key key)
    -> store::Page<std::invoke_result_t<Read, Query&>> {
  store::Page<std::invoke_result_t<Read, Query&>> found;
  while (query.next()) {
    if (found.items.size() == page.limit) {
      found.next = key(found.items.back());
      break;
    }
    found.items.push_back(read(query));
  }
  return found;
}

}  // namespace dripfeed::sql

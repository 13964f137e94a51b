// A page of rows as an answer, for every list of the API.
#pragma once

#include <string>
#include <vector>

#include "server/http/api.h"
#include "server/json/records.h"

namespace dripfeed::http {

// `write` gives the JSON text of one row.
template <class Row, class Write>
Response list_response(const store::Result<store::Page<Row>>& page, const Write& write) {
  if (!page) return problem_response(app::from_store(page.error()));
  std::vector<std::string> items;
  items.reserve(page->items.size());
  for (const Row& row : page->items) items.push_back(write(row));
  return json_response(200, json::list(items, page->next));
}

}  // namespace dripfeed::http

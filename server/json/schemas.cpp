// The tables, in the order of the API's things.
#include "server/json/schemas.h"

#include <iterator>
#include <utility>

#include "server/json/glossary.h"
#include "server/json/orders.h"
#include "server/json/people.h"
#include "server/json/profile_document.h"
#include "server/json/requests.h"

namespace dripfeed::json {

namespace {

// What requests and profiles say: their shape is their readers', their words are the glossary's.
Schemas read_schemas() {
  Schemas all = request_schemas();
  for (NamedSchema& one : people_request_schemas()) all.push_back(std::move(one));
  for (NamedSchema& one : job_request_schemas()) all.push_back(std::move(one));
  for (NamedSchema& one : order_request_schemas()) all.push_back(std::move(one));
  all.push_back({"Profile", profile_schema()});
  for (NamedSchema& one : all) explain(one);
  return all;
}

}  // namespace

Schemas all_schemas() {
  using Table = Schemas (*)();
  static constexpr Table kTables[] = {site_schemas,    read_schemas,        machine_schemas, catalog_schemas,
                                      program_schemas, check_schemas,       compare_schemas, library_schemas,
                                      editing_schemas, path_schemas,        measure_schemas, job_schemas,
                                      history_schemas, stop_reason_schemas, receipt_schemas, people_schemas,
                                      store_schemas,   webhook_schemas,     order_schemas};
  Schemas all;
  for (const Table table : kTables) {
    Schemas some = table();
    all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  }
  return all;
}

}  // namespace dripfeed::json

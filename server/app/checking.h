// Checking a stored program for a stored machine: examine it, store the verdict, tell who watches.
#pragma once

#include <string>
#include <string_view>

#include "server/app/catalog.h"
#include "server/app/documents.h"
#include "server/app/error.h"
#include "server/app/events.h"
#include "server/app/examine.h"
#include "store/store.h"

namespace dripfeed::app {

struct CheckOrder {
  store::Id program = 0;
  store::Revision revision = 0;  // 0: the newest
  std::string machine;
  store::Delivery delivery = store::Delivery::drip;
};

class Checking {
 public:
  // Longest text that is checked whole.
  static constexpr std::uint64_t kTextLimit = std::uint64_t{256} << 20U;

  Checking(store::Store& store, Catalog& catalog, Events& events, const Clock& clock, const Documents& documents);
  // Errors: not_found, invalid.
  Result<store::Verdict> check(const CheckOrder& order, std::string_view actor);

 private:
  Result<void> add_geometry(const store::ProgramRevision& revision, Examination& examination);

  store::Store& store_;
  Catalog& catalog_;
  Events& events_;
  const Clock& clock_;
  const Documents& documents_;
};

}  // namespace dripfeed::app

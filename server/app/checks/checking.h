// Checking a stored program for a stored machine: examine it, store the verdict, inform who watches.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/documents.h"
#include "server/app/base/error.h"
#include "server/app/checks/examine.h"
#include "server/app/checks/workers.h"
#include "server/app/out/events.h"
#include "server/app/shop/catalog.h"
#include "store/store.h"

namespace dripfeed::app {

// Stock, nominal and tools of a family with these values, for a text that was not rendered from one.
struct NominalOrder {
  std::string family;
  Values values;
};

struct CheckOrder {
  store::Id program = 0;
  store::Revision revision = 0;  // 0: the newest
  std::string machine;
  store::Delivery delivery = store::Delivery::drip;
  std::optional<NominalOrder> nominal = {};
  std::vector<family::LineRange> profile_lines = {};  // with a nominal: the lines that make it; empty: every cut
};

// A stored program and machine, with what is to be done: what the order names, read from the store.
struct StoredCase {
  store::Program program;
  store::ProgramRevision revision;
  store::Machine machine;
  CaseOrder order;
};
// Errors: not_found; invalid: another dialect than the machine's, or a nominal for a text that has its own.
Result<StoredCase> load_case(store::Store& store, const Documents& documents, const CheckOrder& order);

// "12-60,70-71", as commands and requests name lines; nothing where it is none.
std::optional<std::vector<family::LineRange>> read_line_ranges(std::string_view text);

class Checking {
 public:
  // Without `workers` it is done here.
  Checking(store::Store& store, Events& events, const Clock& clock, const Documents& documents,
           Workers* workers = nullptr);
  // Errors: as load_case and Workers::check.
  Result<store::Verdict> check(const CheckOrder& order, std::string_view actor, const Waiter& waiter = {});

 private:
  store::Store& store_;
  Events& events_;
  const Clock& clock_;
  const Documents& documents_;
  Workers* workers_;
};

}  // namespace dripfeed::app

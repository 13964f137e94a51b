// A text while a person writes it: what its reader and the validator find in it, and what it consists of. Nothing is
// run and nothing is stored; whether the program may go to a machine is a check's to say.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/outline.h"
#include "server/app/base/documents.h"
#include "server/app/base/error.h"
#include "server/app/checks/examine.h"
#include "server/app/checks/workers.h"
#include "store/store.h"

namespace dripfeed::app {

struct DiagnoseOrder {
  std::string dialect;  // empty: the machine's, or the one that the text looks like
  std::string text;
  std::string profile = {};  // the machine's document; empty: the control that the text looks like
  store::Delivery delivery = store::Delivery::memory;
  std::optional<NominalCase> nominal = {};
  std::vector<family::LineRange> profile_lines = {};  // that make the nominal; empty: every cut
  std::string stock = {};                             // as read_stock has it; empty: the nominal's
};

struct Diagnosed {
  CheckReport report;  // of reading and validating alone
  compile::Outline outline;
};

// What is examined of it. Errors: invalid: a dialect that is not known, or another one than the machine's,
// or a nominal that does not bind.
Result<std::unique_ptr<OpenCase>> open_text(const DiagnoseOrder& order, const Documents& documents);

// Errors: as open_text.
Result<Diagnosed> diagnose_text(const DiagnoseOrder& order, const Documents& documents);

}  // namespace dripfeed::app

// Machines: a name and a profile, whose document the store does not read. All revisions of a profile are kept, because
// verdicts name the one that they were made for.
#pragma once

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

// One revision of a machine.
struct Machine {
  std::string name;
  Revision revision = 0;
  std::string profile;
  std::string changed_by;
  std::int64_t changed_at_ms = 0;
};

class Machines : public Repository {
 public:
  // Revision 1. Errors: exists, invalid_value (empty name).
  virtual Result<Machine> add(std::string_view name, std::string_view profile, const Stamp& by) = 0;
  // The next revision; the machine's verdicts become stale. Errors: not_found, stale_revision (the newest is not
  // `expected`).
  virtual Result<Machine> change(std::string_view name, Revision expected, std::string_view profile,
                                 const Stamp& by) = 0;
  // The newest revision. Errors: not_found.
  virtual Result<Machine> get(std::string_view name) = 0;
  virtual Result<Machine> get(std::string_view name, Revision revision) = 0;
  // The newest revisions, by name.
  virtual Result<Page<Machine>> list(const PageRequest& page) = 0;
};

}  // namespace dripfeed::store

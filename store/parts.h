// Parts: a number, the family (and its revision) that the values were made for, and the values as a document that the
// store does not read. Revisions never change.
#pragma once

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

struct PartValues {
  std::string family{};
  Revision family_revision = 0;
  std::string values{};
};

// One revision of a part.
struct Part {
  std::string number;
  Revision revision = 0;
  PartValues made_of;
  std::string changed_by;
  std::int64_t changed_at_ms = 0;
};

class Parts : public Repository {
 public:
  // Revision 1. Errors: exists, broken_reference (no such family revision), invalid_value (empty number).
  virtual Result<Part> add(std::string_view number, const PartValues& values, const Stamp& by) = 0;
  // The next revision. Errors: not_found, stale_revision, broken_reference.
  virtual Result<Part> change(std::string_view number, Revision expected, const PartValues& values,
                              const Stamp& by) = 0;
  // The newest revision. Errors: not_found.
  virtual Result<Part> get(std::string_view number) = 0;
  virtual Result<Part> get(std::string_view number, Revision revision) = 0;
  // The newest revisions, by number; of one family when `family` is not empty.
  virtual Result<Page<Part>> list(const PageRequest& page, std::string_view family = {}) = 0;
  // All revisions of one, newest first.
  virtual Result<Page<Part>> revisions(std::string_view number, const PageRequest& page) = 0;
};

}  // namespace dripfeed::store

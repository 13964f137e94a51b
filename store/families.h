// Part families: a name and the text of the family, in revisions that never change.
#pragma once

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

// One revision of a family.
struct Family {
  std::string name;
  Revision revision = 0;
  std::string text;
  std::string changed_by;
  std::int64_t changed_at_ms = 0;
};

class Families : public Repository {
 public:
  // Revision 1. Errors: exists, invalid_value (empty name).
  virtual Result<Family> add(std::string_view name, std::string_view text, const Stamp& by) = 0;
  // The next revision; verdicts of texts that were rendered from this family become stale. Errors: not_found,
  // stale_revision.
  virtual Result<Family> change(std::string_view name, Revision expected, std::string_view text, const Stamp& by) = 0;
  // The newest revision. Errors: not_found.
  virtual Result<Family> get(std::string_view name) = 0;
  virtual Result<Family> get(std::string_view name, Revision revision) = 0;
  // The newest revisions, by name.
  virtual Result<Page<Family>> list(const PageRequest& page) = 0;
  // All revisions of one, newest first.
  virtual Result<Page<Family>> revisions(std::string_view name, const PageRequest& page) = 0;
};

}  // namespace dripfeed::store

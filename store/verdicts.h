// Verdicts: what the checks said of one text for one revision of a machine and one way of delivery. The report is a
// document that the store does not read. Waivers are added by people and never taken back.
#pragma once

#include <optional>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

enum class Outcome : std::uint8_t { pass, warn, fail, unknown };
template <>
inline constexpr std::array<std::string_view, 4> kNames<Outcome>{"pass", "warn", "fail", "unknown"};

struct Waiver {
  std::string name;  // of the person
  std::string reason;
  std::int64_t at_ms = 0;
};

// A program of the library that the text was run with, in place of the one that the control holds.
struct VerdictCall {
  std::string name{};  // by which it is called
  Id program = 0;
  Revision revision = 0;
};

struct NewVerdict {
  Id program = 0;
  Revision revision = 0;
  std::string machine{};
  Revision machine_revision = 0;
  Delivery delivery = Delivery::drip;
  Outcome outcome = Outcome::unknown;
  std::string report{};
  std::vector<VerdictCall> calls{};
};

struct Verdict {
  Id id = 0;
  NewVerdict of;
  std::string text_sha256;  // of the program revision
  bool stale = false;       // the machine or the family of the text has a newer revision than when it was made
  std::string created_by;
  std::int64_t created_at_ms = 0;
  std::vector<Waiver> waivers;
};

// Whether a verdict lets its text be released: pass does, warn and unknown do when a person waived them with a reason,
// fail never does.
bool clears(const Verdict& verdict);

struct VerdictFilter {
  Id program = 0;         // 0: all
  std::string machine{};  // empty: all
};

class Verdicts : public Repository {
 public:
  // A verdict for an older machine revision than the newest is stale from the start. Errors: broken_reference.
  virtual Result<Verdict> add(const NewVerdict& verdict, const Stamp& by) = 0;
  // Errors: not_found, invalid_value (no reason, no name), four_eyes (who wrote the text, where the machine's group
  // wants another person).
  virtual Result<Verdict> waive(Id verdict, std::string_view reason, const Stamp& by) = 0;
  // Errors: not_found.
  virtual Result<Verdict> get(Id verdict) = 0;
  // The newest one of a text, by hash: a text is judged the same under any name.
  virtual Result<std::optional<Verdict>> newest(std::string_view text_sha256, std::string_view machine,
                                                Delivery delivery) = 0;
  // Newest first.
  virtual Result<Page<Verdict>> list(const PageRequest& page, const VerdictFilter& filter = {}) = 0;
};

}  // namespace dripfeed::store

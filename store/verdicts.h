// Verdicts: what the checks said of one text for one revision of a machine and one delivery. The report is a
// document that the store does not read. Waivers are added by people and never taken back; one with a date ends by
// itself.
#pragma once

#include <optional>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

enum class Outcome : std::uint8_t { pass, warn, fail, unknown };
template <>
inline constexpr std::array<std::string_view, 4> kNames<Outcome>{"pass", "warn", "fail", "unknown"};

// A person answers for a verdict, or for one point of it.
struct NewWaiver {
  std::string reason;
  std::string point = {};          // one of NewVerdict::points; empty: for all of it
  std::int64_t expires_at_ms = 0;  // from then on it no longer counts; 0: it does not end
};
struct Waiver {
  std::string name;  // of the person
  std::string reason;
  std::int64_t at_ms = 0;
  std::string point = {};
  std::int64_t expires_at_ms = 0;
};
constexpr bool counts_at(const Waiver& waiver, std::int64_t now_ms) {
  return waiver.expires_at_ms == 0 || now_ms < waiver.expires_at_ms;
}

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
  // What stands between it and a pass, each as a text of its own: all causes of the outcome, or none at all where they
  // are not known one by one.
  std::vector<std::string> points{};
};

struct Verdict {
  Id id = 0;
  NewVerdict of;
  std::string text_sha256;  // of the program revision
  std::string rules{};      // the revision of the code that judged; "" where that is not known
  // The machine, the family of the text or a called program has a newer revision than when it was made, or it was
  // judged by other rules than this program's (Verdicts::judge_by).
  bool stale = false;
  std::string created_by;
  std::int64_t created_at_ms = 0;
  std::vector<Waiver> waivers;
};

// Whether a verdict lets its text be released: pass does, warn and unknown do when people waived it as a whole, or each
// of its points, with reasons; fail never does. A waiver that has ended does not count.
bool clears(const Verdict& verdict, std::int64_t now_ms);
// Why it does not: "warn", "warn, and a waiver of anna has ended".
std::string why_not_clear(const Verdict& verdict, std::int64_t now_ms);

struct VerdictFilter {
  Id program = 0;         // 0: all
  std::string machine{};  // empty: all
};

class Verdicts : public Repository {
 public:
  // The revision of the code that judges: from here on verdicts are made by it, and those by another are stale. Without
  // this call none is stale for that. Before any other call.
  virtual void judge_by(std::string rules) = 0;
  // A verdict for an older machine revision than the newest is stale from the start. Errors: broken_reference.
  virtual Result<Verdict> add(const NewVerdict& verdict, const Stamp& by) = 0;
  // Errors: not_found, invalid_value (no reason, no name, a point that it does not have, an end that is over),
  // four_eyes (who wrote the text, where the machine's group wants another person).
  virtual Result<Verdict> waive(Id verdict, const NewWaiver& waiver, const Stamp& by) = 0;
  // Errors: not_found.
  virtual Result<Verdict> get(Id verdict) = 0;
  // The newest one of a text, by hash: a text is judged the same under any name.
  virtual Result<std::optional<Verdict>> newest(std::string_view text_sha256, std::string_view machine,
                                                Delivery delivery) = 0;
  // Newest first.
  virtual Result<Page<Verdict>> list(const PageRequest& page, const VerdictFilter& filter = {}) = 0;
};

}  // namespace dripfeed::store

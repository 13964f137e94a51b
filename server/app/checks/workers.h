// What is done with other people's programs on behalf of the server, as data in and data out: nothing refers to the
// store, so that it can be carried out in another process.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dialects/compile/dialect/program_digest.h"
#include "dialects/compile/render/render.h"
#include "server/app/base/check_budget.h"
#include "server/app/base/documents.h"
#include "server/app/base/error.h"
#include "server/app/checks/examine.h"
#include "server/app/ports/workplace.h"
#include "server/app/shop/called_programs.h"
#include "store/store.h"

namespace dripfeed::app {

// The family that a program is compared with.
struct NominalCase {
  std::string family;
  store::Revision revision = 0;
  std::string text;
  Values values;
  bool is_from_request = false;  // by who asks; otherwise the program was rendered from it
};

// A program and the machine that it is for.
struct CaseOrder {
  std::string machine = {};  // its name
  std::string folder = {};   // of the program in the library
  std::string name;
  std::string dialect;
  std::string text;
  std::string profile;  // the machine's document
  store::Delivery delivery = store::Delivery::drip;
  std::optional<NominalCase> nominal;
  std::vector<family::LineRange> profile_lines;  // that make the nominal; empty: every cut
};

ir::Delivery delivery_of(store::Delivery delivery);

struct OpenCase {
  machine::Profile profile;
  Examination examination;  // refers to the profile
};
// Errors: invalid: a profile without a control, a nominal that does not bind.
Result<std::unique_ptr<OpenCase>> open_case(CaseOrder order, const Documents& documents, CalledBy& called);

// Stock, nominal and tools of the family. Errors: invalid: values that do not bind, of a nominal that is stated.
Result<void> take_geometry(const NominalCase& nominal, Examination& e);

struct CheckDone {
  store::Outcome outcome = store::Outcome::unknown;
  std::string report;                    // as Documents::write_report has it
  std::vector<CalledText> called = {};   // that it was run with
  std::vector<std::string> points = {};  // as points_of gives them
};
Result<CheckDone> check_case(CaseOrder order, const Documents& documents, const CheckBudget& budget, CalledBy& called);

struct RenderWork {
  std::string family;  // its name
  std::string text;    // and what it says
  Values values;
  std::string profile;  // the machine's document
  compile::RenderMode mode = compile::RenderMode::automatic;
  store::Delivery delivery = store::Delivery::drip;
  std::string name;                       // of the program; empty: the renderer's
  std::vector<std::string> heading = {};  // for people at the control: "revision 3", "part 4711"
  bool optimize = false;                  // a macro is made faster for the machine's control
};
struct RenderDone {
  compile::RenderResult result;  // but for geometry and places
  std::string places;            // as it is stored; empty: there are none
  std::string drawing = {};      // as Documents::write_drawing has it
};
// Errors: invalid: the family, the values or the machine.
Result<RenderDone> render_family(const RenderWork& work, const Documents& documents);

// A text whose names, words and calls are wanted.
struct DigestOrder {
  std::string name;
  std::string dialect;
  std::string text;
  bool is_whole = true;  // false: it is the beginning of a longer one
};
using compile::ProgramDigest;
// One for each, in their order.
Result<std::vector<ProgramDigest>> digest_programs(const std::vector<DigestOrder>& orders);
// Of a text that its reader did not come through with: its words as they stand.
ProgramDigest undigested(const DigestOrder& order, std::string why);

class Workers {
 public:
  Workers() = default;
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  virtual ~Workers() = default;
  // Errors: as the functions above; unavailable: as many wait as may; refused: a budget is used up; internal: it ended
  // abnormally.
  virtual Result<CheckDone> check(const CaseOrder& order, const Waiter& waiter) = 0;
  virtual Result<RenderDone> render(const RenderWork& work, const Waiter& waiter) = 0;
  virtual Result<std::vector<ProgramDigest>> digest(const std::vector<DigestOrder>& orders, const Waiter& waiter) = 0;
};

}  // namespace dripfeed::app

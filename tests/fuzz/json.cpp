// The readers of everything that comes in as JSON: the machine profile and the bodies of requests.
#include "server/json/orders.h"
#include "server/json/people.h"
#include "server/json/profile_document.h"
#include "server/json/requests.h"
#include "tests/fuzz/target.h"

using namespace dripfeed;

namespace {

// A refusal names what is wrong.
template <class T>
void require_reported(const app::Result<T>& read) {
  if (read) return;
  fuzz::require(!read.error().text.empty(), "a refusal has a sentence");
  for (const app::ErrorPlace& place : read.error().places) {
    fuzz::require(!place.text.empty(), "a fault in a document has a sentence");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view body = fuzz::text_of(data, size);
  require_reported(json::read_profile(body));
  require_reported(json::read_text_body(body));
  require_reported(json::read_program_body(body));
  require_reported(json::read_part_body(body, true));
  require_reported(json::read_part_body(body, false));
  require_reported(json::read_render_body(body));
  require_reported(json::read_check_body(body));
  require_reported(json::read_measure_body(body, json::Measure::accuracy));
  require_reported(json::read_sweep_body(body));
  require_reported(json::read_release_body(body));
  require_reported(json::read_reason_body(body, true));
  require_reported(json::read_reason_body(body, false));
  require_reported(json::read_transition_body(body));
  require_reported(json::read_job_body(body));
  require_reported(json::read_arm_body(body));
  require_reported(json::read_choice_body(body));
  require_reported(json::read_schedule_body(body));
  require_reported(json::read_end_body(body));
  require_reported(json::read_session_body(body));
  require_reported(json::read_user_body(body));
  require_reported(json::read_user_change_body(body));
  require_reported(json::read_token_body(body));
  require_reported(json::read_group_body(body));
  require_reported(json::read_audit_row(body));
  const app::Result<app::Values> values = json::read_values(body);
  require_reported(values);
  if (values) {
    const app::Result<app::Values> again = json::read_values(json::write_values(*values));
    fuzz::require(again.has_value() && json::write_values(*again) == json::write_values(*values),
                  "values that were written read back the same");
  }
  return 0;
}

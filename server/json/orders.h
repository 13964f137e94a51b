// Orders as the API takes and shows them, and the bodies about jobs: how one is queued, planned, armed and
// confirmed, and why it stopped.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"
#include "server/app/jobs/choices.h"
#include "server/app/jobs/stop_reasons.h"
#include "server/app/shop/sign_in.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

app::Result<store::NewOrder> read_order_body(std::string_view body);
app::Result<store::OrderPlan> read_order_plan_body(std::string_view body);

struct OrderMoveBody {
  store::OrderState to = store::OrderState::open;
  std::string reason;
};
app::Result<OrderMoveBody> read_order_move_body(std::string_view body);
app::Result<store::PartsReport> read_parts_body(std::string_view body);

Schemas order_request_schemas();
Schemas order_schemas();

std::string order(const store::Order& order);

struct JobBody {
  store::Id release = 0;
  app::JobPlan plan{};
};
app::Result<JobBody> read_job_body(std::string_view body);

// All but the group, which stands in the path.
app::Result<app::ChoiceOrder> read_choice_body(std::string_view body);

// Nothing when the body does not say.
struct ArmBody {
  std::optional<double> minutes;
  std::uint32_t rounds = 1;
  std::string early_reason;
};
app::Result<ArmBody> read_arm_body(std::string_view body);

// The job before which another one is moved.
struct MoveBody {
  std::optional<store::Id> before;  // nothing: to the end
};
app::Result<MoveBody> read_move_body(std::string_view body);

struct ScheduleBody {
  std::int64_t not_before_ms = 0;  // 0: at any time
};
app::Result<ScheduleBody> read_schedule_body(std::string_view body);

struct EndBody {
  std::string note;
};
// An empty body is one without members.
app::Result<EndBody> read_end_body(std::string_view body);

Schemas job_request_schemas();

std::string choice(const app::Choice& choice);

// Why a transfer stood still or broke off.
struct StopReasonBody {
  std::string reason;
  std::string note;
};
app::Result<StopReasonBody> read_stop_reason_body(std::string_view body);

std::string stop_reason(const app::StopReason& reason);
std::string job_stop_reasons(const std::vector<app::StopReason>& reasons);
std::string stop_reason_counts(const std::vector<std::string>& offered,
                               const std::vector<app::StopReasonCount>& counts);

}  // namespace dripfeed::json

// Bodies of requests: read as a whole, every fault named with its pointer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "dialects/compile/restart/restart.h"
#include "dialects/compile/translate/convert.h"
#include "server/app/checks/measured.h"
#include "server/app/library/optimizing.h"
#include "server/app/library/programs.h"
#include "server/app/library/rewriting.h"
#include "server/app/out/webhooks.h"
#include "server/app/receive/receiving.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

struct TextBody {
  std::string text;
};
app::Result<TextBody> read_text_body(std::string_view body);

struct ProgramBody {
  std::string name;
  std::string dialect;
  std::string text;
};
app::Result<ProgramBody> read_program_body(std::string_view body);

app::Result<store::ProgramLabels> read_labels_body(std::string_view body);

struct PartBody {
  std::string number;  // empty when changing
  std::string family;  // empty when changing
  app::Values values;
};
app::Result<PartBody> read_part_body(std::string_view body, bool is_new);

app::Result<app::RenderOrder> read_render_body(std::string_view body);

// {"program","revision","machine","delivery","nominal":{"family","values"},"profile":"12-60,70-71"}
app::Result<app::CheckOrder> read_check_body(std::string_view body);

// A check's members, and of accuracy "cmm" (the text of a CSV) and "best_fit", of timing "baud".
struct MeasureBody {
  app::MeasureOrder order;
  std::string cmm;
  bool best_fit = false;
};
enum class Measure : std::uint8_t { accuracy, gouge, timing };
app::Result<MeasureBody> read_measure_body(std::string_view body, Measure what);

app::Result<app::SweepOrder> read_sweep_body(std::string_view body);

// A text as it is written, not stored.
struct DiagnoseBody {
  std::string text;
  std::string dialect;  // empty: the machine's, or the one that the text looks like
  std::string machine;  // empty: the control that the text looks like
  store::Delivery delivery = store::Delivery::memory;
};
app::Result<DiagnoseBody> read_diagnose_body(std::string_view body);

// The same, and what it should make.
struct PathBody {
  DiagnoseBody of;
  std::optional<app::NominalOrder> nominal;
  std::string stock;  // as app::read_stock has it; empty: the nominal's
};
app::Result<PathBody> read_path_body(std::string_view body);

// The same, and how it is laid out again.
struct RewriteBody {
  DiagnoseBody of;
  app::Rewriting how = app::Rewriting::renumber;
  compile::Numbering numbering = compile::Numbering::numbered;
  std::uint32_t first = 10;
  std::uint32_t step = 10;
};
app::Result<RewriteBody> read_rewrite_body(std::string_view body);

// A text that is compared with a stored one.
struct CompareTextBody {
  std::string text;
  store::Revision revision = 0;  // of the stored program; 0: the newest
  std::string machine;           // empty: the control that each text looks like
};
app::Result<CompareTextBody> read_compare_text_body(std::string_view body);

// A text or a stored program, and the control that it is translated for.
struct ConvertBody {
  std::string text;
  store::Id program = 0;
  store::Revision revision = 0;  // 0: the newest
  std::string dialect;           // empty: the program's, the machine's, or the one that the text looks like
  std::string machine;           // empty: the control that the text looks like
  std::string to;                // dialect
  std::string to_machine;
  compile::ConvertMode mode = compile::ConvertMode::macro;
};
// Errors: invalid; of text and program, and of to and to_machine, just one is given.
app::Result<ConvertBody> read_convert_body(std::string_view body);

// A text or a stored program, and how it is made faster.
struct OptimizeBody {
  std::string text;
  store::Id program = 0;
  store::Revision revision = 0;  // 0: the newest
  std::string dialect;           // empty: the program's, the machine's, or the one that the text looks like
  std::string machine;           // empty: the control that the text looks like
  app::OptimizeWords words;
};
// Errors: invalid; of text and program just one is given.
app::Result<OptimizeBody> read_optimize_body(std::string_view body);

struct ReleaseBody {
  store::Id program = 0;
  store::Revision revision = 0;  // 0: the newest
  std::string machine;
  store::Delivery delivery = store::Delivery::drip;
};
app::Result<ReleaseBody> read_release_body(std::string_view body);

// A restart that is looked at, and the one that is made of what was shown.
struct RestartBody {
  std::uint32_t line = 0;
  double clearance_mm = compile::kRestartClearance_mm;
  std::string shown_sha256;  // of the text that was shown; only to make it
};
app::Result<RestartBody> read_restart_body(std::string_view body, bool makes);

// A verdict is waived, or one point of it.
app::Result<store::NewWaiver> read_waiver_body(std::string_view body);

// What an operator states of a proving.
struct SignOffBody {
  std::string note;
};
app::Result<SignOffBody> read_sign_off_body(std::string_view body);

struct ReasonBody {
  std::string reason;
};
// An empty body is one without members.
app::Result<ReasonBody> read_reason_body(std::string_view body, bool required);

struct HandOverBody {
  std::string node;
  std::string reason;
};
app::Result<HandOverBody> read_hand_over_body(std::string_view body);

app::Result<store::ReleaseMove> read_transition_body(std::string_view body);

// An empty body is one without members.
app::Result<app::AcceptOrder> read_accept_body(std::string_view body);

struct ShelveBody {
  std::uint32_t minutes = 0;
  std::string reason;
};
app::Result<ShelveBody> read_shelve_body(std::string_view body);

// The member "machine" of a body that another reader reads; nothing where it has none.
std::optional<std::string> machine_in_body(std::string_view body);

// What an admin says of a webhook; of a change, what is not given stays.
app::Result<store::WebhookSettings> read_webhook_body(std::string_view body);
app::Result<store::WebhookSettings> read_webhook_change(std::string_view body, store::WebhookSettings known);

// For how long the previous secret also signs, in hours.
struct RotateBody {
  std::int64_t keep_hours = 24;
};
app::Result<RotateBody> read_rotate_body(std::string_view body);

struct ReplayBody {
  std::int64_t since_ms = 0;
};
app::Result<ReplayBody> read_replay_body(std::string_view body);

// Of all these bodies, as their readers take them.
Schemas request_schemas();

app::Result<app::Values> read_values(std::string_view document);
std::string write_values(const app::Values& values);

}  // namespace dripfeed::json

// One row a document.
#include "server/json/api_examples.h"

#include <array>

namespace dripfeed::json {

namespace {

constexpr std::array kExamples = {
    ApiExample{"NewOrder", R"({"number": "4711", "operation": "20", "part": "HUB-12", "quantity": 50,
      "machine": "lathe-1", "due_at_ms": 1795600800000, "priority": 10, "metadata": {"cost_center": "A7"}})"},
    ApiExample{"Order", R"({"id": 31, "number": "4711", "operation": "20", "part": "HUB-12", "quantity": 50,
      "machine": "lathe-1", "due_at_ms": 1795600800000, "priority": 10, "metadata": {"cost_center": "A7"},
      "state": "open", "reason": null, "good": 12, "scrap": 1, "open": 38, "transfers": 1, "waiting": 0, "revision": 3,
      "created_by": "the MES", "created_at_ms": 1795500000000, "changed_at_ms": 1795503600000})"},
    ApiExample{"PartsReport", R"({"good": 12, "scrap": 1, "note": "one had a burr"})"},
    ApiExample{"OrderMove", R"({"to": "held", "reason": "the material is late"})"},
    ApiExample{"NewPart", R"({"number": "HUB-12", "family": "hub", "values": {"bore": "42 mm", "length": "60 mm"}})"},
    ApiExample{"RenderOrder", R"({"part": "HUB-12", "machine": "lathe-1", "delivery": "drip"})"},
    ApiExample{"NewProgram", R"({"name": "O0042", "dialect": "fanuc", "text": "%\nO0042\nG0X80.Z2.\nM30\n%\n"})"},
    ApiExample{"Program", R"({"id": 77, "name": "O0042", "dialect": "fanuc", "tags": ["hub"], "folder": null,
      "archived": null, "deleted": null, "revision": 1, "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357",
      "bytes": 24, "blocks": 3, "origin": {"kind": "uploaded"}, "created_by": "the MES",
      "created_at_ms": 1795500100000})"},
    ApiExample{"CheckOrder", R"({"program": 77, "machine": "lathe-1", "delivery": "drip"})"},
    ApiExample{"VerdictSummary", R"({"id": 140, "program": 77, "revision": 1,
      "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357", "machine": "lathe-1",
      "machine_revision": 4, "delivery": "drip", "verdict": "pass", "rules": "2f0d3a91c4be7765", "stale": false, "created_by": "the MES",
      "created_at_ms": 1795500200000, "calls": [], "points": [], "waivers": []})"},
    ApiExample{"NewRelease", R"({"program": 77, "machine": "lathe-1", "delivery": "drip"})"},
    ApiExample{"ReleaseMove", R"({"to": "proving", "transfers": 3})"},
    ApiExample{"SignOff", R"({"note": "first part measured, all sizes in the middle"})"},
    ApiExample{"Release", R"({"id": 17, "state": "approved", "program": 77, "revision": 1, "machine": "lathe-1",
      "delivery": "drip", "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357",
      "restart": null, "transfers_allowed": 3, "transfers_done": 1, "proved_by": "olga",
      "proof": "first part measured, all sizes in the middle", "created_by": "paula", "created_at_ms": 1795500300000,
      "approved_by": "anna", "sign_off": "first part measured", "changed_at_ms": 1795507200000})"},
    ApiExample{"NewJob", R"({"release": 17, "order": 31, "not_before_ms": 1795500450000,
      "end_check": "part taken out"})"},
    ApiExample{"ArmOrder", R"({"minutes": 10})"},
    ApiExample{
        "Job",
        R"({"id": 412, "state": "feeding", "machine": "lathe-1", "release": 17, "order": 31, "restart": null, "program": 77,
      "revision": 1, "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357", "delivery": "drip",
      "link": "tcp://10.0.0.21:4001", "bytes": 24, "reason": "", "reason_id": null, "reason_said": null, "rank": 1,
      "created_by": "the MES", "created_at_ms": 1795500400000, "armed_by": "olga", "armed_at_ms": 1795500500000,
      "expires_at_ms": 1795501100000, "started_at_ms": 1795500512000, "ended_at_ms": null, "held_s": null, "holds": null,
      "line_s": null, "forecast_s": 38.4, "torn": false, "not_before_ms": null, "on_hold": null, "retry_of": null, "choice": null,
      "end_check": "part taken out", "needs_end_confirmation": false, "end_confirmed_by": null,
      "end_confirmed_at_ms": null, "end_note": null,
      "needs_confirmation": false, "confirmed_by": null, "confirm_reason": null, "read_back": null,
      "read_back_state": null})"},
    ApiExample{"Reason", R"({"reason": "the control was reset"})"},
    ApiExample{"HandOver", R"({"node": "hall-2", "reason": "the machine moves to hall 2"})"},
    ApiExample{"NewToken", R"({"name": "the MES", "role": "operator", "scope": ["queue"]})"},
    ApiExample{"NewWebhook", R"({"url": "https://mes.shop/dripfeed", "types": ["job.*", "alarm.raised"],
      "description": "the MES"})"},
    ApiExample{"Problem", R"({"type": "about:blank", "title": "no verdict", "status": 409, "code": "no_verdict",
      "detail": "the text was never checked for this machine and delivery",
      "said": {"id": "store_no_verdict", "values": {}}})"},
};

}  // namespace

std::span<const ApiExample> api_examples() { return kExamples; }

}  // namespace dripfeed::json

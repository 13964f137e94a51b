// The table of all routes; openapi.json is written from it.
#include "server/http/api.h"
#include "server/http/handlers.h"

namespace dripfeed::http {

namespace {

using enum Carries;
using enum Method;
using enum Right;
using enum Takes;
using enum Weight;

constexpr std::string_view kPicture = "image/svg+xml";
constexpr std::string_view kPageTypes =
    "text/html text/javascript text/css image/svg+xml image/png font/woff2 application/manifest+json application/json "
    "application/octet-stream";

constexpr Route kRoutes[] = {
    {get, "/healthz", anybody, light, get_health, "is the server alive", kNoBody, gives("Health")},
    {get, "/api/openapi.json", anybody, bulk, get_openapi, "this description", kNoBody, gives("OpenApi")},
    {get, "/", anybody, bulk, get_page, "the page", kNoBody, gives("", "text/html")},
    {get, "/assets/{name}", anybody, bulk, get_asset, "a file of the page", kNoBody, gives("", kPageTypes)},
    {post, "/api/v1/session", anybody, light, open_session, "sign in with a token, get a cookie", body("NewSession"),
     kGivesNothing},
    {get, "/api/v1/session", viewer, light, get_session, "who am I", kNoBody, gives("Session")},
    {del, "/api/v1/session", viewer, light, close_session, "sign out", kNoBody, kGivesNothing},
    {get, "/api/v1/events", viewer, light, get_events, "live events, resumable (text/event-stream)", kNoBody,
     gives("", "text/event-stream")},
    {get, "/api/v1/machines", viewer, light, list_machines, "machines with the state of their lines", kNoBody,
     lists("MachineSummary"), page},
    {post, "/api/v1/machines", admin, setup, add_machine, "add a machine by its profile", body("Profile"),
     creates("Machine")},
    {get, "/api/v1/machines/{name}", viewer, light, get_machine, "one machine with its profile", kNoBody,
     gives("Machine")},
    {put, "/api/v1/machines/{name}", admin, setup, change_machine, "change a profile", body("Profile"),
     gives("Machine"), if_match},
    {post, "/api/v1/machines/{name}/confirm-reset", operator_, command, confirm_reset,
     "a person says that the control was reset", body("Reason"), gives("MachineStatus")},
    {get, "/api/v1/families", viewer, bulk, list_families, "part families", kNoBody, lists("FamilySummary"), page},
    {post, "/api/v1/families", programmer, bulk, add_family, "add a family by its text", body("NewText"),
     creates("Family")},
    {get, "/api/v1/families/{name}", viewer, bulk, get_family, "one family with its text and parameters", kNoBody,
     gives("Family")},
    {put, "/api/v1/families/{name}", programmer, bulk, change_family, "a new revision of a family", body("NewText"),
     gives("Family"), if_match},
    {get, "/api/v1/parts", viewer, stored, list_parts, "parts: families with values", kNoBody, lists("Part"), page,
     "family"},
    {post, "/api/v1/parts", programmer, bulk, add_part, "add a part", body("NewPart"), creates("Part")},
    {get, "/api/v1/parts/{number}", viewer, stored, get_part, "one part", kNoBody, gives("Part")},
    {put, "/api/v1/parts/{number}", programmer, bulk, change_part, "a new revision of a part's values",
     body("PartChange"), gives("Part"), if_match},
    {get, "/api/v1/programs", viewer, stored, list_programs, "programs", kNoBody, lists("Program"), page, "name part"},
    {post, "/api/v1/programs", programmer, bulk, add_program, "add a program by its text", body("NewProgram"),
     creates("Program"), no_more, "", text},
    {get, "/api/v1/programs/{id}", viewer, stored, get_program, "one program", kNoBody, gives("Program")},
    {get, "/api/v1/programs/{id}/text", viewer, light, get_program_text, "the text of a revision", kNoBody,
     gives("", "text/plain"), no_more, "revision"},
    {get, "/api/v1/programs/{id}/revisions", viewer, stored, list_revisions, "revisions, newest first", kNoBody,
     lists("ProgramRevision"), page},
    {post, "/api/v1/programs/{id}/revisions", programmer, bulk, add_revision, "a new revision of the text",
     body("NewText"), creates("Program"), if_match, "", text},
    {post, "/api/v1/render", programmer, heavy, render, "render a part or family for a machine and store the program",
     body("RenderOrder"), creates("Rendered")},
    {get, "/api/v1/checks", viewer, stored, list_checks, "verdicts, newest first", kNoBody, lists("VerdictSummary"),
     page, "program machine"},
    {post, "/api/v1/checks", programmer, heavy, add_check, "check a program for a machine and store the verdict",
     body("CheckOrder"), creates("Verdict")},
    {get, "/api/v1/checks/{id}", viewer, bulk, get_check, "one verdict with its report", kNoBody, gives("Verdict")},
    {post, "/api/v1/checks/{id}/waivers", approver, light, waive_check, "waive a verdict, with a reason",
     body("Reason"), creates("Verdict")},
    {post, "/api/v1/accuracy", programmer, heavy, measure_accuracy,
     "how far a program's surface lies from the nominal, and measured points; with plot=deviation as SVG",
     body("AccuracyOrder"), gives("AccuracyFigures", kPicture), no_more, "plot", text},
    {post, "/api/v1/gouge", programmer, heavy, measure_gouge,
     "a program's rapids into stock or part and cuts below the nominal; with plot=stock as SVG", body("GougeOrder"),
     gives("GougeFigures", kPicture), no_more, "plot"},
    {post, "/api/v1/timing", programmer, heavy, measure_timing,
     "how long a program takes on a machine and its line; with plot=feed or plot=buffer as SVG", body("TimingOrder"),
     gives("TimingFigures", kPicture), no_more, "plot"},
    {post, "/api/v1/sweep", programmer, heavy, sweep_family,
     "for which values a family passes on a machine, and the smallest failure; with plot=region as SVG",
     body("SweepOrder"), gives("SweepFigures", kPicture), no_more, "plot"},
    {get, "/api/v1/work", viewer, light, list_work, "heavy work that waits or runs now, in the order in which it came",
     kNoBody, lists("Work")},
    {del, "/api/v1/work/{id}", programmer, command, cancel_work, "cancel it: who asked for it, or an admin", kNoBody,
     kGivesNothing},
    {get, "/api/v1/releases", viewer, stored, list_releases, "releases, newest first", kNoBody, lists("Release"), page,
     "machine"},
    {post, "/api/v1/releases", programmer, light, add_release, "a draft that binds text, machine and delivery",
     body("NewRelease"), creates("Release")},
    {get, "/api/v1/releases/{id}", viewer, stored, get_release, "one release", kNoBody, gives("Release")},
    {post, "/api/v1/releases/{id}/transitions", approver, light, move_release, "move a release on", body("ReleaseMove"),
     gives("Release")},
    {get, "/api/v1/jobs", viewer, stored, list_jobs, "transfers, newest first", kNoBody, lists("Job"), page,
     "machine state"},
    {post, "/api/v1/jobs", operator_, staged, add_job, "queue a released program", body("NewJob"), creates("Job")},
    {get, "/api/v1/jobs/{id}", viewer, stored, get_job, "one job", kNoBody, gives("Job")},
    {post, "/api/v1/jobs/{id}/arm", operator_, command, arm_job, "a person arms the job for its machine's line",
     optional_body("ArmOrder"), gives("Job")},
    {post, "/api/v1/jobs/{id}/stop", operator_, command, stop_job, "stop at a block end", kNoBody, gives("Job")},
    {post, "/api/v1/jobs/{id}/cancel", operator_, command, cancel_job, "end at a block end", kNoBody, gives("Job")},
    {post, "/api/v1/jobs/{id}/resume", operator_, command, resume_job, "go on; as if DC1 had come, with a reason",
     optional_body("OptionalReason"), gives("Job")},
    {get, "/api/v1/alarms", viewer, stored, list_alarms,
     "alarms, newest first; with state=open those that ask for somebody", kNoBody, lists("Alarm"), page,
     "state machine"},
    {get, "/api/v1/alarms/{id}", viewer, stored, get_alarm, "one alarm", kNoBody, gives("Alarm")},
    {post, "/api/v1/alarms/{id}/acknowledge", operator_, light, acknowledge_alarm, "a person knows of it", kNoBody,
     gives("Alarm")},
    {post, "/api/v1/alarms/{id}/shelve", operator_, light, shelve_alarm,
     "it asks for nobody for some minutes, with a reason; not a critical one", body("Shelve"), gives("Alarm")},
    {post, "/api/v1/alarms/{id}/unshelve", operator_, light, unshelve_alarm, "it asks again", kNoBody, gives("Alarm")},
    {get, "/api/v1/receipts", viewer, bulk, list_receipts, "what controls punched, newest first", kNoBody,
     lists("Receipt"), page, "machine state"},
    {get, "/api/v1/receipts/{id}", viewer, bulk, get_receipt,
     "one receipt, held against the stored program of its name", kNoBody, gives("Receipt")},
    {get, "/api/v1/receipts/{id}/text", viewer, bulk, get_receipt_text,
     "its text; of one in quarantine the bytes, or with form=read what they say", kNoBody,
     gives("", "text/plain application/octet-stream"), no_more, "form"},
    {post, "/api/v1/receipts/{id}/accept", programmer, setup, accept_receipt,
     "make it a program's revision; one in quarantine by an approver, with a reason", optional_body("AcceptOrder"),
     gives("Receipt")},
    {post, "/api/v1/receipts/{id}/discard", approver, light, discard_receipt, "it is not wanted, with a reason",
     body("Reason"), gives("Receipt")},
    {get, "/api/v1/requests", viewer, stored, list_requests, "what operators asked for, newest first", kNoBody,
     lists("OperatorRequest"), page, "machine"},
    {get, "/api/v1/jobs/{id}/ledger", viewer, stored, get_ledger, "what is known of a transfer", kNoBody,
     gives("Ledger"), page},
};

}  // namespace

std::span<const Route> routes() { return kRoutes; }

}  // namespace dripfeed::http

// Three tables: the first row that fits counts.
#include "server/json/api_words.h"

#include <algorithm>
#include <array>

namespace dripfeed::json {

namespace {

constexpr std::array kTags = {
    ApiTag{"Machines", "Machines with their profiles, lines and groups."},
    ApiTag{"Families and parts", "Part families, parts with their values, and rendering them to programs."},
    ApiTag{"Programs", "Texts with their revisions, and the library that finds them."},
    ApiTag{"Checks", "Verdicts, measurements and sweeps, and the queue of heavy work."},
    ApiTag{"Releases", "What lets a checked text go to a machine."},
    ApiTag{"Orders", "What is to be made, as a planner or MES sees it."},
    ApiTag{"Jobs", "Transfers to machines, and what is known of them. A person arms each one."},
    ApiTag{"Receipts", "What controls punched, and what their operators asked for."},
    ApiTag{"Alarms", "What a person should know about a machine."},
    ApiTag{"Events", "Live events for a page or program that stays connected."},
    ApiTag{"Webhooks", "Events for other systems, posted by HTTP."},
    ApiTag{"Editing", "Faults, words and toolpaths of a text while it is written; other dialects."},
    ApiTag{"People", "Users, tokens and the audit."},
    ApiTag{"Session", "Sign-in of a browser."},
    ApiTag{"MTConnect", "Machines as MTConnect describes them, for monitoring systems."},
    ApiTag{"Server",
           "Health, metrics, this description, the page and its documentation; the whole store and its backups."},
};

struct PathRow {
  std::string_view begin;
  std::string_view tag;
};
constexpr std::array kPaths = {
    PathRow{"/api/v1/machines", "Machines"},
    PathRow{"/api/v1/groups/{name}/jobs", "Jobs"},
    PathRow{"/api/v1/groups", "Machines"},
    PathRow{"/api/v1/nodes", "Machines"},
    PathRow{"/api/v1/families", "Families and parts"},
    PathRow{"/api/v1/parts", "Families and parts"},
    PathRow{"/api/v1/render", "Families and parts"},
    PathRow{"/api/v1/preview", "Families and parts"},
    PathRow{"/api/v1/programs", "Programs"},
    PathRow{"/api/v1/search", "Programs"},
    PathRow{"/api/v1/attachments", "Programs"},
    PathRow{"/api/v1/checks", "Checks"},
    PathRow{"/api/v1/accuracy", "Checks"},
    PathRow{"/api/v1/gouge", "Checks"},
    PathRow{"/api/v1/timing", "Checks"},
    PathRow{"/api/v1/sweep", "Checks"},
    PathRow{"/api/v1/work", "Checks"},
    PathRow{"/api/v1/releases", "Releases"},
    PathRow{"/api/v1/orders", "Orders"},
    PathRow{"/api/v1/jobs", "Jobs"},
    PathRow{"/api/v1/history", "Jobs"},
    PathRow{"/api/v1/stop-reasons", "Jobs"},
    PathRow{"/api/v1/receipts", "Receipts"},
    PathRow{"/api/v1/requests", "Receipts"},
    PathRow{"/api/v1/alarms", "Alarms"},
    PathRow{"/api/v1/events", "Events"},
    PathRow{"/api/v1/event-types", "Webhooks"},
    PathRow{"/api/v1/webhooks", "Webhooks"},
    PathRow{"/api/v1/convert", "Editing"},
    PathRow{"/api/v1/diagnose", "Editing"},
    PathRow{"/api/v1/imports", "Programs"},
    PathRow{"/api/v1/split", "Editing"},
    PathRow{"/api/v1/optimize", "Editing"},
    PathRow{"/api/v1/rewrite", "Editing"},
    PathRow{"/api/v1/statistics", "Editing"},
    PathRow{"/api/v1/path", "Editing"},
    PathRow{"/api/v1/stock", "Editing"},
    PathRow{"/api/v1/dialects", "Editing"},
    PathRow{"/api/v1/users", "People"},
    PathRow{"/api/v1/tokens", "People"},
    PathRow{"/api/v1/audit", "People"},
    PathRow{"/api/v1/store", "Server"},
    PathRow{"/api/v1/backups", "Server"},
    PathRow{"/api/v1/session", "Session"},
    PathRow{"/mtconnect", "MTConnect"},
    PathRow{"/api/v1/", ""},
    PathRow{"/", "Server"},
};

struct ParameterRow {
  std::string_view begin;  // of the path
  std::string_view name;
  std::string_view about;
};
constexpr std::array kParameters = {
    ParameterRow{"", "If-Match", "the revision that is changed: the ETag of what was read"},
    ParameterRow{"", "Idempotency-Key",
                 "any text of the caller's: the same request with the same key takes effect once, and is answered as "
                 "the first time"},
    ParameterRow{"", "limit", "how many a page has at most; not given: 50"},
    ParameterRow{"", "after", "`next` of the page before"},
    ParameterRow{"/mtconnect", "from", "the number of the first change"},
    ParameterRow{"/mtconnect", "count", "how many changes at most"},
    ParameterRow{"/mtconnect", "path", "an XPath; not supported: refused as MTConnect prescribes"},
    ParameterRow{"/mtconnect", "at", "a number in the past; not supported: refused as MTConnect prescribes"},
    ParameterRow{"/mtconnect", "interval", "of a stream; not supported: refused as MTConnect prescribes"},
    ParameterRow{"/mtconnect", "heartbeat", "of a stream; not supported: refused as MTConnect prescribes"},
    ParameterRow{"/assets", "name", "of the file"},
    ParameterRow{"/docs", "name", "of the page"},
    ParameterRow{"/mtconnect", "name", "of the machine"},
    ParameterRow{"/api/v1/machines", "name", "of the machine"},
    ParameterRow{"/api/v1/groups", "name", "of the group"},
    ParameterRow{"/api/v1/users", "name", "of the person"},
    ParameterRow{"/api/v1/backups", "name", "of the backup"},
    ParameterRow{"/api/v1/families", "name", "of the family"},
    ParameterRow{"/api/v1/dialects", "name", "of the dialect"},
    ParameterRow{"/api/v1/imports", "path",
                 "of the file: turning/O0012.nc; its folders become folders of the library, its name the program's"},
    ParameterRow{"/api/v1/imports", "folder", "the library's folder in which those of the path lie"},
    ParameterRow{"/api/v1/imports", "dialect", "of new programs; without it the one that each text looks like"},
    ParameterRow{"/api/v1/imports", "known",
                 "a name that is in use in its folder with another text gets a revision (revise, as without it), or is "
                 "left alone"},
    ParameterRow{
        "/api/v1/imports", "keep_ending",
        "true: the name keeps an ending such as .NC, because another file of the folder differs by that alone"},
    ParameterRow{"/api/v1/imports", "only_look", "true: report what would become of it; nothing is stored"},
    ParameterRow{"/api/v1/attachments", "name", "of the file"},
    ParameterRow{"/api/v1/attachments", "program", "whose files, by its id"},
    ParameterRow{"/api/v1/attachments", "family", "whose files, by its name"},
    ParameterRow{"/api/v1/attachments", "part", "whose files, by its number"},
    ParameterRow{"/api/v1/attachments", "order", "whose files, by its id"},
    ParameterRow{"/api/v1/programs", "name", "only programs with this name"},
    ParameterRow{"/api/v1/parts", "number", "of the part"},
    ParameterRow{"/api/v1/orders", "number", "only orders with this number"},
    ParameterRow{"/api/v1/programs", "delivery", "how the text would go to the control; not given: memory"},
    ParameterRow{
        "/api/v1/programs", "stock",
        "the blank as `box X0 X1 Y0 Y1 Z0 Z1` or `cylinder DIAMETER Z0 Z1`, in mm; not given: that of the family"},
    ParameterRow{"", "delivery", "id of the delivery"},
    ParameterRow{"", "id", "of the thing, as its list states it"},
    ParameterRow{"/api/v1/programs/{id}/compare", "machine", "for which the motions are computed"},
    ParameterRow{"/api/v1/programs/{id}/path", "machine",
                 "for which motions and times are computed; not given: no times"},
    ParameterRow{"/api/v1/programs/{id}/stock", "machine", "whose tools cut"},
    ParameterRow{"", "machine", "only those of this machine"},
    ParameterRow{"", "program", "only those of this program, by its id"},
    ParameterRow{"", "part", "only those of this part, by its number"},
    ParameterRow{"", "family", "only those of this family, by its name"},
    ParameterRow{"", "order", "only those of this order, by its id"},
    ParameterRow{"", "choice", "only those of this choice, by its id"},
    ParameterRow{"", "state", "only those in this state"},
    ParameterRow{"", "tag", "only programs with this tag"},
    ParameterRow{"", "folder", "only programs in this folder"},
    ParameterRow{"", "shelf", "programs in use, archived ones, or both"},
    ParameterRow{"", "q", "the words that are looked for, or a \"phrase\""},
    ParameterRow{"", "subject", "only rows about this thing: \"program/7\""},
    ParameterRow{"", "actor", "only what this person or token did"},
    ParameterRow{"", "action", "only this kind of act"},
    ParameterRow{"", "from_ms", "from this time on, in ms since 1970, UTC"},
    ParameterRow{"", "to_ms", "before this time, in ms since 1970, UTC"},
    ParameterRow{"", "revision", "of the text; not given: the newest"},
    ParameterRow{"", "with", "id of the program that it is compared with; not given: the same one"},
    ParameterRow{"", "with_revision", "of the text that it is compared with; not given: the newest"},
    ParameterRow{"", "from", "the first line, from 1"},
    ParameterRow{"", "count", "how many lines"},
    ParameterRow{"", "by", "what the sums are grouped by; not given: the machine"},
    ParameterRow{"", "days", "how many, back from now"},
    ParameterRow{"", "form", "`read`: what can be read of the bytes, as text"},
    ParameterRow{"", "kind", "of the machine: some words are of one kind alone"},
    ParameterRow{"", "g_system", "the G-code system of a lathe"},
    ParameterRow{"", "plot", "the answer is this picture, as SVG"},
};

}  // namespace

std::span<const ApiTag> api_tags() { return kTags; }

std::string_view tag_of(std::string_view path) {
  const auto* const row = std::ranges::find_if(kPaths, [&](const PathRow& one) { return path.starts_with(one.begin); });
  return row == kPaths.end() ? "" : row->tag;
}

std::string_view parameter_about(std::string_view path, std::string_view name) {
  const auto* const row = std::ranges::find_if(
      kParameters, [&](const ParameterRow& one) { return one.name == name && path.starts_with(one.begin); });
  return row == kParameters.end() ? "" : row->about;
}

}  // namespace dripfeed::json

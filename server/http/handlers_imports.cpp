// Files of a shop's own folders, one a request: whoever has many sends one after the other, and each is reported.
#include <algorithm>
#include <expected>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "server/app/base/names.h"
#include "server/app/library/import_file.h"
#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/spool.h"
#include "server/json/shop_manifest.h"

namespace dripfeed::http {

namespace {

std::string why_wrong(const Request& request) {
  if (query_text(request, "path").empty()) return "path is needed: the file's name, and the folders that it lies in";
  if (const std::string why = app::why_no_folder(query_text(request, "folder")); !why.empty())
    return fmt::format("folder {}", why);
  if (const std::string why = app::why_no_dialect(query_text(request, "dialect")); !why.empty())
    return fmt::format("dialect: {}", why);
  const std::string known = query_text(request, "known");
  if (!known.empty() && std::ranges::find(app::kKnownNames, known) == app::kKnownNames.end())
    return fmt::format("known must be one of {}", fmt::join(app::kKnownNames, ", "));
  for (const std::string name : {"only_look", "keep_ending"}) {
    const std::string given = query_text(request, name);
    if (!given.empty() && given != "true") return fmt::format("{} must be true, or not given", name);
  }
  return {};
}

}  // namespace

// What is wrong with the request refuses it; what becomes of each program of the file is in the report.
Response import_programs(const Call& call) {
  if (std::string why = why_wrong(call.request); !why.empty()) return problem_response(422, std::move(why));
  std::expected<std::string, std::string> spooled;
  if (call.request.spooled) spooled = call.request.spooled->read();
  if (!spooled) return problem_response(app::Error{app::ErrorCode::unavailable, spooled.error(), {}});
  app::Application& application = call.api.application();
  const bool only_look = !query_text(call.request, "only_look").empty();
  app::Importer importer(
      application.store(), application.programs(), application.clock(),
      {.actor = std::string(call.user),
       .dialect = query_text(call.request, "dialect"),
       .known = query_text(call.request, "known") == "skip" ? app::KnownName::skip : app::KnownName::revise,
       .only_look = only_look});
  std::vector<app::ImportRow> rows;
  app::import_file(importer,
                   {.path = query_text(call.request, "path"),
                    .under = query_text(call.request, "folder"),
                    .bytes = call.request.spooled ? *spooled : call.request.body,
                    .keeps_ending = !query_text(call.request, "keep_ending").empty()},
                   [&](const app::ImportRow& row) { rows.push_back(row); });
  return json_response(200, json::import_report(rows, only_look));
}

}  // namespace dripfeed::http

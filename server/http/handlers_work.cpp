// Heavy work that waits or runs now: a look at it, and an end to it. It is no record: what is done or cancelled is
// gone.
#include <algorithm>

#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/records.h"

namespace dripfeed::http {

app::Waiter waiter_of(const Call& call, std::string_view kind, std::string subject, std::string_view machine) {
  return {.stop = call.api.stop(),
          .peer = call.request.peer,
          .work = {.kind = std::string(kind),
                   .subject = std::move(subject),
                   .machine = std::string(machine),
                   .actor = std::string(call.user)}};
}

Response list_work(const Call& call) {
  std::vector<std::string> items;
  for (const app::Work& work : call.api.workers().workplace().works()) items.push_back(json::work(work));
  return json_response(200, json::list(items, {}));
}

// Its waiting request gets the answer that it was cancelled, and by whom; its process is killed.
Response cancel_work(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  app::Workplace& workplace = call.api.workers().workplace();
  const auto works = workplace.works();
  const auto work = std::ranges::find(works, *id, &app::Work::id);
  const bool may = work == works.end() || work->name.actor == call.user || call.right >= Right::admin;
  if (!may)
    return problem_response(403, fmt::format("{} asked for this: only they, or an admin, cancel it", work->name.actor));
  if (!workplace.cancel(*id, call.user)) return problem_response(404, fmt::format("no work {} waits or runs", *id));
  return no_content();
}

}  // namespace dripfeed::http

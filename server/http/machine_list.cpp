// What is kept was read after its version was asked for, so it is never older than that.
#include "server/http/machine_list.h"

#include <utility>

#include "server/http/api.h"

namespace dripfeed::http {

store::Result<MachineList::Page> MachineList::read(const store::PageRequest& request, std::uint64_t version) {
  auto read = application_.store().machines().list(request);
  if (!read) return std::unexpected(read.error());
  Page page{.version = version, .rows = {}, .next = std::move(read->next)};
  for (store::Machine& machine : read->items) {
    Row row{.machine = {}, .head = titles_.of(machine), .facts = {}, .text = {}, .is_kept = false};
    machine.profile.clear();
    row.machine = std::move(machine);
    page.rows.push_back(std::move(row));
  }
  return page;
}

const std::string& MachineList::text_of(Row& row) {
  app::LineFacts facts = application_.facts(row.machine.name);
  if (row.is_kept && facts == row.facts) return row.text;
  const app::MachineStatus status = application_.status(row.machine.name, facts);
  row.text = json::machine_summary(row.machine, row.head, status);
  row.facts = std::move(facts);
  row.is_kept = status.is_certain;
  return row.text;
}

Response MachineList::answer(const store::PageRequest& request, std::uint64_t version) {
  const std::lock_guard lock(mutex_);
  if (pages_.size() >= kMostPages) pages_.clear();
  Page& page = pages_[{request.after, request.limit}];
  if (page.rows.empty() || page.version != version) {
    auto fresh = read(request, version);
    if (!fresh) return problem_response(app::from_store(fresh.error()));
    page = std::move(*fresh);
  }
  std::vector<std::string> items;
  items.reserve(page.rows.size());
  for (Row& row : page.rows) items.push_back(text_of(row));
  return json_response(200, json::list(items, page.next));
}

}  // namespace dripfeed::http

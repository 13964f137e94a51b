// Reading the documents.
#include "server/http/titles.h"

#include "dialects/text/source.h"

namespace dripfeed::http {

std::string Titles::of(const store::Family& family) {
  return families_.of(family.name, family.revision,
                      [&] { return compile::describe_family(text::Source(family.name, family.text)).title; });
}

json::ProfileHead Titles::of(const store::Machine& machine) {
  return machines_.of(machine.name, machine.revision, [&] { return json::profile_head(machine.profile); });
}

}  // namespace dripfeed::http

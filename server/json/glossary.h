// What the members of requests and of machine profiles mean. Their shape is described by the functions that read them;
// this has one sentence for each member, with its unit where its name does not say it.
#pragma once

#include <span>
#include <string_view>

#include "server/json/schemas.h"

namespace dripfeed::json {

// The row with the longest end of a member's path counts: "axes/name" before "name"; "Order/" stands for
// all documents that are called so.
struct GlossaryRow {
  std::string_view path;
  std::string_view about;
};
std::span<const GlossaryRow> glossary();

// Gives each member that has none its sentence.
void explain(NamedSchema& schema);

}  // namespace dripfeed::json

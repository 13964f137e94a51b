// What passed on a line, as people see it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "server/app/lines/wire_tap.h"
#include "server/app/ports/clock.h"

namespace dripfeed::json {

// What passed in one direction without a pause, up to the end of a block; or what the link's own lines did.
struct WireRun {
  app::WireKind kind = app::WireKind::in;
  feed::Time from{};
  feed::Time to{};
  std::string text{};  // UTF-8, one character each; what cannot be seen as its picture
  std::string hex{};   // the bytes
  std::size_t count = 0;
  std::size_t wrong = 0;  // characters with wrong parity, or that the code does not have
  bool is_over = false;   // the end of a block was in it
};
// The data line of the event `wire`.
std::string wire(const app::WireTap::Batch& batch, const tape_code::DecodeTable& code, const app::Clock& clock);
std::vector<WireRun> wire_runs(const app::WireTap::Batch& batch, const tape_code::DecodeTable& code);

}  // namespace dripfeed::json

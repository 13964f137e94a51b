// The record of a line that outlives whoever feeds it: who has the line now, and whether a block may be torn at its
// control. The server and `dripfeed send` keep the same record, so neither sends on a line that the other one left
// torn.
#pragma once

#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "server/machine/link_url.h"

namespace dripfeed::app {

// A line that is ours while this object lives. Every member that writes is durable when it returns, or says in one
// sentence why it is not. Not thread-safe: one thread at a time.
class LineClaim {
 public:
  LineClaim() = default;
  LineClaim(const LineClaim&) = delete;
  LineClaim& operator=(const LineClaim&) = delete;
  virtual ~LineClaim() = default;

  // Why a block may be torn at the control: what was sent, by whom and when. Empty where nothing is torn. A record that
  // says "sending" when the line is claimed counts as torn: whoever sent did not live to say how it ended.
  [[nodiscard]] virtual std::string torn() const = 0;
  // Bytes may leave from now on. `what`: "job 12", "an answer", "part.nc by dripfeed send".
  virtual std::expected<void, std::string> begin(std::string_view what) = 0;
  // All that left ended with a whole block, or nothing left.
  virtual std::expected<void, std::string> end() = 0;
  // What left broke off inside a block.
  virtual std::expected<void, std::string> tear(std::string_view why) = 0;
  // A person says that the control was reset.
  virtual std::expected<void, std::string> confirm_reset(std::string_view reason) = 0;
};

// Takes the line of a link; or one sentence that says who has it, or why its record cannot be kept.
using ClaimLine = std::function<std::expected<std::unique_ptr<LineClaim>, std::string>(const machine::LinkUrl&)>;

}  // namespace dripfeed::app

// The text of an MTConnect adapter (SHDR), for an agent that a shop has already: a line for each change of a data item.
// The keys are the ids that /mtconnect/probe gives, so that its answer is the agent's device file.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "server/app/out/observations.h"
#include "server/app/ports/text_feed.h"

namespace dripfeed::app {

// The lines of one agent: it knows which faults that one holds for active.
class ShdrText {
 public:
  // Lines with their ends.
  std::string lines(std::span<const Observation> observations);

 private:
  void add_condition(std::string& out, const Observation& one, const std::string& id, const std::string& time);

  std::map<std::string, std::string> active_;  // by data item: the control's own number of its fault or warning
};

// What an agent is sent: the state of all machines, then each change. It asks `* PING`; nothing else is answered.
class ShdrFeed final : public TextFeed {
 public:
  // The observations must outlive it.
  explicit ShdrFeed(const Observations& observations) : observations_(observations) {}
  std::string greeting() override;
  std::string changes() override;
  std::string answer(std::string_view line) override;

 private:
  std::string all();

  const Observations& observations_;
  ShdrText text_;
  std::uint64_t next_ = 1;
};

}  // namespace dripfeed::app

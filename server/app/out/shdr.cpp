// `time|key|value` of an event, `time|key|code|text` of a message, `time|key|level|code|severity|qualifier|text` of a
// condition (MTConnect Standard Part 5 calls it the adapter's protocol).
#include "server/app/out/shdr.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "server/app/base/wall_time.h"

namespace dripfeed::app {

namespace {

constexpr std::size_t kAtATime = 1000;  // changes

// Within a line nothing may look like its marks.
std::string field(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c == '|' || c == '\n' || c == '\r') c = ' ';
  return out;
}

std::string in_capitals(std::string_view word) {
  std::string out(word);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return out;
}

}  // namespace

std::string ShdrText::lines(std::span<const Observation> observations) {
  std::string out;
  for (const Observation& one : observations) {
    const std::string id = data_item_id(one.machine, one.item);
    const std::string time = rfc3339(one.at_ms);
    if (data_items()[static_cast<std::size_t>(one.item)].category == ItemCategory::condition) {
      add_condition(out, one, id, time);
    } else if (one.item == DataItem::line_state) {
      out += fmt::format("{}|{}||{}\n", time, id, field(one.observed.value));
    } else {
      out += fmt::format("{}|{}|{}\n", time, id, field(one.observed.value));
    }
  }
  return out;
}

// An agent holds faults with different numbers for different ones: that of before is over.
void ShdrText::add_condition(std::string& out, const Observation& one, const std::string& id, const std::string& time) {
  const std::string code = field(one.observed.code);
  const bool is_active = one.observed.value == "Fault" || one.observed.value == "Warning";
  const auto before = active_.find(id);
  if (is_active && before != active_.end() && before->second != code)
    out += fmt::format("{}|{}|NORMAL|{}|||\n", time, id, before->second);
  if (is_active) {
    active_[id] = code;
  } else if (before != active_.end()) {
    active_.erase(before);
  }
  out += fmt::format("{}|{}|{}|{}|||{}\n", time, id, in_capitals(one.observed.value), code, field(one.observed.text));
}

std::string ShdrFeed::greeting() { return "* shdrVersion: 2.0\n* description: dripfeed\n" + all(); }

std::string ShdrFeed::all() {
  const ObservationBatch now = observations_.current("");
  next_ = now.last + 1;
  return text_.lines(now.observations);
}

// Where changes are not kept any more, the whole state has what they led to.
std::string ShdrFeed::changes() {
  const auto batch = observations_.sample("", next_, kAtATime);
  if (!batch) return all();
  next_ = batch->next;
  return text_.lines(batch->observations);
}

// An agent asks again within the heartbeat that it is given.
std::string ShdrFeed::answer(std::string_view line) { return line.starts_with("* PING") ? "* PONG 10000\n" : ""; }

}  // namespace dripfeed::app

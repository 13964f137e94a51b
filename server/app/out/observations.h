// What collectors of MTConnect ask for: the newest value of each data item of each machine, and the changes before it,
// numbered. They are noted by a thread of its own from the first question on, and it costs nothing where no agent asks.
// What is not known is UNAVAILABLE: of a control without words of its PLC that is most of it.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/round_thread.h"
#include "server/app/lines/line.h"
#include "server/app/ports/clock.h"

namespace dripfeed::app {

enum class DataItem : std::uint8_t { availability, line_state, execution, mode, program, line, system, communications };
inline constexpr std::size_t kDataItems = 8;

enum class ItemCategory : std::uint8_t { event, condition };
struct DataItemRow {
  DataItem item;
  std::string_view id;    // after the device's: "_exec"
  std::string_view type;  // as MTConnect has it, in probe and as its element's name
  std::string_view element;
  std::string_view sub_type;  // "" none
  std::string_view where;     // component: "" the device itself, "controller", "path"
  ItemCategory category = ItemCategory::event;
};
std::span<const DataItemRow, kDataItems> data_items();
// Made of the machine's name, so that they stay: of the device, and of one of its data items.
std::string device_id(std::string_view machine);
std::string data_item_id(std::string_view machine, DataItem item);

// "UNAVAILABLE", or of a condition "Normal", "Warning", "Fault".
inline constexpr std::string_view kUnavailable = "UNAVAILABLE";
struct Observed {
  std::string value{kUnavailable};
  std::string text{};  // of a condition, for people
  std::string code{};  // of a condition: the control's own number
  friend bool operator==(const Observed&, const Observed&) = default;
};
using ObservedItems = std::array<Observed, kDataItems>;
// What is known of a machine, and no more.
ObservedItems observed_of(const LineReport& report);

struct Observation {
  std::uint64_t sequence = 0;
  std::int64_t at_ms = 0;
  std::string machine;
  DataItem item = DataItem::availability;
  Observed observed;
};

struct ObservationBatch {
  std::uint64_t first = 1;  // that is kept
  std::uint64_t last = 0;   // that there is
  std::uint64_t next = 1;   // to ask from next time
  std::vector<Observation> observations;
};

class Observations {
 public:
  static constexpr std::size_t kKept = 16'384;

  // `look` gives the report of each machine that there is.
  using Look = std::function<std::map<std::string, LineReport>()>;
  Observations(const Clock& clock, Look look);

  // Since when it counts, in seconds since 1970: a new one has numbers of its own.
  [[nodiscard]] std::int64_t instance() const { return instance_; }
  [[nodiscard]] std::vector<std::string> machines() const;
  // The newest of each item, of one machine or of all for "".
  [[nodiscard]] ObservationBatch current(std::string_view machine) const;
  // From a number on; nothing where it is not kept, or was never given.
  [[nodiscard]] std::optional<ObservationBatch> sample(std::string_view machine, std::optional<std::uint64_t> from,
                                                       std::size_t count) const;
  void stop() { thread_.stop(); }

 private:
  void round();
  [[nodiscard]] ObservationBatch empty_batch() const;

  const Clock& clock_;
  Look look_;
  std::int64_t instance_;
  mutable std::mutex mutex_;
  std::deque<Observation> kept_;
  std::uint64_t last_ = 0;
  std::map<std::string, std::array<Observation, kDataItems>, std::less<>> newest_;
  RoundThread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::app

// Where other people's programs are interpreted: somewhere that their worst cannot reach a line. A request and its
// reply are texts; what they say is agreed between who asks and who carries it out.
#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::app {

// What a piece of work is, for people who look at what waits.
struct WorkName {
  std::string kind;     // "check", "render", "sweep", …
  std::string subject;  // "program/7", "family/roll", "part/R-1"
  std::string machine;
  std::string actor;  // who asked for it
};

// Who waits for the work: once none does, it is given up.
struct Waiter {
  std::stop_token stop = {};  // of the server
  int peer = -1;              // the socket of the client that asked; -1: none. It must stay open while the work lasts.
  WorkName work = {};
};

enum class WorkFault : std::uint8_t {
  busy,       // as many wait as may
  time,       // the budget of time is used up
  memory,     // the budget of memory is used up
  ended,      // it ended abnormally
  abandoned,  // no request waits for it any more
  cancelled,  // by a person
  not_begun,  // the system gave no process
};
struct WorkError {
  WorkFault fault = WorkFault::ended;
  std::string text;  // a sentence
};

// Work that waits or runs now.
struct Work {
  std::uint64_t id = 0;  // 1, 2, 3, … since the start
  WorkName name;
  std::int64_t waiting_since_ms = 0;  // since 1970
  std::int64_t running_since_ms = 0;  // 0: it waits
  std::uint32_t place = 0;            // of those that wait: 1 is the next; 0: it runs
  std::uint32_t budget_s = 0;         // from when it runs; 0: none
};

// Of a Work: it waits, it runs.
inline constexpr std::array<std::string_view, 2> kWorkStates = {"waiting", "running"};

class Workplace {
 public:
  Workplace() = default;
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  virtual ~Workplace() = default;
  // Waits until it is done. `seconds`: the budget of time, 0: none. May be called by several threads at once.
  virtual std::expected<std::string, WorkError> carry_out(std::string_view request, std::uint32_t seconds,
                                                          const Waiter& waiter) = 0;
  // What runs and what waits, in the order in which it came. From any thread, as the next one.
  virtual std::vector<Work> works() = 0;
  // Gives up a piece of work; who waits for it gets `cancelled` with the name of who did. False: there is none.
  virtual bool cancel(std::uint64_t work, std::string_view by) = 0;
};

}  // namespace dripfeed::app

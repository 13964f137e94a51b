// Where other people's programs are interpreted: somewhere that their worst cannot reach a line. A request and its
// reply are texts; what they say is agreed between who asks and who carries it out.
#pragma once

#include <cstdint>
#include <expected>
#include <stop_token>
#include <string>
#include <string_view>

namespace dripfeed::app {

// Who waits for the work: once nobody does, it is given up.
struct Waiter {
  std::stop_token stop = {};  // of the server
  int peer = -1;              // the socket of the client that asked; -1: none. It must stay open while the work lasts.
};

enum class WorkFault : std::uint8_t {
  busy,       // as many wait as may
  time,       // the budget of time is used up
  memory,     // the budget of memory is used up
  ended,      // it ended abnormally
  abandoned,  // nobody waits for it any more
  not_begun,  // the system gave no process
};
struct WorkError {
  WorkFault fault = WorkFault::ended;
  std::string text;  // a sentence
};

class Workplace {
 public:
  Workplace() = default;
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  virtual ~Workplace() = default;
  // Waits until it is done. `seconds`: the budget of time, 0: none. May be called by several threads at once.
  virtual std::expected<std::string, WorkError> carry_out(std::string_view request, std::uint32_t seconds,
                                                          const Waiter& waiter) = 0;
};

}  // namespace dripfeed::app

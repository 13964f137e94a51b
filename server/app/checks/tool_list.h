// The tools that a run takes, each once.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/ir/motion.h"

namespace dripfeed::app {

class ToolList {
 public:
  struct Tool {
    std::int32_t number = 0;
    std::uint32_t text = 0xFFFFFFFFU;  // as ir::Motion::text
    ir::Place place;                   // where it is taken first
  };

  // Takes the tool of an event; whether it is another one than before.
  bool take(const ir::Motion& motion);
  // The one that is in the spindle or at work, an index of all().
  [[nodiscard]] std::uint32_t current() const { return current_; }
  // The first one stands for none: it is there until one is taken.
  [[nodiscard]] const std::vector<Tool>& all() const { return tools_; }
  // "T5", or as the program names it; "" for none.
  [[nodiscard]] std::string name_of(std::uint32_t tool, const std::vector<std::string>& strings) const;

 private:
  std::vector<Tool> tools_ = {Tool{}};
  std::uint32_t current_ = 0;
};

}  // namespace dripfeed::app

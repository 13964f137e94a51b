// Texts that are values: names of a part or an order, which stand in messages and comments and are engraved.
#pragma once

#include <string>
#include <string_view>

namespace dripfeed::family {

// What forbids the text on every control, "" for nothing: each of its characters must stand in a comment of one control
// at least. Which of them the control at hand shows is for who renders.
std::string fault_of_text(std::string_view written);

}  // namespace dripfeed::family

// A variable in a text that is not taken apart: a synchronized action, a block that EXECSTRING makes.
#pragma once

#include <cstdint>
#include <string_view>

namespace dripfeed::compile {

enum class Mention : std::uint8_t { none, reads, sets };

// `target` in upper case: "#100", "R10", "DIA"; R10 is also $R10, R[10] and, as far as is known, R[R1].
Mention mention_of(std::string_view text, std::string_view target);

// Whether it is an argument, by itself, in which a procedure of the control gives back a value: READ(R10,...).
bool is_given_back(std::string_view text, std::string_view target);

}  // namespace dripfeed::compile

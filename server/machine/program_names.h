// One program under the names that controls and people give it: ROLL_1, ROLL_1.MPF, _N_ROLL_1_MPF; O0042, 42, O42.NC.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::machine {

// Without what only says which control it is for or what kind of file it is, in capitals; of a number without its O and
// leading zeros. Two names of one program have the same one.
std::string plain_program_name(std::string_view name);

inline bool is_same_program_name(std::string_view one, std::string_view other) {
  return plain_program_name(one) == plain_program_name(other);
}

// Under which names it may be stored, the likeliest first: the name as it came, then its other forms. Each has the same
// plain name, but for the case of its letters.
std::vector<std::string> forms_of_program_name(std::string_view name);

}  // namespace dripfeed::machine

// What a file holds, by the ending of its name: a program, data for the control, or neither.
#pragma once

#include <string_view>

#include "dialects/ir/program.h"

namespace dripfeed::sinumerik {

bool ends_with(std::string_view name, std::string_view ending);  // in any case, with something before it
// Data for the control and no program that runs: definition files, initialization files, tool and offset data.
bool is_data_file(const ir::Program& program);
// Whether a file with that ending (three letters) is something else than a program or such data, which an archive may
// hold as well: alarm texts, pictures, job lists.
bool is_other_ending(std::string_view ending);

}  // namespace dripfeed::sinumerik

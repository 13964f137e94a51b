// The definition files of a control (GUD, macros), found as called programs are, before a program is read.
#pragma once

#include "dialects/compile/dialect/library.h"
#include "dialects/ir/control.h"

namespace dripfeed::compile {

// The control with what its definition files declare; as it is where it has none, or knows them already.
ir::Control with_definitions(ir::Control control, const FindText& find_text);

}  // namespace dripfeed::compile

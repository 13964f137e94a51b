// The lead of a thread: K or I in each block (SINUMERIK), or F, which stays in effect as a feed. Of one that changes
// (G34, G35), F is the change where letters are the lead, and K where F is.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

bool leads_by_letters(const ir::Control& control);
// What is not known is an error at its block.
std::vector<text::Diagnostic> translate_leads(ir::Program& program, const ir::Control& from, const ir::Control& to);

}  // namespace dripfeed::compile

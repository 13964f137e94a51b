// A family proposed from a native program: the constants of its header become parameters, with the comments next to
// them as texts. A person edits what is proposed; that it renders to the program's own bytes is tried before it is
// given.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/ir/control.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

struct ProposalNote {
  std::uint32_t line = 0;  // of the program; 0: of none
  std::string text;
};

struct FamilyProposal {
  std::string text;            // of the .family file; empty when it would not render to the program's bytes
  std::size_t parameters = 0;  // that are proposed
  std::vector<ProposalNote> notes;
};

// `control` is one of `dialect`. The family's name is made from `name`, which may be a path.
FamilyProposal propose_family(const text::Source& program, const Dialect& dialect, const ir::Control& control,
                              const std::string& name);

}  // namespace dripfeed::compile

// Words that stay in effect as they were written, and when what was written is another value by now.
#pragma once

#include "dialects/facts/block_values.h"
#include "dialects/facts/modal_facts.h"

namespace dripfeed::facts {

Written written(const ir::Word& word, const BlockValues& values);

// The variable gets another value: words that were computed with it stay stated, with a value that is not known.
void forget_computed(const ir::Program& program, ir::VariableId variable, Facts& facts);
// Whoever is called has variables of its own: there, and after it, the same is true of all computed words.
void forget_computed(Facts& facts);

}  // namespace dripfeed::facts

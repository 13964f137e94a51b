// dialects/passes: what changes a program so that a control can take it, each pass (Program, Control) -> report:
// variable allocation, structures that a control lacks, label numbers, modes and words that another control would take
// otherwise. Passes know no spelling: reading and printing is the dialects', running is the interpreter's.
#pragma once

#include "dialects/passes/allocation.h"
#include "dialects/passes/arc_words.h"
#include "dialects/passes/explicit_modes.h"
#include "dialects/passes/foreign_variables.h"
#include "dialects/passes/labels.h"
#include "dialects/passes/machine_functions.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/safe_start.h"
#include "dialects/passes/structures.h"

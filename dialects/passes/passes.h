// dialects/passes: what changes a program so that a control can take it, each pass (Program, Control) -> report:
// variable allocation, structures that a control lacks, label numbers. Passes know no spelling: reading and printing is
// the dialects', running is the interpreter's.
#pragma once

#include "dialects/passes/allocation.h"
#include "dialects/passes/labels.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/safe_start.h"
#include "dialects/passes/structures.h"

// dialects/ir: the one program model in the middle. A program is flat: tokens that tile the text, statements in order,
// and arenas for words, expressions and names, joined by 32-bit indices. Next to it the data that says what a control
// can do (Control), how it calculates (Semantics) and what a computed block costs (CostModel), and what the interpreter
// emits (Motion). Plain data only: reading, checking and running it is left to the dialects, passes and the
// interpreter.
#pragma once

#include "dialects/ir/control.h"
#include "dialects/ir/cycle.h"
#include "dialects/ir/expression.h"
#include "dialects/ir/function.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/program.h"
#include "dialects/ir/semantics.h"
#include "dialects/ir/stage.h"
#include "dialects/ir/statement.h"
#include "dialects/ir/token.h"

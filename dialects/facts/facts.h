// dialects/facts: what is in effect before each statement of a program, on all control-flow paths that lead there:
// modal codes, feed and speed, tool, positions. One forward pass over the flow graph, through jumps, structures, and
// calls of programs of the same text. Whoever must know what a word means where it stands asks here and not the text's
// order. Nothing here runs a program, changes it, or knows how a control spells it.
#pragma once

#include "dialects/facts/axis_words.h"
#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/facts/in_effect.h"
#include "dialects/facts/known.h"
#include "dialects/facts/modal_facts.h"
#include "dialects/facts/resolved.h"
#include "dialects/facts/shape_blocks.h"
#include "dialects/facts/spindle.h"
#include "dialects/facts/tool_in.h"
#include "dialects/facts/transformation.h"

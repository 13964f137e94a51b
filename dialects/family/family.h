// dialects/family: the part-family language. A `.family` file has typed parameters with unit, range, default and
// constraints, stock and nominal geometry, and one body of machine-neutral verbs. Here it is read (read.h), given
// values (bind.h), turned into a program (build.h) and into geometry (geometry.h). Which control the program is for,
// and whether it is rendered as macro or explicit, is left to dialects/compile.
//
// The language and its grammar stand in docs/families.md, whose examples are tests.
//
// Loops. `for t from a to b step s` is defined by its index: t is a, a + s, a + 2s, … and at last exactly b; the number
// of trips is fixed once, before the first; the last step is shortened to hit b, and one that is within a millionth of
// s beyond a whole number is taken as whole. `down` counts downward with a positive s. If b lies before a, the body
// does not run; where values are known (they depend on no loop) this is an error of binding.
#pragma once

#include "dialects/family/bind.h"
#include "dialects/family/build.h"
#include "dialects/family/geometry.h"
#include "dialects/family/model.h"
#include "dialects/family/read.h"
#include "dialects/family/unit.h"

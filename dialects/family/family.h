// dialects/family: the part-family language. A `.family` file has typed parameters with unit, range, default and
// constraints, stock and nominal geometry, and one body of machine-neutral verbs. Here it is read (read.h), given
// values (bind.h), turned into a program (build.h) and into geometry (geometry.h). Which control the program is for,
// and whether it is rendered as macro or explicit, is left to dialects/compile.
//
// Grammar. One statement a line; a line that ends in + - * / ^ ( or ',' goes on in the next; `#` starts a comment.
// Names are lower case letters, digits and '_', begin with a letter and are no keyword (axis letters and units are
// keywords).
//
//   file        = header { declaration } program
//   header      = "family" NAME [STRING]  EOL
//                 "machine" ("lathe" | "mill" | "mill-turn") ["," "x" "is" ("diameter" | "radius")]  EOL
//   declaration = "param" NAME kind literal "in" literal ".." literal [STRING]  EOL
//               | "let" NAME "=" expr  EOL
//               | "require" condition [STRING]  EOL
//               | "stock" "cylinder" "diameter" expr ["bore" expr] "z" expr ".." expr  EOL
//               | "stock" "box" "x" expr ".." expr "y" expr ".." expr "z" expr ".." expr  EOL
//               | "nominal" "x" "=" expr "for" "z" "in" expr ".." expr "tolerance" expr  EOL                lathe
//               | "nominal" "z" "=" expr "for" "x" "in" expr ".." expr "y" "in" expr ".." expr "tolerance" expr  EOL
//                                                                  mill; a later one is carved into the earlier ones
//               | "nominal" "curve" "for" NAME "in" expr ".." expr "x" expr "y" expr "tolerance" expr ["center"]  EOL
//               | "nominal" ("bezier" | "nurbs" "order" INTEGER) "tolerance" expr ["center"]  EOL
//                 { "point" "x" expr "y" expr ["weight" expr]  EOL } ["knots" expr { expr }  EOL] "end"  EOL
//                                                                  mill; "center": of the tool's centre
//   kind        = "length" | "angle" | "feed" | "speed" | "time" | "count" | "ratio"
//   program     = "program" NAME  EOL { step } "end"  EOL
//   step        = "work" "offset" INTEGER                                          1 is the control's first (G54), 0
//   none
//               | "tool" INTEGER ["nose" literal] ["tip" INTEGER] ["diameter" expr] ["corner" expr]
//               | "spindle" expr ["limit" expr] ["cw" | "ccw"] | "spindle" "off"   rpm, or m/min of surface speed
//               | "coolant" ("flood" | "mist" | "off")
//               | "compensate" ("left" | "right" | "off")    of the nose or cutter radius, from the next rapid or cut
//               on | "feed" expr                                                      mm/min or mm/rev | ("rapid" |
//               "cut") { axis expr } | "arc" ("cw" | "ccw") { axis expr } ("radius" expr | "center" { ("i"|"j"|"k")
//               expr }) | "retract" { axis expr } { "then" { axis expr } }                 rapids, one after the other
//               | "profile" … "end"                                               these moves make the nominal
//               | "for" NAME "from" expr ["down"] "to" expr "step" expr … "end"
//               | "if" condition … ["else" …] "end"
//               | "let" NAME "=" expr | "message" STRING | "dwell" expr | "stop" | "optional" "stop"
//   axis        = "x" | "y" | "z" | "a" | "b" | "c"
//   condition   = comparisons (< <= > >= = !=) joined by "and", "or", "not" and parentheses
//   expr        = + - * / ^ (whole exponent), parentheses, names, `pi`, literals, and the functions
//                 sin cos tan asin acos atan atan2 sqrt abs min max round trunc ln exp radians
//   literal     = a decimal number with its unit: mm in deg rad s ms min rpm mm/min in/min mm/rev in/rev m/min ft/min
//
// Units. Every value has a dimension. Sums, comparisons and the places of verbs need equal dimensions; products and
// quotients combine them; sin, cos and tan take an angle, asin, acos, atan and atan2 give one; sqrt halves the
// exponents; `radians` makes a plain number of an angle. A plain number where a dimension is needed is an error, 0
// included. m/min and ft/min are surface speeds, which never mix with feeds. The bounds of a range may leave out the
// unit: they take the default's. An axis a, b or c takes an angle, the others a length. Centers i, j and k are from the
// start of the arc to its center, as radius values.
//
// Loops. `for t from a to b step s` is defined by its index: t is a, a + s, a + 2s, … and at last exactly b; the number
// of trips is fixed once, before the first; the last step is shortened to hit b, and one that is within a millionth of
// s beyond a whole number is taken as whole. `down` goes the other way with a positive s. If b lies before a, the body
// does not run; where values are known (they depend on no loop) this is an error of binding.
#pragma once

#include "dialects/family/bind.h"
#include "dialects/family/build.h"
#include "dialects/family/geometry.h"
#include "dialects/family/model.h"
#include "dialects/family/read.h"
#include "dialects/family/unit.h"

// dialects/optimize: a program that does the same and costs its control less to compute. Each pass but the table is
// exact: a run that ends without an alarm of arithmetic makes the same motions to the last bit. Passes look at the
// program's own flow of values and at the figures of the cost model; they neither run it nor write text. What is not
// understood ends the optimization with a reason, and the program stays as it was.
#pragma once

#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/optimize/places.h"
#include "dialects/optimize/rules.h"
#include "dialects/optimize/work.h"

namespace dripfeed::optimize {

struct Settings {
  Rules rules = {};
  // Numbers that no other program reads: what is left in them at the end counts for nothing.
  std::vector<NumberRange> own = {};
  // Numbers that the program may begin to use; they count as its own.
  std::vector<NumberRange> free = {};
  // How far the path may be changed, mm; 0: not at all, then the rules that change it have no effect.
  double tolerance_mm = 0.0;
  // What Rule::table is to try. How far the moves are off then, is not looked at here.
  TableWish table = {};
};

struct Result {
  std::vector<Change> changes;  // in the order that they were made
  std::vector<MadeLine> made;   // of the lines beyond those of the text, in order
  std::string obstacle;         // why nothing was looked at; empty where it was
};

// Changes `program` in place. Statements that stay keep their payload, and arenas only grow: who holds a copy of the
// program as it was can see which statements are new. `cost`: what the control needs for what.
Result optimize(ir::Program& program, const ir::Control& control, const ir::CostModel& cost, const Settings& settings);

}  // namespace dripfeed::optimize

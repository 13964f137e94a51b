// What the passes share: the program, what is known of its surroundings, and the report that they write.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/optimize/liveness.h"
#include "dialects/optimize/rules.h"

namespace dripfeed::optimize {

struct Change {
  Rule rule = Rule::values;
  std::uint32_t line = 0;  // of the text that was given
  std::string what;        // one sentence without its full stop
};

inline void add_all(std::vector<std::uint32_t>& into, const std::vector<std::uint32_t>& lines) {
  into.insert(into.end(), lines.begin(), lines.end());
}

// A block that was made: it has a line of its own, beyond those of the text.
struct MadeLine {
  std::uint32_t from = 0;                       // line of the text
  std::vector<std::uint32_t> comments_of = {};  // lines of the text
};

// Numbers that the program mentions. Its variables only become more, so each is looked at once.
struct UsedNumbers {
  std::size_t looked_at = 0;  // of Program::variables
  std::set<std::pair<ir::Bank, std::uint32_t>> used = {};
  std::set<ir::Bank> computed = {};  // any number of these may be meant
};

struct Work {
  ir::Program& program;
  const ir::Control& control;
  const ir::CostModel& cost;
  std::vector<NumberRange> own;   // see Places
  std::vector<NumberRange> free;  // of `own`: numbers that the program may begin to use
  bool keeps_comments = true;     // lines with one that run once are left apart
  std::vector<Change> changes = {};
  std::uint32_t text_lines = 0;
  std::vector<MadeLine> made_lines = {};
  UsedNumbers numbers = {};

  std::uint32_t new_line(std::uint32_t from, const std::vector<std::uint32_t>& with_comments_of = {}) {
    MadeLine made{.from = line_of_text(from)};
    for (const std::uint32_t line : with_comments_of) {
      if (line <= text_lines)
        made.comments_of.push_back(line);
      else
        add_all(made.comments_of, made_lines[line - text_lines - 1].comments_of);
    }
    made_lines.push_back(std::move(made));
    return text_lines + static_cast<std::uint32_t>(made_lines.size());
  }
  [[nodiscard]] std::uint32_t line_of_text(std::uint32_t line) const {
    return line <= text_lines ? line : made_lines[line - text_lines - 1].from;
  }
  void report(Rule rule, std::uint32_t line, std::string what) {
    changes.push_back({rule, line_of_text(line), std::move(what)});
  }
};

// A number of `work.free` that the program does not mention; none left: nothing.
std::optional<PlaceFacts> free_place(Work& work);
// `count` of them in a row.
std::optional<NumberRange> free_range(Work& work, std::size_t count);

// Of a table in place of a formula.
struct TableWish {
  std::uint32_t spans = 0;  // in which it is interpolated, along the rounds of a loop; 0: no table
  bool nested = false;      // along those of the loop around the innermost one, whose rounds all have their own values
};

// Each runs over the program once and says whether it changed anything.
bool structure_jumps(Work& work, bool loops, bool branches);
bool number_names(Work& work);
bool propagate_values(Work& work);
bool hoist_invariants(Work& work);
bool drop_unread(Work& work);
bool merge_values(Work& work);
bool tabulate(Work& work, const TableWish& wish);
bool join_blocks(Work& work);

}  // namespace dripfeed::optimize

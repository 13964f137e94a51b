// What people read of a family at the control: which one it is, with which values, and what its variables mean.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/comment_style.h"
#include "dialects/compile/render/legend.h"
#include "dialects/family/bind.h"
#include "dialects/ir/control.h"
#include "dialects/ir/stage.h"

namespace dripfeed::compile {

struct Annotation {
  std::vector<std::string> heading;               // lines before the first block
  std::map<std::uint32_t, std::string> meaning;   // by line of the family: next to the first line that is printed of it
  std::set<std::uint32_t> verbs;                  // lines of the family that compute several values
  std::map<std::string, std::string> names = {};  // of these, by variable: next to its first assignment
};

// `more`: lines for the heading, such as revision and part. `computed`: the control computes, and assignments show the
// values of parameters; otherwise the heading does.
Annotation annotation_of(const family::BoundFamily& bound, const std::vector<std::string>& more, bool computed);
// The names of what the verbs compute, of variables that have one name each.
std::map<std::string, std::string> names_of_variables(const std::vector<LegendEntry>& legend);

// Whether the control shows the character, be it as a capital.
bool shows(char c, CommentStyle style);

// A text in letters that the control shows, 60 at most.
std::string shown(std::string_view text, CommentStyle style);

// Puts the comments in, in letters that the control shows, as far as its blocks are long enough.
void annotate(ir::PrintResult& printed, const Annotation& annotation, const ir::Control& to, CommentStyle style);

}  // namespace dripfeed::compile

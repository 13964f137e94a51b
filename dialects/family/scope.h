// Names of a family and what they stand for: parameters and lets from where they are written to the end, names of the
// body to the end of their block.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "dialects/family/unit.h"
#include "dialects/ir/program.h"
#include "dialects/text/span.h"

namespace dripfeed::family {

// What a name may be used as.
enum class NameKind : std::uint8_t {
  value,     // a number that is given once, or counts a loop
  variable,  // … that `set` may change
  list,
  points,  // several lists, named after it
  choice,
  yes_no,
  text,
};

class Scope {
 public:
  struct Name {
    std::string name;
    ir::SymbolId symbol = ir::SymbolId::none;
    Dimension dimension;
    text::Span span;
    bool visible = true;
    NameKind kind = NameKind::value;
  };

  // nullptr when no visible name is so called.
  [[nodiscard]] const Name* find(std::string_view name) const;
  // Adds a symbol to `arena`, or takes the one of a name of a closed block over. `name` must not be visible now.
  ir::SymbolId define(ir::Program& arena, std::string_view name, Dimension dimension, text::Span span,
                      NameKind kind = NameKind::value);
  // The visible name that is most like `name`, for "did you mean"; "" when none is near, or when so many were looked
  // for that more would cost the reader more than it helps.
  [[nodiscard]] std::string_view nearest(std::string_view name);

  void open() { marks_.push_back(names_.size()); }
  void close();
  // Closes a block whose symbols are its own for ever: a later name that is so called gets another one.
  void seal();

 private:
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  std::vector<Name> names_;
  std::unordered_map<std::string, std::size_t, Hash, std::equal_to<>> last_;  // by name: its last place in names_
  std::uint64_t compared_letters_ = 0;                                        // by nearest()
  std::vector<std::size_t> marks_;
};

}  // namespace dripfeed::family

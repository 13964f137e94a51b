// What a family states of its native program: `is TARGET` after parameters and lets, and the line `native DIALECT`.
#pragma once

#include "dialects/family/cursor.h"
#include "dialects/family/model.h"

namespace dripfeed::family {

class NativeReader {
 public:
  NativeReader(Cursor& cursor, Family& family) : cursor_(cursor), family_(family) {}

  // At the end of a declaration: "is" and the target, where they stand there.
  void target(ir::SymbolId symbol, Dimension dimension, const Unit* unit);
  // After "native", to the end of its line.
  void dialect();
  // When all is read: targets need a native program, parameters of a native program need targets.
  void check();

 private:
  void check_targets_differ();
  void check_parameters_are_used();
  void fault(text::Span span, std::string sentence);

  Cursor& cursor_;
  Family& family_;
};

}  // namespace dripfeed::family

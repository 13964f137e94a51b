// Loops of a family as loops of its program.
#pragma once

#include <string_view>
#include <vector>

#include "dialects/family/build_names.h"
#include "dialects/family/emitter.h"
#include "dialects/family/model.h"
#include "dialects/family/value_writer.h"

namespace dripfeed::family {

class LoopWriter {
 public:
  LoopWriter(const Family& family, const BuildNames& names, ir::Program& program, ValueWriter& values, Emitter& emit)
      : family_(family), names_(names), program_(program), values_(values), emit_(emit) {}

  void for_begin(const Step& step);
  void for_in_begin(const Step& step);
  void for_end();  // of both
  void while_begin(const Step& step);
  void while_end();

 private:
  struct Loop {
    ir::SymbolId index;
    ir::Operator next = ir::Operator::add;  // by one
  };

  ValueWriter::Bound last_trip(ir::ExpressionId trips, std::string_view name);
  void count_begin(const Step& step, const ValueWriter::Bound& from, const ValueWriter::Bound& to);

  const Family& family_;
  const BuildNames& names_;
  ir::Program& program_;
  ValueWriter& values_;
  Emitter& emit_;
  std::vector<Loop> loops_;
  std::vector<ir::SymbolId> conditions_;  // of open `while`s: go_on, or none
};

}  // namespace dripfeed::family

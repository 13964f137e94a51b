// G10: which system variables a block of data sets. (0i-F B-64604EN, programmable data input.)
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/interpreter/state/block_rules.h"

namespace dripfeed::interpreter {

struct DataValue {
  std::uint32_t number = 0;
  double value = 0.0;  // in the unit of the program
  bool adds = false;
  bool is_extended_offset = false;  // of G54.1: `number` counts from #7001 on, for all P
};
struct DataValues {
  std::string name;               // for the report: "G10 L2"
  std::vector<DataValue> values;  // empty: not one that is known here
};
DataValues data_values(const PlainBlock& block, const BlockRules& rules, const ModalState& state, bool lathe);

}  // namespace dripfeed::interpreter

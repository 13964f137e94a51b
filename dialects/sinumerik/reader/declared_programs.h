// EXTERN NAME(REAL, VAR INT, STRING[20]): what a program says of one that it calls (Programming Manual Job Planning,
// "Subprogram technique").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::sinumerik {

struct DeclaredParameter {
  bool by_reference = false;
  bool is_string = false;
  bool is_axis = false;
  std::uint32_t dimensions = 0;

  friend bool operator==(const DeclaredParameter&, const DeclaredParameter&) = default;
};
struct DeclaredProgram {
  std::string name;  // upper case
  std::vector<DeclaredParameter> parameters;
};

// `s`: a declaration, which is kept as its tokens. Nothing for one without a list, which declares nothing.
std::optional<DeclaredProgram> declared_program(const ir::Program& program, const ir::Statement& s);

}  // namespace dripfeed::sinumerik

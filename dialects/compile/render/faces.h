// Polar and cylindrical interpolation of a family. A control that has them makes the moves of a face itself, in plain
// blocks as well: there they are run as the moves of the plane that they are written in.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/compile/plain/explicit_program.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

[[nodiscard]] bool has_faces(const ir::Program& program);

// What begins and ends faces, while M functions stand for it.
class HiddenFaces {
 public:
  // In a built program, which `control` is to run.
  void hide(ir::Program& program, ir::Control& control);
  // In the plain blocks of that run.
  void show(ExplicitProgram& made) const;

 private:
  struct Face {
    std::int16_t use = 0;  // ir/transformation_use.h
    double diameter = 0.0;
    bool operator==(const Face&) const = default;
  };

  [[nodiscard]] const Face* face_of(const ir::Program& program, const ir::Statement& statement) const;

  std::vector<Face> faces_;
  // What a run carries over it finds by its line, so that each of them has one to itself: of the family by that line.
  std::vector<std::uint32_t> lines_;
};

}  // namespace dripfeed::compile

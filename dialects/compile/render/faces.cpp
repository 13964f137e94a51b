// The number of the M function is the row of the face, after those of native texts. One code ends a face
// as well as a cylinder: which of the two it ends follows from the code before it that began one.
#include "dialects/compile/render/faces.h"

#include <algorithm>
#include <limits>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/family/model.h"
#include "dialects/ir/transformation_use.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::compile {

namespace {

constexpr std::size_t kFirstFace = static_cast<std::size_t>(family::kFirstNativeFunction) + family::kMostNatives;
constexpr std::size_t kMostFaces = static_cast<std::size_t>(std::numeric_limits<std::int16_t>::max()) - kFirstFace;

constexpr std::uint32_t kFirstLine = 1U << 30U;  // longer than any family

}  // namespace

bool has_faces(const ir::Program& program) {
  return std::ranges::find(program.codes, ir::Function::transformation, &ir::Code::function) != program.codes.end();
}

void HiddenFaces::hide(ir::Program& program, ir::Control& control) {
  if (!control.axes.contains('Y')) control.axes += 'Y';
  for (ir::Statement& statement : program.statements) {
    if (statement.kind != ir::StatementKind::block) continue;
    ir::Block& block = program.blocks[statement.payload];
    if (block.code_count != 1) continue;
    ir::Code& code = program.codes[block.first_code];
    if (code.function != ir::Function::transformation) continue;
    const auto words = program.words_of(block);
    const Face face{.use = code.argument, .diameter = words.empty() ? 0.0 : program.at(words.front().value).value};
    const auto row = static_cast<std::size_t>(std::ranges::find(faces_, face) - faces_.begin());
    if (row == kMostFaces) continue;  // its moves are written
    if (row == faces_.size()) {
      faces_.push_back(face);
      control.machine_functions.push_back(static_cast<std::uint16_t>(kFirstFace + row));
    }
    code.function = ir::Function::machine_function;
    code.argument = static_cast<std::int16_t>(kFirstFace + row);
    code.letter = 'M';
    block.word_count = 0;
    lines_.push_back(statement.line);
    statement.line = kFirstLine + static_cast<std::uint32_t>(lines_.size() - 1);
  }
}

const HiddenFaces::Face* HiddenFaces::face_of(const ir::Program& program, const ir::Statement& statement) const {
  if (statement.kind != ir::StatementKind::block) return nullptr;
  const auto codes = program.codes_of(program.blocks[statement.payload]);
  if (codes.size() != 1 || codes.front().function != ir::Function::machine_function) return nullptr;
  const auto number = static_cast<std::size_t>(codes.front().argument);
  return number >= kFirstFace && number - kFirstFace < faces_.size() ? &faces_[number - kFirstFace] : nullptr;
}

void HiddenFaces::show(ExplicitProgram& made) const {
  if (faces_.empty()) return;
  for (BlockOrigin& origin : made.origins)
    if (origin.line >= kFirstLine) origin.line = lines_[origin.line - kFirstLine];
  ir::Program& program = made.program;
  const auto plane = [](ir::Function f) { return std::vector{code_of(f, ir::ModalGroup::plane)}; };
  bool is_polar = false;
  passes::Rewrite out(program);
  out.visit_all([&](std::uint32_t index) {
    const Face* face = face_of(program, program.statements[index]);
    if (face == nullptr) return out.keep();
    ir::Code code = code_of(ir::Function::transformation, ir::ModalGroup::other);
    code.argument = face->use;
    std::vector<ir::Word> words;
    if (face->use == ir::kCylinderByY) {
      words.emplace_back().address = ir::Address::r;
      words.back().value = program.add_constant(face->diameter);
    }
    if (face->use == ir::kTransformationEnds && is_polar) out.emit_block(plane(ir::Function::plane_zx), {});
    out.emit_block({code}, words);
    is_polar = face->use == ir::kFaceByY;
    if (is_polar) out.emit_block(plane(ir::Function::plane_xy), {});
  });
}

}  // namespace dripfeed::compile

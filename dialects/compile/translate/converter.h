// The translation of one program: what its steps share. Only convert.cpp and translation_passes.cpp know it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/translate/common_numbers.h"
#include "dialects/compile/translate/convert.h"
#include "dialects/compile/translate/inline_moves.h"

namespace dripfeed::compile {

class Converter;
struct TranslationPass {
  std::string_view name;
  std::string_view because;              // it stands where it stands
  bool (Converter::*run)(ir::Program&);  // false: it found what no later pass could work on
};

class Converter {
 public:
  Converter(const ConvertRequest& request, const Dialect& from, const Dialect& to)
      : request_(request),
        from_(from),
        to_(to),
        inline_moves_(request.from, request.to, request.library, request.limits) {}

  ConvertResult convert();

 private:
  void translate();
  void refuse_faulty(const ir::Program& program);
  void drop_repeated_diagnostics();
  void refuse_long_blocks();
  void refuse_long_block(std::size_t line, std::size_t bytes);
  [[nodiscard]] text::Span span_of_origin(std::size_t line) const;
  void proofread();

  // translation_passes.cpp: in the order in which they run.
  static std::span<const TranslationPass> passes_of(ConvertMode mode);
  bool refuse_unlike_axes(ir::Program& program);
  bool refuse_own_cycles(ir::Program& program);
  bool translate_main_returns(ir::Program& program);
  bool splice_iso(ir::Program& program);
  bool write_as_moves(ir::Program& program);
  bool translate_thread_leads(ir::Program& program);
  bool lower_turning_cycles(ir::Program& program);
  bool translate_faces_and_cylinders(ir::Program& program);
  bool translate_rigid_taps(ir::Program& program);
  bool refuse_machine_functions(ir::Program& program);
  bool lower_flow(ir::Program& program);
  bool place_shifted_increments(ir::Program& program);
  bool make_modes_explicit(ir::Program& program);
  bool call_as_macros(ir::Program& program);
  bool print_programs(ir::Program& program);
  bool carry_all_comments(ir::Program& program);
  bool watch_run(ir::Program& program);
  bool print_run(ir::Program& program);

  void print(const ir::Program& program, const ir::Control& from);
  void lower(ir::Program& program);
  ir::RaiseResult raise(const ir::Program& program, const ir::Control& from);
  ir::RaiseResult raise_with_room(const ir::Program& program, const ir::Control& from);
  void several(const ir::Program& text);
  void report_skip_decided(const ir::Program& program);
  void add(std::vector<text::Diagnostic> diagnostics);
  [[nodiscard]] bool has_error() const { return text::has_error(result_.diagnostics); }

  const ConvertRequest& request_;
  const Dialect& from_;
  const Dialect& to_;
  InlineMoves inline_moves_;
  std::size_t diagnostics_before_ = 0;  // diagnostics up to those of inline_moves_
  std::optional<CommonNumbers> common_;
  ConvertResult result_;
};

}  // namespace dripfeed::compile

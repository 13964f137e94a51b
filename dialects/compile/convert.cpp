// Three ways: the bytes themselves, raise and print, or run, raise and print.
#include "dialects/compile/convert.h"

#include <iterator>
#include <utility>

#include "dialects/compile/dialect.h"
#include "dialects/compile/explicit_program.h"

namespace dripfeed::compile {

namespace {

void append(std::vector<text::Diagnostic>& out, std::vector<text::Diagnostic> more) {
  out.insert(out.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

class Converter {
 public:
  Converter(const ConvertRequest& request, const Dialect& from, const Dialect& to)
      : request_(request), from_(from), to_(to) {}

  ConvertResult convert() {
    if (&from_ == &to_ && request_.mode == ConvertMode::macro) {
      result_.text = request_.source.text();
      return std::move(result_);
    }
    ir::ReadResult read = from_.read(request_.source, request_.from);
    append(result_.diagnostics, std::move(read.diagnostics));
    if (text::has_error(result_.diagnostics)) return std::move(result_);
    if (request_.mode == ConvertMode::macro) {
      print(read.program, request_.from);
    } else {
      explicit_blocks(read.program);
    }
    return std::move(result_);
  }

 private:
  void print(const ir::Program& program, const ir::Control& from) {
    ir::RaiseResult raised = to_.raise(program, from, request_.to);
    append(result_.diagnostics, std::move(raised.diagnostics));
    if (text::has_error(result_.diagnostics)) return;
    ir::PrintResult printed = to_.print(raised.program, request_.to);
    result_.text = std::move(printed.text);
    result_.origin_lines = std::move(printed.origin_lines);
  }

  void explicit_blocks(const ir::Program& program) {
    interpreter::ProgramFinder& none = interpreter::no_programs();
    interpreter::ProgramFinder& finder = request_.library == nullptr ? none : *request_.library;
    const ExplicitProgram made =
        explicit_program(program, request_.from, finder, {.limits = request_.limits, .initial_values = {}});
    append(result_.diagnostics, run_faults(made));
    if (text::has_error(result_.diagnostics)) return;
    print(made.program, made.control);
    for (std::uint32_t& line : result_.origin_lines) {
      if (line != 0) line = made.origins[line - 1].line;
    }
  }

  const ConvertRequest& request_;
  const Dialect& from_;
  const Dialect& to_;
  ConvertResult result_;
};

}  // namespace

ConvertResult convert(const ConvertRequest& request) {
  const Dialect* from = find_dialect(request.from.dialect);
  const Dialect* to = find_dialect(request.to.dialect);
  if (from != nullptr && to != nullptr) return Converter(request, *from, *to).convert();
  ConvertResult out;
  const std::string& unknown = from == nullptr ? request.from.dialect : request.to.dialect;
  out.diagnostics.push_back(text::make_diagnostic(text::DiagnosticId::cannot_translate, {}, {"the program", unknown}));
  return out;
}

}  // namespace dripfeed::compile

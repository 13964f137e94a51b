// A program that is not there is remembered as well: a loop that calls it asks the store once.
#include "dialects/compile/library.h"

#include <utility>

#include "dialects/compile/dialect.h"

namespace dripfeed::compile {

ProgramLibrary::ProgramLibrary(ir::Control control, FindText find_text)
    : control_(std::move(control)), find_text_(std::move(find_text)) {}

const ir::Program* ProgramLibrary::find(std::string_view name) {
  if (const auto known = by_name_.find(name); known != by_name_.end()) {
    return known->second == nullptr ? nullptr : &known->second->read.program;
  }
  const Dialect* dialect = find_dialect(control_.dialect);
  std::optional<text::Source> source = find_text_ && dialect != nullptr ? find_text_(name) : std::nullopt;
  const bool is_standard = !source && dialect != nullptr && dialect->standard_program != nullptr;
  if (is_standard)
    if (const std::string_view text = dialect->standard_program(name); !text.empty())
      source.emplace(std::string(name), std::string(text));
  if (!source) {
    by_name_.emplace(name, nullptr);
    return nullptr;
  }
  loaded_.push_back(std::make_unique<Loaded>(std::string(name), dialect->read(*source, control_)));
  loaded_.back()->read.program.is_standard = is_standard;
  by_name_.emplace(name, loaded_.back().get());
  return &loaded_.back()->read.program;
}

std::unique_ptr<ir::Program> ProgramLibrary::read_text(std::string_view text) {
  const Dialect* dialect = find_dialect(control_.dialect);
  if (dialect == nullptr) return nullptr;
  ir::ReadResult read = dialect->read(text::Source("EXECSTRING", std::string(text)), control_);
  if (text::has_error(read.diagnostics)) return nullptr;
  return std::make_unique<ir::Program>(std::move(read.program));
}

}  // namespace dripfeed::compile

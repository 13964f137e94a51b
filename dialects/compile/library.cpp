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
  const std::optional<text::Source> source = find_text_ && dialect != nullptr ? find_text_(name) : std::nullopt;
  if (!source) {
    by_name_.emplace(name, nullptr);
    return nullptr;
  }
  loaded_.push_back(std::make_unique<Loaded>(std::string(name), dialect->read(*source, control_)));
  by_name_.emplace(name, loaded_.back().get());
  return &loaded_.back()->read.program;
}

}  // namespace dripfeed::compile

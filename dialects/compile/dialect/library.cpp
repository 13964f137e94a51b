// A program that is not there is remembered as well: a loop that calls it asks the store once.
#include "dialects/compile/dialect/library.h"

#include <utility>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/iso_mode.h"
#include "dialects/compile/dialect/readers.h"

namespace dripfeed::compile {

ProgramLibrary::ProgramLibrary(ir::Control control, FindText find_text)
    : control_(std::move(control)), find_text_(std::move(find_text)) {
  if (has_iso_mode(control_)) iso_ = iso_control(control_);
}

const ir::Program* ProgramLibrary::find(std::string_view name) { return find(name, false); }

const ir::Program* ProgramLibrary::find_foreign(std::string_view name) {
  return has_iso_mode(control_) ? find(name, true) : nullptr;
}

const ir::Program* ProgramLibrary::find(std::string_view name, bool in_iso_mode) {
  ByName& known_names = in_iso_mode ? iso_by_name_ : by_name_;
  if (const auto known = known_names.find(name); known != known_names.end()) {
    return known->second == nullptr ? nullptr : &known->second->read.program;
  }
  const Dialect* dialect = find_reader(control_.dialect);
  std::optional<text::Source> source = find_text_ && dialect != nullptr ? find_text_(name) : std::nullopt;
  const bool is_standard = !source && dialect != nullptr && dialect->standard_program != nullptr;
  if (is_standard)
    if (const std::string_view text = dialect->standard_program(name); !text.empty())
      source.emplace(std::string(name), std::string(text));
  if (!source) {
    known_names.emplace(name, nullptr);
    return nullptr;
  }
  ir::Control control = control_;
  control.semantics.starts_in_iso_mode = in_iso_mode && !begins_with_procedure(source->text());
  loaded_.push_back(std::make_unique<Loaded>(std::string(name), dialect->read(*source, control)));
  loaded_.back()->read.program.is_standard = is_standard;
  known_names.emplace(name, loaded_.back().get());
  return &loaded_.back()->read.program;
}

interpreter::ProgramFinder::ForeignText ProgramLibrary::foreign_text(const ir::Program& host) {
  if (!has_iso_mode(control_)) return {};
  const auto [parts, is_new] = iso_parts_.try_emplace(host.source.text().data());
  if (is_new) parts->second = {.host = host.source, .read = read_iso_parts(host, iso_)};
  return {&parts->second.read.program, &iso_};
}

std::unique_ptr<ir::Program> ProgramLibrary::read_text(std::string_view text) {
  const Dialect* dialect = find_reader(control_.dialect);
  if (dialect == nullptr) return nullptr;
  ir::ReadResult read = dialect->read(text::Source("EXECSTRING", std::string(text)), control_);
  // A block cannot change the language of those that follow it.
  if (text::has_error(read.diagnostics) || !read.program.foreign_parts.empty()) return nullptr;
  return std::make_unique<ir::Program>(std::move(read.program));
}

}  // namespace dripfeed::compile

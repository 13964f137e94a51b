// Values of a part against their family, before they are stored: the reading and the binding that rendering would do.
#include "dialects/compile/render.h"
#include "dialects/family/read.h"

namespace dripfeed::compile {

std::vector<text::Diagnostic> check_values(const text::Source& family, const std::vector<family::Override>& values) {
  family::ReadResult read = family::read(family);
  if (text::has_error(read.diagnostics)) return std::move(read.diagnostics);
  family::BindResult bound = family::bind(read.family, values);
  read.diagnostics.insert(read.diagnostics.end(), bound.diagnostics.begin(), bound.diagnostics.end());
  return std::move(read.diagnostics);
}

}  // namespace dripfeed::compile

// Macros come first in the list of files: sizes of arrays may be written by them.
#include "dialects/compile/dialect/shared_definitions.h"

#include <memory>
#include <utility>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {

ir::Control with_definitions(ir::Control control, const FindText& find_text) {
  const Dialect* dialect = find_dialect(control.dialect);
  if (control.shared != nullptr || !find_text || dialect == nullptr || dialect->add_definitions == nullptr)
    return control;
  ir::SharedDefinitions found;
  for (const std::string& name : control.definition_files)
    if (const auto file = find_text(name)) dialect->add_definitions(*file, control, found);
  if (!found.variables.empty() || !found.macros.empty())
    control.shared = std::make_shared<const ir::SharedDefinitions>(std::move(found));
  return control;
}

}  // namespace dripfeed::compile

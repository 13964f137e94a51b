// Macros come first in the list of files: sizes of arrays may be written by them.
#include "dialects/compile/dialect/shared_definitions.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {

ir::Control with_definitions(ir::Control control, const FindText& find_text) {
  const Dialect* dialect = find_dialect(control.dialect);
  if (control.shared != nullptr || !find_text || dialect == nullptr || dialect->add_definitions == nullptr)
    return control;
  ir::SharedDefinitions found;
  // A file that another one calls is read after it, once.
  std::vector<std::string>& names = control.definition_files;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto file = find_text(names[i]);
    if (!file) continue;
    for (std::string& called : dialect->add_definitions(*file, control, found))
      if (std::ranges::find(names, called) == names.end()) names.push_back(std::move(called));
  }
  if (!found.variables.empty() || !found.macros.empty())
    control.shared = std::make_shared<const ir::SharedDefinitions>(std::move(found));
  return control;
}

}  // namespace dripfeed::compile

// A family with values, as several commands take it.
#pragma once

#include <string>
#include <vector>

#include "dialects/compile/render.h"
#include "server/cli/inputs.h"

namespace CLI {
class App;  // included only where options are added: it takes seconds to compile
}

namespace dripfeed::cli {

struct FamilyOptions {
  TextOptions text;
  std::string file;
  std::vector<std::string> values;  // --set n=v
  std::string mode = "auto";
  std::string name;
  bool drip = false;
};
// The file of that name, or the shipped family.
std::string find_family(const std::string& name);
// --set of a family; NAME=@FILE and NAME=@FILE:COLUMN take a list from a table, whose faults are printed. Errors:
// invalid, refused; unavailable for a file that is not there.
app::Result<std::vector<family::Override>> overrides_of(const std::vector<std::string>& set,
                                                        const text::Source& family);
void add_family_options(CLI::App& command, FamilyOptions& options);

// Renders; faults of the family are printed. The request comes back for its source.
struct RenderedFamily {
  text::Source source;
  ChosenControl chosen;
  std::vector<family::Override> values;
  compile::RenderResult result;
};
app::Result<RenderedFamily> render_family(const FamilyOptions& options);

}  // namespace dripfeed::cli

// A family with values, as several commands take it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/compile/render/render.h"
#include "dialects/compile/render/streamed_render.h"
#include "server/app/checks/examine.h"
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
// Of a command that takes programs, too: --set and --mode alone.
void add_value_options(CLI::App& command, std::vector<std::string>& values, std::string& mode);

// Whether a text is a family: its first line that says anything begins with `family`.
bool is_family(const text::Source& source);

struct RenderedFamily {
  text::Source source;
  ChosenControl chosen;
  std::vector<family::Override> values;
  compile::RenderResult result;
  std::vector<std::uint32_t> lines = {};      // by line of the text: the family's; where they were asked for
  std::vector<compile::Splice> splices = {};  // of the text; where a sink was given
};
// Renders; faults of the family are printed. Errors: what cannot be read, no control named.
app::Result<RenderedFamily> render_family(const FamilyOptions& options);
// The same for the text alone, of which `sink` gets what can be written while the program runs.
app::Result<RenderedFamily> render_family(const FamilyOptions& options, compile::TextSink& sink);
// The same of a text that was read, with its faults in `result` alone, and with `lines`.
app::Result<RenderedFamily> render_family(const FamilyOptions& options, text::Source family);

// The rendered program under a name that cannot be taken for the family's file.
text::Source rendered_source(const RenderedFamily& rendered);
// It, with stock and nominal; refers to `rendered`, which must have no errors.
app::Examination examination_of(const RenderedFamily& rendered, ir::Delivery delivery);
// "roll.family:31" of a line of the rendered program; "" where that comes from none.
std::string place_in_family(const RenderedFamily& rendered, std::uint32_t line);

}  // namespace dripfeed::cli

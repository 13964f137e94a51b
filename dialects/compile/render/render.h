// Rendering: family and values in, text for one control out, as macro (the control computes) or explicit (computed
// here). What is stored, checked or sent of it is left to the caller.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/plain/place_index.h"
#include "dialects/compile/render/legend.h"
#include "dialects/family/bind.h"
#include "dialects/family/drawing.h"
#include "dialects/family/geometry.h"
#include "dialects/ir/control.h"
#include "dialects/ir/stage.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

// `automatic` goes by what the control can do: explicit for drip feeding, because controls reject jumps and loops
// there, and macro for memory as far as the control's variables suffice. Which of the two a machine runs faster is no
// matter of the control: server/app/checks/timed_rendering.h decides that.
enum class RenderMode : std::uint8_t { macro, explicit_blocks, automatic };
// "macro", "explicit", "auto"
std::string_view name_of(RenderMode mode);
std::optional<RenderMode> find_render_mode(std::string_view name);

struct RenderRequest {
  text::Source family;                   // text of the .family file
  std::vector<family::Override> values;  // of the part; the rest are defaults
  ir::Control target;                    // its `dialect` names who prints
  RenderMode mode = RenderMode::automatic;
  ir::Delivery delivery = ir::Delivery::memory;
  std::string program_name;          // "O0100", "ROLL_1"; empty: the dialect's form of the family's name
  std::vector<std::string> heading;  // for people, after the family's name: "revision 3", "part 4711"
};

struct RenderResult {
  std::string text;                     // LF as EOB
  RenderMode mode = RenderMode::macro;  // never automatic
  std::string because;                  // one sentence: why this mode
  bool is_kept = false;                 // a native program with its values, not rewritten
  std::uint64_t blocks = 0;             // non-empty lines but '%'
  std::uint64_t bytes = 0;
  std::uint32_t variables = 0;                   // distinct user variables that the text touches
  std::vector<family::LineRange> profile_lines;  // ranges of printed lines that make the nominal
  PlaceIndex places;                             // explicit only
  std::vector<LegendEntry> legend;               // of a macro's variables
  family::Geometry geometry;                     // stock and nominal with these values
  std::vector<family::DrawnView> drawing;        // and the drawing
  // Spans are in RenderRequest::family. With an error there is no text.
  std::vector<text::Diagnostic> diagnostics;
};

RenderResult render(const RenderRequest& request);

// Stock, nominal and tools of a family with these values, and what reading and binding said of them; for checks of a
// program that was rendered earlier. With an error the geometry is empty.
struct FamilyGeometry {
  family::Geometry geometry;
  std::vector<text::Diagnostic> diagnostics;  // spans in `family`
};
FamilyGeometry family_geometry(const text::Source& family, const std::vector<family::Override>& values);

// Nothing where the control's machine makes what a family for `wanted` describes; otherwise the error, which has no
// place in the text.
std::optional<text::Diagnostic> fault_of_machine(ir::MachineKind wanted, const ir::Control& control);

// What a family is, for lists and forms.
struct ParameterDescription {
  std::string name;
  std::string kind;      // "length", "count", "choice", "yes_no", "tool", "list of length" ...
  std::string unit;      // of default, low and high; empty for plain numbers
  std::string standard;  // the default as one would write it: "100 mm"
  double low = 0.0;
  double high = 0.0;
  double step = 0.0;        // in the same unit; 0: any value
  std::int32_t fewest = 0;  // numbers of a list
  std::int32_t most = 0;
  std::vector<std::string> choices;  // words of a choice or yes_no
  std::string text;
  std::string group;  // heading in forms; may be empty
};
struct FamilyDescription {
  std::string name;
  std::string title;
  ir::MachineKind machine = ir::MachineKind::mill;
  std::vector<ParameterDescription> parameters;
  std::vector<text::Diagnostic> diagnostics;  // spans in `family`
};
FamilyDescription describe_family(const text::Source& family);

// Whether the family takes these values: what reading it and binding them gives; spans in `family`.
std::vector<text::Diagnostic> check_values(const text::Source& family, const std::vector<family::Override>& values);

}  // namespace dripfeed::compile

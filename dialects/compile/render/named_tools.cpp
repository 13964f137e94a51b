// The number stands for the tool in everything that is made of a family; a name takes its place in the text alone.
#include "dialects/compile/render/named_tools.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dialects/text/nearest.h"

namespace dripfeed::compile {

namespace {

std::string known_tools(const ir::Control& control, std::string_view wanted) {
  if (!control.from_profile) return "the machine's profile names the tools: state the machine";
  if (control.tool_names.empty()) return "no tool of the machine's profile has a name";
  const auto distance = [&](const ir::ToolName& one) { return text::edit_distance(wanted, one.name); };
  const auto nearest = std::ranges::min_element(control.tool_names, {}, distance);
  return distance(*nearest) < text::far_from(wanted)
             ? fmt::format("did you mean \"{}\"?", nearest->name)
             : fmt::format("of the names in the machine's profile \"{}\" is the nearest; case counts", nearest->name);
}

bool is_named(const family::Step& step) { return step.kind == family::StepKind::tool && !step.text.empty(); }

}  // namespace

std::vector<text::Diagnostic> number_tools(family::Family& family, const ir::Control& control) {
  std::vector<text::Diagnostic> out;
  std::set<std::string> missing;
  for (family::Step& step : family.steps) {
    if (!is_named(step)) continue;
    step.number = control.from_profile ? ir::tool_of_name(control, step.text) : 0;
    if (step.number != 0 || !missing.insert(step.text).second) continue;
    text::Diagnostic fault =
        text::make_diagnostic(text::DiagnosticId::tool_missing, step.span, {'"' + step.text + '"'});
    fault.severity = text::Severity::error;
    fault.notes.push_back({step.span, known_tools(control, step.text)});
    out.push_back(std::move(fault));
  }
  return out;
}

void name_tools(const family::Family& family, const ir::Control& control, ir::Program& program) {
  if (std::ranges::none_of(family.steps, is_named) || ir::has_numbered_variables(control)) return;
  for (const ir::Block& block : program.blocks) {
    for (std::uint32_t i = 0; i < block.word_count; ++i) {
      ir::Word& word = program.words[block.first_word + i];
      if (word.address != ir::Address::t || word.value == ir::ExpressionId::none) continue;
      const ir::Expression number = program.at(word.value);
      const auto named = std::ranges::find_if(family.steps, [&](const family::Step& one) {
        return is_named(one) && number.op == ir::Operator::constant && number.value == static_cast<double>(one.number);
      });
      if (named == family.steps.end()) continue;
      ir::Expression name;
      name.op = ir::Operator::string;
      name.string = program.strings.add(named->text);
      word.value = program.add(name);
    }
  }
}

}  // namespace dripfeed::compile

// Each parameter goes to an end of its proposed range in turn.
#include "tests/corpus/wrapped.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "dialects/compile/propose/propose_family.h"
#include "dialects/compile/render/render.h"
#include "dialects/text/number.h"

namespace dripfeed::corpus {

namespace {

constexpr std::size_t kTried = 20;  // parameters of a file

// The texts are the same but for one number, which is not the same.
bool differ_in_one_number(std::string_view a, std::string_view b) {
  const auto [left, right] = std::ranges::mismatch(a, b);
  a.remove_prefix(static_cast<std::size_t>(left - a.begin()));
  b.remove_prefix(static_cast<std::size_t>(right - b.begin()));
  while (!a.empty() && !b.empty() && a.back() == b.back()) {
    a.remove_suffix(1);
    b.remove_suffix(1);
  }
  constexpr std::string_view kNumber = "+-.0123456789 \t";
  return !(a.empty() && b.empty()) && a.find_first_not_of(kNumber) == std::string_view::npos &&
         b.find_first_not_of(kNumber) == std::string_view::npos;
}

}  // namespace

Wrapped wrap(const text::Source& source, const compile::Dialect& dialect, const ir::Control& control) {
  const compile::FamilyProposal proposal = compile::propose_family(source, dialect, control, source.name());
  Wrapped out{.parameters = proposal.parameters, .fault = std::nullopt};
  if (proposal.text.empty()) {
    out.fault = "as a family it does not come back";
    for (const compile::ProposalNote& note : proposal.notes)
      if (note.line == 0) *out.fault += "; " + note.text;
    return out;
  }
  compile::RenderRequest request;
  request.family = text::Source("family", proposal.text);
  request.target = control;
  request.mode = compile::RenderMode::macro;
  const compile::FamilyDescription description = compile::describe_family(request.family);
  for (std::size_t i = 0; i < std::min(kTried, description.parameters.size()); ++i) {
    const compile::ParameterDescription& one = description.parameters[i];
    request.values = {{one.name, fmt::format("{} {}", text::format_fixed(one.high, 6), one.unit)}};
    const compile::RenderResult changed = compile::render(request);
    if (text::has_error(changed.diagnostics))
      out.fault = fmt::format("{}: {}", one.name, text::message_of(changed.diagnostics.front()));
    else if (!differ_in_one_number(source.text(), changed.text))
      out.fault = fmt::format("{} changes more than its number", one.name);
  }
  return out;
}

}  // namespace dripfeed::corpus

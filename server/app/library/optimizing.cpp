// The control is found as a translation finds it.
#include "server/app/library/optimizing.h"

#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/shared_definitions.h"
#include "dialects/text/number.h"
#include "server/app/checks/diagnose.h"
#include "server/app/checks/timed_rendering.h"

namespace dripfeed::app {

namespace {

// "R100-R199", "#150-#160", "R5"
std::optional<optimize::NumberRange> range_of(std::string_view text) {
  constexpr std::int64_t kLargest = 99'999;
  const auto number = [](std::string_view word) -> std::optional<optimize::NumberRange> {
    if (word.size() < 2 || (word[0] != 'R' && word[0] != 'r' && word[0] != '#')) return {};
    const std::optional<std::int64_t> value = text::parse_integer(word.substr(1));
    if (!value || *value < 0 || *value > kLargest) return {};
    const auto n = static_cast<std::uint32_t>(*value);
    return optimize::NumberRange{word[0] == '#' ? ir::Bank::hash : ir::Bank::r, n, n};
  };
  const std::size_t dash = text.find('-');
  const auto first = number(text.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : number(text.substr(dash + 1));
  if (!first || !last || first->bank != last->bank || first->first > last->first) return {};
  return optimize::NumberRange{first->bank, first->first, last->last};
}

Result<void> take_ranges(const std::vector<std::string>& texts, std::vector<optimize::NumberRange>& out) {
  for (const std::string& text : texts) {
    const auto range = range_of(text);
    if (!range)
      return fail(ErrorCode::invalid,
                  fmt::format("\"{}\" is not a range of variables: write R100-R199 or #150-#160", text));
    out.push_back(*range);
  }
  return {};
}

Result<void> take_rules(const std::vector<std::string>& names, bool on, optimize::Rules& rules) {
  for (const std::string& name : names) {
    const auto rule = optimize::find_rule(name);
    if (!rule) return fail(ErrorCode::invalid, fmt::format("there is no rule \"{}\"", name));
    rules.set(*rule, on);
  }
  return {};
}

}  // namespace

Result<optimize::Settings> settings_of(const OptimizeWords& words) {
  optimize::Settings out;
  if (auto taken = take_rules(words.with, true, out.rules); !taken) return std::unexpected(taken.error());
  if (auto taken = take_rules(words.without, false, out.rules); !taken) return std::unexpected(taken.error());
  if (auto taken = take_ranges(words.own, out.own); !taken) return std::unexpected(taken.error());
  if (auto taken = take_ranges(words.free, out.free); !taken) return std::unexpected(taken.error());
  out.tolerance_mm = words.tolerance_mm;
  bool changes_path = false;
  for (std::size_t i = 0; i < optimize::kRules; ++i) {
    const auto rule = static_cast<optimize::Rule>(i);
    changes_path = changes_path || (optimize::changes_path(rule) && out.rules.has(rule));
  }
  if (changes_path && !(out.tolerance_mm > 0.0))
    return fail(ErrorCode::invalid, "the rules table, lines and arcs need a tolerance");
  if (!changes_path && out.tolerance_mm != 0.0)
    return fail(ErrorCode::invalid, "a tolerance is for the rules table, lines and arcs");
  return out;
}

Result<Optimized> optimize_case(const OptimizeOrder& order, const Documents& documents, CalledBy& called) {
  auto settings = settings_of(order.words);
  if (!settings) return std::unexpected(settings.error());
  auto opened = open_text({.dialect = order.dialect, .text = order.text, .profile = order.profile}, documents);
  if (!opened) return std::unexpected(opened.error());
  Optimized out{.opened = std::move(*opened), .source = text::Source(order.name, order.text), .cost = {}, .result = {}};
  const Examination& e = out.opened->examination;
  const compile::FindText find = [&called](std::string_view name) { return called.find(name); };
  const ir::Control control = compile::with_definitions(e.control, find);
  compile::ProgramLibrary library(control, find);
  out.cost = cost_model_of(control, e.profile);
  out.result = compile::optimize_text({.source = out.source,
                                       .control = control,
                                       .cost = out.cost,
                                       .settings = std::move(*settings),
                                       .library = &library});
  return out;
}

}  // namespace dripfeed::app

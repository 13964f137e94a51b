// Lines that are about nothing are left out: of a line that is not there, of stalls that were none.
#include "server/cli/timing_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::cli {

namespace {

constexpr std::size_t kShownStretches = 12;

std::string seconds(double value) { return text::format_fixed(value, 3); }

// With what is known of it: no one should take an assumption for a measured time.
std::string compute_text(const timing::Report& t) {
  std::string text =
      fmt::format("{} s, {} to {} s (cost model {}", seconds(t.compute_s), seconds(t.compute_s / t.cost_spread),
                  seconds(t.compute_s * t.cost_spread), ir::name_of(t.cost_source));
  if (!t.cost_origin.empty()) text += ": " + t.cost_origin;
  return text + ")";
}

std::string stretch_text(const timing::Report& report) {
  std::string text = "limited  ";
  std::string between;
  for (std::size_t i = 0; i < timing::kLimiters; ++i) {
    if (!(report.limited_s[i] > 0.0)) continue;
    text += fmt::format("{}{} {} s", between, timing::name_of(static_cast<timing::Limiter>(i)),
                        seconds(report.limited_s[i]));
    between = ", ";
  }
  text += '\n';
  if (report.stretch_count < 2) return text;
  const std::size_t shown = std::min(kShownStretches, report.stretches.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const timing::Stretch& one = report.stretches[i];
    text += fmt::format("         lines {} to {}: {}, {} s from {} s\n", one.first_line, one.last_line,
                        timing::name_of(one.limiter), seconds(one.duration_s), seconds(one.start_s));
  }
  if (report.stretch_count > shown) text += fmt::format("         and {} more\n", report.stretch_count - shown);
  return text;
}

std::string advice_text(const timing::Report& report) {
  const timing::Advice& advice = report.advice;
  std::string text;
  if (advice.baud)
    text += fmt::format("cure     {} baud or more ({})\n", text::format_fixed(*advice.baud, 0),
                        text::format_fixed(*advice.standard_baud, 0));
  if (advice.feed_share)
    text += fmt::format("cure     feeds at {} % (at most {} mm/min)\n", text::format_fixed(*advice.feed_share * 100, 1),
                        text::format_fixed(*advice.feed_mm_min, 0));
  return text.empty() ? "cure     neither a faster line nor slower feeds\n" : text;
}

}  // namespace

std::string timing_text(const timing::Report& t) {
  std::string text = fmt::format("blocks   {}\ncycle    {} s\nmotion   {} s\ncompute  {}\nline     {} s\n", t.blocks,
                                 seconds(t.cycle_s), seconds(t.motion_s), compute_text(t), seconds(t.line_s));
  text += fmt::format("stalls   {} ({} s lost", t.stalls, seconds(t.stall_s));
  if (t.stalls > 0) {
    text += fmt::format(", {} s of it standing still; first at line {}, {} s after the start", seconds(t.standstill_s),
                        t.first_stall_line, seconds(t.first_stall_at_s));
    if (t.longest_stall_s > 0.0)
      text += fmt::format("; longest standstill {} s at line {}", seconds(t.longest_stall_s), t.longest_stall_line);
  }
  text += ")\n";
  if (t.is_fed)
    text += fmt::format("buffer   never below {} bytes, {} blocks\n", t.lowest_buffer_bytes, t.lowest_buffer_blocks);
  text += stretch_text(t);
  if (t.stalls > 0) text += advice_text(t);
  for (const checks::NotChecked& one : t.not_checked.list()) text += fmt::format("note     {}\n", one.text);
  return text;
}

}  // namespace dripfeed::cli

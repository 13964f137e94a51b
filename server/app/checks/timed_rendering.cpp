// Both renderings are run and timed as a check would do it, on the machine as its profile is.
#include "server/app/checks/timed_rendering.h"

#include <algorithm>
#include <expected>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "checks/timing/timing.h"
#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/render/optimized_render.h"
#include "dialects/text/number.h"
#include "server/app/base/check_budget.h"
#include "server/app/checks/examine.h"

namespace dripfeed::app {

namespace {

constexpr double kWorthwhile = 0.01;  // of the macro's time; less is within what no forecast resolves
constexpr std::uint32_t kSeconds = 20;
constexpr std::uint64_t kMostBlocks = 100'000;  // that are tried here

class MoveCounter final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion> motions) override {
    moves_ += static_cast<std::uint64_t>(
        std::ranges::count_if(motions, [](const ir::Motion& one) { return ir::is_move(one.kind); }));
  }
  [[nodiscard]] std::uint64_t moves() const { return moves_; }

 private:
  std::uint64_t moves_ = 0;
};

struct Forecast {
  timing::Report report;
  std::uint64_t moves = 0;
};

std::expected<Forecast, std::string> forecast(const compile::RenderRequest& request, const std::string& text,
                                              const machine::Profile& profile) {
  const Examination examination{.source = text::Source(request.family.name(), text),
                                .dialect = compile::find_dialect(request.target.dialect),
                                .control = request.target,
                                .profile = &profile,
                                .delivery = request.delivery,
                                .find_called = {},
                                .geometry = {},
                                .profile_lines = {}};
  auto settings = timing_settings(examination, text);
  if (!settings) return std::unexpected(settings.error());
  timing::Timing timing(std::move(*settings));
  const ir::ReadResult read = examination.dialect->read(examination.source, examination.control);
  interpreter::RunOptions options;
  options.used_up = time_budget(kSeconds);
  MoveCounter counter;
  compile::FanOut sinks({&timing, &counter});
  if (compile::execute(read.program, examination.control, nullptr, sinks, options).ended != interpreter::Ended::end)
    return std::unexpected("it does not run to its end here");
  Forecast out{timing.finish(), counter.moves()};
  if (!out.report.is_whole) return std::unexpected("it is too long to be timed");
  return out;
}

// 4954 is "4,954".
std::string grouped(std::uint64_t count) {
  std::string text = fmt::format("{}", count);
  for (std::size_t end = text.size(); end > 3; end -= 3) text.insert(end - 3, ",");
  return text;
}

std::string times_of(const timing::Report& report) {
  const std::string stalls = report.stalls == 0   ? "no stall"
                             : report.stalls == 1 ? "1 stall"
                                                  : grouped(report.stalls) + " stalls";
  return fmt::format("{} s, {}", text::format_fixed(report.cycle_s, report.cycle_s < 100.0 ? 1 : 0), stalls);
}

}  // namespace

compile::RenderResult render_for(const compile::RenderRequest& request, const machine::Profile* profile) {
  compile::RenderResult macro = compile::render(request);
  const bool is_open = request.mode == compile::RenderMode::automatic && request.delivery == ir::Delivery::memory &&
                       macro.mode == compile::RenderMode::macro && !macro.is_kept &&
                       !text::has_error(macro.diagnostics);
  if (!is_open) return macro;
  const auto keep = [&](std::string why) {
    macro.because += "; " + std::move(why);
    return std::move(macro);
  };
  if (profile == nullptr) return keep("what it and plain blocks take is not known without a machine");
  const auto macro_time = forecast(request, macro.text, *profile);
  if (!macro_time) return keep(fmt::format("what it takes is not known: {}", macro_time.error()));
  if (macro_time->moves > kMostBlocks)
    return keep(fmt::format("plain blocks, more than {} of them, were not tried", grouped(kMostBlocks)));
  compile::RenderRequest as_blocks = request;
  as_blocks.mode = compile::RenderMode::explicit_blocks;
  compile::RenderResult blocks = compile::render(as_blocks);
  if (text::has_error(blocks.diagnostics)) {
    const auto error = std::ranges::find(blocks.diagnostics, text::Severity::error, &text::Diagnostic::severity);
    return keep(fmt::format("it cannot be plain blocks: {}", text::message_of(*error)));
  }
  const auto blocks_time = forecast(request, blocks.text, *profile);
  if (!blocks_time) return keep(fmt::format("what plain blocks take is not known: {}", blocks_time.error()));
  const bool takes_blocks = blocks_time->report.cycle_s < (1.0 - kWorthwhile) * macro_time->report.cycle_s;
  compile::RenderResult& taken = takes_blocks ? blocks : macro;
  taken.because = fmt::format("{}: macro: {}; blocks: {} (cost model {})",
                              takes_blocks ? "plain blocks are faster by the forecast for this machine"
                                           : "plain blocks would save almost no time by the forecast for this machine",
                              times_of(macro_time->report), times_of(blocks_time->report),
                              ir::name_of(macro_time->report.cost_source));
  return std::move(taken);
}

ir::CostModel cost_model_of(const ir::Control& control, const machine::Profile* profile) {
  if (profile == nullptr || !profile->machine.timing.cost) return control.cost;
  ir::CostModel cost = *profile->machine.timing.cost;
  cost.origin = profile->machine.timing.cost_origin;
  return cost;
}

void optimize_for(compile::RenderResult& rendered, const ir::Control& control, const machine::Profile& profile) {
  const ir::CostModel cost = cost_model_of(control, &profile);
  const compile::OptimizeResult made = compile::optimize_rendered(rendered, control, cost);
  std::string gained;
  if (!made.obstacle.empty())
    gained = "not optimized: " + made.obstacle;
  else if (!made.before || !made.after)
    gained = "optimized, and not verified by running it: " + made.not_verified;
  else
    gained = fmt::format("computing it takes {} ms instead of {} ms (cost model {})",
                         text::format_fixed(made.after->total_ms, 1), text::format_fixed(made.before->total_ms, 1),
                         ir::name_of(cost.source));
  rendered.because += rendered.because.empty() ? gained : "; " + gained;
}

}  // namespace dripfeed::app

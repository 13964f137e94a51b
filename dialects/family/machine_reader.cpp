// The verbs of a body that switch what the machine has: tool, spindle, coolant, compensation, feed, plane, stops; and
// messages.
#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/body_reader.h"
#include "dialects/family/message_text.h"
#include "dialects/ir/motion.h"

namespace dripfeed::family {

namespace {

constexpr std::int32_t kLargestTip = 9;
constexpr std::size_t kLongestToolName = 32;  // as SINUMERIK has it
constexpr std::int32_t kLargestOffset = 99;

}  // namespace

void BodyReader::work_offset() {
  cursor_.expect_word("offset");
  Step out = step(StepKind::work_offset);
  const text::Span at = cursor_.peek().span;
  out.number = cursor_.expect_integer("the number of a work offset");
  if (out.number > kLargestOffset) cursor_.syntax(at, fmt::format("work offsets are numbered 0 to {}", kLargestOffset));
  add(std::move(out));
}

void BodyReader::tool() {
  Step out = step(StepKind::tool);
  const Parameter* chosen = family_.find_parameter(cursor_.word());
  const text::Span at_name = cursor_.peek().span;
  if (auto name = cursor_.accept_string()) {
    out.text = std::move(*name);
    const auto may_stand = [](char c) { return c > ' ' && c <= '~' && c != '"' && c != ';' && c != '%'; };
    if (out.text.empty() || out.text.size() > kLongestToolName || !std::ranges::all_of(out.text, may_stand))
      return cursor_.syntax(
          at_name,
          fmt::format("the name of a tool has 1 to {} letters, digits and signs, and no blank", kLongestToolName));
  } else if (chosen != nullptr && chosen->kind == ParameterKind::tool) {
    out.target = chosen->symbol;
    cursor_.advance();
  } else {
    out.number = cursor_.expect_integer("the number of a tool, its name in quotes, or a parameter that is one");
  }
  if (!cursor_.line_failed() && cursor_.accept_word("nose")) out.values[2] = expressions_.value_of(kLength).id;
  if (!cursor_.line_failed() && cursor_.accept_word("tip")) {
    const text::Span at = cursor_.peek().span;
    out.tip = cursor_.expect_integer("the number of a tip, 0 to 9");
    if (out.tip > kLargestTip) cursor_.syntax(at, "tips are numbered 0 to 9");
  }
  if (!cursor_.line_failed() && cursor_.accept_word("diameter")) out.values[0] = expressions_.value_of(kLength).id;
  if (!cursor_.line_failed() && cursor_.accept_word("corner")) out.values[1] = expressions_.value_of(kLength).id;
  tool_changes(out.values[0]);
  add(std::move(out));
}

void BodyReader::spindle() {
  if (cursor_.accept_word("off")) return add(step(StepKind::spindle_off));
  Step out = step(StepKind::spindle);
  const Typed speed = expressions_.value();
  out.dimension = speed.dimension;
  if (speed.dimension != kSurfaceSpeed) expressions_.require_dimension(speed, kSpeed);
  out.values[0] = speed.id;
  surface_speed_ = speed.dimension == kSurfaceSpeed;
  if (!cursor_.line_failed() && cursor_.accept_word("limit")) {
    if (speed.dimension != kSurfaceSpeed)
      return cursor_.syntax(cursor_.last_span(), "only a surface speed has a limit");
    out.values[1] = expressions_.value_of(kSpeed).id;
  }
  if (cursor_.line_failed()) return;
  if (cursor_.accept_word("cw")) {
    out.direction = ir::Function::spindle_cw;
  } else if (cursor_.accept_word("ccw")) {
    out.direction = ir::Function::spindle_ccw;
  }
  add(std::move(out));
}

void BodyReader::coolant() {
  static constexpr std::array<std::pair<std::string_view, ir::CoolantState>, 3> kStates = {
      {{"off", ir::CoolantState::off}, {"mist", ir::CoolantState::mist}, {"flood", ir::CoolantState::flood}}};
  const auto row = std::ranges::find(kStates, cursor_.word(), &std::pair<std::string_view, ir::CoolantState>::first);
  if (row == kStates.end()) return cursor_.expected("flood, mist or off");
  cursor_.advance();
  Step out = step(StepKind::coolant);
  out.number = static_cast<std::int32_t>(row->second);
  add(std::move(out));
}

void BodyReader::compensate() {
  static constexpr std::array<std::pair<std::string_view, ir::CompSide>, 3> kSides = {
      {{"off", ir::CompSide::off}, {"left", ir::CompSide::left}, {"right", ir::CompSide::right}}};
  const auto row = std::ranges::find(kSides, cursor_.word(), &std::pair<std::string_view, ir::CompSide>::first);
  if (row == kSides.end()) return cursor_.expected("left, right or off");
  cursor_.advance();
  compensation_waits_ = true;
  compensated_ = row->second != ir::CompSide::off;
  Step out = step(StepKind::compensate);
  out.number = static_cast<std::int32_t>(row->second);
  add(std::move(out));
}

void BodyReader::feed() {
  Step out = step(StepKind::feed);
  const Typed value = expressions_.value();
  out.dimension = value.dimension;
  if (value.dimension != kFeedPerRev) expressions_.require_dimension(value, kFeedPerMin);
  out.values[0] = value.id;
  has_feed_ = true;
  feed_dimension_ = value.dimension;
  add(std::move(out));
}

// message TEXT VALUE TEXT ...
void BodyReader::message() {
  Step out = step(StepKind::message);
  if (cursor_.at_line_end()) return cursor_.expected("a text in quotes or a value");
  do {
    if (auto text = cursor_.accept_string()) {
      std::erase(*text, kValueMark);
      out.text += *text;
      continue;
    }
    if (const Scope::Name* name = scope_.find(cursor_.word()); name != nullptr && name->kind == NameKind::text) {
      ir::Variable variable;
      variable.bank = ir::Bank::named;
      variable.symbol = name->symbol;
      variable.span = cursor_.peek().span;
      word(out, ir::Address::n, {.id = family_.arena.add_variable(variable)});
      out.text += kValueMark;
      cursor_.advance();
      continue;
    }
    const Typed value = expressions_.value();
    word(out, ir::Address::n, value);  // of the words only the values count
    out.text += kValueMark;
    if (const std::string_view unit = stored_unit(value.dimension); !unit.empty()) out.text.append(" ").append(unit);
  } while (!cursor_.line_failed() && !cursor_.at_line_end());
  add(std::move(out));
}

void BodyReader::dwell() {
  Step out = step(StepKind::dwell);
  out.values[0] = expressions_.value_of(kTime).id;
  add(std::move(out));
}

// plane xy, zx or yz: of arcs and compensation, from here on.
void BodyReader::plane() {
  static constexpr std::array<std::string_view, 3> kPlanes = {"xy", "zx", "yz"};
  const auto row = std::ranges::find(kPlanes, cursor_.word());
  if (family_.machine != ir::MachineKind::mill) return cursor_.syntax(verb_, "a lathe keeps its plane of z and x");
  if (row == kPlanes.end()) return cursor_.expected("xy, zx or yz");
  if (compensation_waits_)
    return cursor_.syntax(verb_, "compensation begins and ends with a straight move, in the plane that it began in");
  cursor_.advance();
  Step out = step(StepKind::plane);
  out.number = static_cast<std::int32_t>(row - kPlanes.begin());
  other_plane_ = out.number != 0;
  add(std::move(out));
}

void BodyReader::stop() { add(step(StepKind::stop)); }

void BodyReader::optional_stop() {
  cursor_.expect_word("stop");
  add(step(StepKind::optional_stop));
}

}  // namespace dripfeed::family

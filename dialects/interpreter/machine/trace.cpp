// Formatting of motions. Kinds are a table; every number goes through text::append_fixed.
#include "dialects/interpreter/machine/trace.h"

#include <array>
#include <charconv>

#include "dialects/ir/axis_letters.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using ir::MotionKind;

constexpr int kDecimals = 4;

constexpr std::array<std::string_view, 15> kKindNames = {"rapid",   "linear",  "arc-cw",  "arc-ccw", "spline",
                                                         "thread",  "dwell",   "offset",  "tool",    "comp",
                                                         "spindle", "coolant", "message", "stop",    "end"};
constexpr std::array<std::string_view, 3> kPlanes = {" G17", " G18", " G19"};
constexpr std::array<std::string_view, 3> kFeedUnits = {"/min", "/rev", "/inv"};
constexpr std::array<std::string_view, 3> kComps = {"off", "left", "right"};
constexpr std::array<std::string_view, 3> kSpindles = {"off", "cw", "ccw"};
constexpr std::array<std::string_view, 3> kCoolants = {"off", "mist", "flood"};

template <std::size_t n, class Enum>
std::string_view name_in(const std::array<std::string_view, n>& names, Enum value) {
  return names[static_cast<std::size_t>(value)];
}

void append_integer(std::string& to, std::int64_t value) {
  std::array<char, 24> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  to.append(digits.data(), end);
}

// Quotes as they are; a line end would break the trace.
void append_quoted(std::string& to, std::string_view text) {
  to += '"';
  for (const char c : text) to += c == '\n' || c == '\r' ? ' ' : c;
  to += '"';
}

}  // namespace

TraceWriter::TraceWriter(const ir::Control& control, const RunNames& names, Consumer consumer)
    : names_(names),
      edges_(control.semantics.d_selects_edge),
      pairs_(control.semantics.tool_word == ir::ToolWord::number_and_offset),
      consumer_(std::move(consumer)) {
  for (std::size_t i = 0; i < ir::kAxisLetters.size(); ++i)
    if (control.axes.find(ir::kAxisLetters[i]) != std::string::npos) axes_.push_back(static_cast<ir::Axis>(i));
}

void TraceWriter::consume(std::span<const ir::Motion> motions) {
  for (const ir::Motion& motion : motions) write(motion);
  if (!consumer_) return;
  consumer_(text_);
  text_.clear();
}

void TraceWriter::write(const ir::Motion& motion) {
  write_head(motion);
  if (ir::is_move(motion.kind))
    write_move(motion);
  else
    write_event(motion);
  text_ += '\n';
}

void TraceWriter::write_head(const ir::Motion& motion) {
  if (const std::uint32_t program = motion.place.program; program != 0) {
    if (declared_.size() <= program) declared_.resize(program + std::size_t{1});
    if (!declared_[program]) {
      declared_[program] = true;
      text_ += '@';
      append_integer(text_, program);
      text_ += ' ';
      if (program < names_.programs.size()) text_ += names_.programs[program];
      text_ += '\n';
    }
    text_ += '@';
    append_integer(text_, program);
    text_ += ':';
  }
  append_integer(text_, motion.place.line);
  text_ += ' ';
  text_ += name_in(kKindNames, motion.kind);
}

void TraceWriter::append_word(std::string_view letter, double value) {
  text_ += ' ';
  text_ += letter;
  text::append_fixed(text_, value, kDecimals);
}

void TraceWriter::write_move(const ir::Motion& motion) {
  for (const ir::Axis axis : axes_) {
    const auto index = static_cast<std::size_t>(axis);
    append_word(ir::kAxisLetters.substr(index, 1), motion.end[index]);
  }
  if (motion.machine_coordinates) text_ += " G53";
  if (motion.kind == MotionKind::arc_cw || motion.kind == MotionKind::arc_ccw) {
    text_ += name_in(kPlanes, motion.plane);
    append_word("I", motion.center[0]);
    append_word("J", motion.center[1]);
    append_word("K", motion.center[2]);
  }
  if (motion.kind == MotionKind::rapid) return;
  append_word("F", motion.feed);
  text_ += name_in(kFeedUnits, motion.feed_mode);
  if (motion.kind != MotionKind::thread || motion.center[0] == 0.0) return;
  append_word(motion.center[0] > 0.0 ? "+" : "", motion.center[0]);
  text_ += "/rev2";
}

void TraceWriter::write_event(const ir::Motion& motion) {
  if (motion.kind == MotionKind::dwell) {
    append_word("P", motion.feed);
  } else if (motion.kind == MotionKind::offset) {
    text_ += ' ';
    append_integer(text_, motion.number);
  } else if (motion.kind == MotionKind::tool) {
    text_ += ' ';
    if (motion.text < names_.strings.size())
      append_quoted(text_, names_.strings[motion.text]);
    else
      append_integer(text_, motion.number);
    // Which number the usual offset has is the control's own matter: the tool's own (T0606), its first edge (D1), or
    // none in this word (H and D apart). T0600 takes the offset away, and that is written.
    const std::int32_t usual = pairs_ ? motion.number : edges_ ? 1 : 0;
    if (motion.tool_offset != usual && (pairs_ || motion.tool_offset != 0)) {
      text_ += " offset ";
      append_integer(text_, motion.tool_offset);
    }
  } else if (motion.kind == MotionKind::comp) {
    text_ += ' ';
    text_ += name_in(kComps, motion.comp);
  } else if (motion.kind == MotionKind::spindle) {
    text_ += ' ';
    text_ += name_in(kSpindles, motion.spindle);
    if (motion.spindle == ir::SpindleState::stopped) return;
    const bool surface = motion.surface_speed_m_min != 0.0;
    if (!surface && motion.spindle_rpm == 0.0) return;  // none was given, or it is not known
    append_word("S", surface ? motion.surface_speed_m_min : motion.spindle_rpm);
    text_ += surface ? "/m_min" : "/rpm";
    if (surface && motion.spindle_rpm != 0.0) append_word("limit ", motion.spindle_rpm);
  } else if (motion.kind == MotionKind::coolant) {
    text_ += ' ';
    text_ += name_in(kCoolants, motion.coolant);
  } else if (motion.kind == MotionKind::message) {
    text_ += ' ';
    append_quoted(text_, motion.text < names_.strings.size() ? std::string_view(names_.strings[motion.text])
                                                             : std::string_view());
  } else if (motion.kind == MotionKind::stop) {
    text_ += motion.number == 1 ? " optional" : " program";
  }
}

}  // namespace dripfeed::interpreter

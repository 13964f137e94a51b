// What a block came to, besides its motions: what it asks of the program's flow, an alarm, and what deserves a word.
#pragma once

#include <cstdint>
#include <string_view>

#include "dialects/ir/control.h"
#include "dialects/text/diagnostic_id.h"

namespace dripfeed::interpreter {

// What the block's codes ask of the program's flow; the caller follows it.
enum class Flow : std::uint8_t { next, program_end, subprogram_end };

// Bits of BlockResult::notes: what was done and deserves a word.
inline constexpr std::uint64_t kNoteShiftedIncrement = 1ULL << 32;  // setting data decides where it ends
inline constexpr std::uint64_t kNoteIdleWord = 1ULL << 33;          // a word that no code of the block takes
inline constexpr std::uint64_t kNoteCompDirection = 1ULL << 34;     // G40 I K: in which direction it ends
inline constexpr std::uint64_t kNoteThreadStart = 1ULL << 37;       // Q: at which angle of the spindle
inline constexpr std::uint64_t kNoteAxisTwice = 1ULL << 36;         // X and U: which of them is effective
inline constexpr std::uint64_t kNoteMoveAtFrameEnd = 1ULL << 35;    // G69 X: whether the axis moves
inline constexpr std::uint32_t kNoteNoFeed = 1;                     // a cut with feed 0
inline constexpr std::uint32_t kNoteMotionWithoutCode = 2;          // moved as the control usually does
inline constexpr std::uint32_t kNoteMoveNotModelled = 4;          // axis words under a cycle or curve: no move came out
inline constexpr std::uint32_t kNoteReferenceUnknown = 8;         // to a reference point whose place is not known
inline constexpr std::uint32_t kNoteIncrementalFromUnknown = 16;  // where the move ends is not known
inline constexpr std::uint32_t kNoteLevelUnknown = 32;            // drilling goes back to a level that is not known
inline constexpr std::uint32_t kNoteSkip = 128;                   // where it ends, a signal decides
inline constexpr std::uint32_t kNoteHoleWithoutDepth = 64;        // a drilling cycle without a bottom: nothing was cut
inline constexpr std::uint32_t kNoteLeadChange = 1U << 8;         // by how much a lead changes, the block does not say
inline constexpr std::uint32_t kNotePatternWithoutCycle = 1U << 9;  // a hole pattern: positions, and nothing is cut
inline constexpr std::uint32_t kNotePatternWords = 1U << 10;        // … of which a word's meaning is not certain
inline constexpr std::uint32_t kNoteCompInFrame = 1U << 11;         // the radius in a plane that the frame tilts
inline constexpr std::uint32_t kNoteMeasuringTool = 1U << 12;       // a touch ends it and sets the tool's length
inline constexpr std::uint32_t kNotePolynomialStraight = 1U << 13;  // straight to the end of a polynomial
inline constexpr std::uint32_t kNotePolynomialDiameter = 1U << 14;  // … whose coefficients are of a diameter
inline constexpr std::uint32_t kNoteFramesOfBoth = 1U << 31;        // one language changes a frame next to the other's
inline constexpr std::uint32_t kNotePolynomialAlone = 1U << 15;     // words of a polynomial (PO) without POLY
inline constexpr std::uint32_t kNoteArcNotComputed = 1U << 16;      // it begins or ends where no one knows
inline constexpr std::uint32_t kNoteArcInFrame = 1U << 17;          // the frame makes an ellipse of it
inline constexpr std::uint32_t kNoteCornerNotComputed = 1U << 18;
inline constexpr std::uint32_t kNoteMeasuring = 1U << 19;  // where the move ends, a probe decides
inline constexpr std::uint32_t kNoteSpline = 1U << 20;     // how it bends is taken as usual, and was not looked at
inline constexpr std::uint32_t kNoteArcIsLine = 1U << 21;  // neither centre nor radius: straight, as a parameter says
inline constexpr std::uint32_t kNoteCycleInFrame = 1U << 22;      // the frame turns or stretches the axis of a hole
inline constexpr std::uint32_t kNoteScaleUnit = 1U << 23;         // a parameter decides what a factor counts
inline constexpr std::uint32_t kNoteFrameValue = 1U << 24;        // a factor or angle that is left to a parameter
inline constexpr std::uint32_t kNoteDirectAngle = 1U << 25;       // an angle (,A) of which no line came
inline constexpr std::uint32_t kNoteTransformed = 1U << 26;       // a plane of X and C that its place is not known in
inline constexpr std::uint32_t kNoteMachineIncrement = 1U << 30;  // G53 with G91: no move came out
inline constexpr std::uint32_t kNoteArcUndefined = 1U << 29;      // CIP through points that no circle goes through
inline constexpr std::uint32_t kNoteContourOffset = 1U << 28;     // OFFN besides the radius that is compensated
inline constexpr std::uint32_t kNoteSplineStraight = 1U << 27;    // … straight to its point

struct BlockResult {
  Flow flow = Flow::next;
  bool moved = false;        // by its axis words, in a motion or a cycle
  bool needs_shape = false;  // G70 to G73: the caller runs the shape's blocks
  bool sets_data = false;    // G10: the caller has what it sets
  std::uint64_t notes = 0;
  // Alarm: count_ when there is none. `first` and `second` are its arguments (radii of an arc in mm). Without an alarm
  // they are radii that differ by what some machines are set to take.
  text::DiagnosticId fault = text::DiagnosticId::count_;
  double first = 0.0;
  double second = 0.0;
  std::string_view reason = {};  // … and in words, of a text that outlives the run
  ir::AlarmDetail detail = ir::AlarmDetail::none;
};

}  // namespace dripfeed::interpreter

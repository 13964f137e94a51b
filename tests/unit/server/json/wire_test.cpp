// What passed on a line as runs: by direction, pause and end of block; control characters as pictures, in ISO and EIA.
#include "server/json/wire.h"

#include <chrono>
#include <functional>
#include <string>

#include <gtest/gtest.h>

namespace dripfeed::json {
namespace {

using namespace std::chrono_literals;
using app::WireKind;
using app::WireTap;

const tape_code::DecodeTable kIso(tape_code::EighthBit::even, std::nullopt);
const tape_code::DecodeTable kEia(tape_code::EighthBit::data, tape_code::EiaSpecials{});

std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text.data(), text.size())); }

// A tap that a person watches, and what it kept.
std::vector<WireRun> runs_of(const tape_code::DecodeTable& code, const std::function<void(WireTap&)>& pass) {
  WireTap tap(code);
  const auto from = tap.join();
  pass(tap);
  return wire_runs(tap.since(from), code);
}

TEST(Wire, RunsEndWithTheBlockThePauseAndTheDirection) {
  const auto runs = runs_of(kIso, [](WireTap& tap) {
    tap.note(WireKind::out, bytes("\x47\xB1\x0A\x47"), 0ms);  // G1 LF G
    tap.note(WireKind::out, bytes("\xB2"), 50ms);             // 2
    tap.note(WireKind::out, bytes("\x4D"), 200ms);            // M, after a pause
    tap.note(WireKind::in, bytes("\x93"), 210ms);
    tap.note(WireKind::cts_off, 220ms);
  });
  ASSERT_EQ(runs.size(), 5U);
  EXPECT_EQ(runs[0].text, "G1\u240A");
  EXPECT_EQ(runs[0].hex, "47B10A");
  EXPECT_EQ(runs[1].text, "G2");
  EXPECT_EQ(runs[2].text, "M");
  EXPECT_EQ(runs[3].text, "\u2413");
  EXPECT_EQ(runs[3].kind, WireKind::in);
  EXPECT_EQ(runs[4].kind, WireKind::cts_off);
  EXPECT_EQ(runs[4].text, "");
}

TEST(Wire, WrongParityIsCountedAndStillRead) {
  const auto runs = runs_of(kIso, [](WireTap& tap) { tap.note(WireKind::in, bytes("\xC1\x41"), 0ms); });
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].text, "AA");
  EXPECT_EQ(runs[0].wrong, 1U);
}

TEST(Wire, AControlsDc3IsOneWithAndWithoutParity) {
  const auto runs = runs_of(kIso, [](WireTap& tap) { tap.note(WireKind::in, bytes("\x13\x93"), 0ms); });
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].text, "\u2413\u2413");
  EXPECT_EQ(runs[0].wrong, 0U);
}

TEST(Wire, EiaIsReadByItsOwnTable) {
  const auto runs = runs_of(kEia, [](WireTap& tap) {
    tap.note(WireKind::out, bytes("\x67\x01\x80"), 0ms);  // g 1 EOB
    tap.note(WireKind::in, bytes("\x11"), 1ms);
  });
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].text, "G1\u240A");
  EXPECT_EQ(runs[1].text, "\u2411");
}

TEST(WireTap, KeepsNothingWhileNoOneWatches) {
  WireTap tap(kIso);
  tap.note(WireKind::out, bytes("unseen"), 0ms);
  const auto from = tap.join();
  EXPECT_FALSE(tap.has(from));
  tap.note(WireKind::out, bytes("seen"), 1ms);
  EXPECT_EQ(tap.since(from).entries.size(), 4U);
  EXPECT_EQ(tap.join(), from) << "a second one sees what the first saw";
  tap.leave();
  tap.leave();
  tap.note(WireKind::out, bytes("unseen"), 2ms);
  EXPECT_FALSE(tap.has(from + 4));
}

TEST(WireTap, ASlowWatcherLosesTheOldestAndIsGivenTheirNumber) {
  WireTap tap(kIso);
  const auto from = tap.join();
  const std::string many(WireTap::kKept + 100, 'A');
  tap.note(WireKind::out, bytes(many), 0ms);
  const auto batch = tap.since(from);
  EXPECT_EQ(batch.lost, 100U);
  EXPECT_EQ(batch.entries.size(), WireTap::kMostAtOnce);
  EXPECT_EQ(tap.since(batch.from + batch.entries.size()).lost, 0U);
}

}  // namespace
}  // namespace dripfeed::json

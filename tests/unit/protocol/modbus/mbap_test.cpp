// The Modbus server without a socket: every request its answer or its exception, however it is cut, and the ends
// of a connection that is out of step.
#include "protocol/modbus/mbap.h"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dripfeed::modbus {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

// Unit 7 with 200 registers; register n holds 1000 + n.
class View final : public RegisterView {
 public:
  bool has_unit(std::uint8_t unit) override { return unit == 7; }
  bool read(std::uint8_t unit, std::uint16_t first, std::span<std::uint16_t> into) override {
    EXPECT_EQ(unit, 7);
    if (first + into.size() > 200) return false;
    for (std::size_t i = 0; i < into.size(); ++i) into[i] = static_cast<std::uint16_t>(1000 + first + i);
    return true;
  }
};

Bytes frame(std::uint16_t transaction, std::uint8_t unit, const Bytes& pdu) {
  const auto high = [](std::size_t value) { return static_cast<std::uint8_t>(value >> 8U); };
  const auto low = [](std::size_t value) { return static_cast<std::uint8_t>(value & 0xFFU); };
  Bytes all = {high(transaction), low(transaction), 0, 0, high(pdu.size() + 1), low(pdu.size() + 1), unit};
  all.insert(all.end(), pdu.begin(), pdu.end());
  return all;
}

Bytes read_request(std::uint8_t function, int first, int quantity) {
  return {function, static_cast<std::uint8_t>(first / 256), static_cast<std::uint8_t>(first % 256),
          static_cast<std::uint8_t>(quantity / 256), static_cast<std::uint8_t>(quantity % 256)};
}

// Gives all bytes in pieces of this size, sends at once what is to be sent.
Bytes talk(MbapConnection& connection, const Bytes& in, std::size_t piece, Time now) {
  Bytes out;
  std::span<const std::uint8_t> left(in);
  while (!left.empty() && connection.ended() == MbapEnd::none) {
    const auto some = std::as_bytes(left.first(std::min(piece, left.size())));
    left = left.subspan(connection.receive(some, now));
    for (const std::byte byte : connection.pending_out()) out.push_back(std::to_integer<std::uint8_t>(byte));
    connection.mark_sent(connection.pending_out().size());
  }
  return out;
}

Bytes ask(const Bytes& pdu, std::uint8_t unit = 7) {
  View view;
  MbapConnection connection(view, 0s);
  const Bytes out = talk(connection, frame(0x1234, unit, pdu), 260, 0s);
  EXPECT_EQ(connection.ended(), MbapEnd::none);
  EXPECT_GE(out.size(), kMbapHeader + 2);
  EXPECT_EQ(Bytes(out.begin(), out.begin() + 4), (Bytes{0x12, 0x34, 0, 0}));
  EXPECT_EQ(out[4] * 256U + out[5], out.size() - 6);
  EXPECT_EQ(out[6], unit);
  return {out.begin() + kMbapHeader, out.end()};
}

TEST(Mbap, ReadsRegistersByBothFunctions) {
  for (const std::uint8_t function : {std::uint8_t{3}, std::uint8_t{4}}) {
    EXPECT_EQ(ask(read_request(function, 2, 2)), (Bytes{function, 4, 0x03, 0xEA, 0x03, 0xEB}));
    EXPECT_EQ(ask(read_request(function, 0, 125)).size(), 252U);
    EXPECT_EQ(ask(read_request(function, 199, 1)), (Bytes{function, 2, 0x04, 0xAF}));
  }
}

TEST(Mbap, EveryFaultHasItsException) {
  EXPECT_EQ(ask(read_request(3, 0, 0)), (Bytes{0x83, 3}));
  EXPECT_EQ(ask(read_request(3, 0, 126)), (Bytes{0x83, 3}));
  EXPECT_EQ(ask(read_request(4, 0, 65535)), (Bytes{0x84, 3}));
  EXPECT_EQ(ask({3, 0, 0, 0}), (Bytes{0x83, 3}));
  EXPECT_EQ(ask({3, 0, 0, 0, 1, 0}), (Bytes{0x83, 3}));
  EXPECT_EQ(ask(read_request(3, 199, 2)), (Bytes{0x83, 2}));
  EXPECT_EQ(ask(read_request(3, 65535, 2)), (Bytes{0x83, 2}));
  EXPECT_EQ(ask(read_request(3, 0, 1), 8), (Bytes{0x83, 0x0B}));
  EXPECT_EQ(ask(read_request(3, 0, 1), 0), (Bytes{0x83, 0x0B}));
  for (int function = 1; function < 128; ++function) {
    if (function == 3 || function == 4) continue;
    const auto code = static_cast<std::uint8_t>(function);
    EXPECT_EQ(ask({code, 0, 0, 0, 1, 2, 0, 9}), (Bytes{static_cast<std::uint8_t>(code | 0x80), 1})) << function;
  }
}

TEST(Mbap, AnswersAllThatComesAtOnceInOrder) {
  Bytes in;
  Bytes expected;
  for (std::uint16_t i = 0; i < 40; ++i) {
    const Bytes request = i % 5 == 4 ? Bytes{6, 0, 0, 0, 1} : read_request(3, i, 1 + i * 3);
    const Bytes one = frame(i, 7, request);
    in.insert(in.end(), one.begin(), one.end());
    View view;
    MbapConnection alone(view, 0s);
    const Bytes answer = talk(alone, one, 999, 0s);
    expected.insert(expected.end(), answer.begin(), answer.end());
  }
  for (std::size_t piece = 1; piece < in.size(); piece = piece * 2 + 1) {
    View view;
    MbapConnection connection(view, 0s);
    EXPECT_EQ(talk(connection, in, piece, 0s), expected) << piece;
    EXPECT_EQ(connection.requests(), 40U);
  }
}

TEST(Mbap, TakesNoMoreWhileItsAnswersAreNotSent) {
  View view;
  MbapConnection connection(view, 0s);
  Bytes in;
  for (std::uint16_t i = 0; i < 10; ++i) {
    const Bytes one = frame(i, 7, read_request(3, 0, 125));
    in.insert(in.end(), one.begin(), one.end());
  }
  const std::size_t taken = connection.receive(std::as_bytes(std::span(in)), 0s);
  EXPECT_LT(taken, in.size());
  EXPECT_EQ(connection.receive(std::as_bytes(std::span(in)).subspan(taken), 0s), 0U);
  connection.mark_sent(connection.pending_out().size());
  EXPECT_GT(connection.receive(std::as_bytes(std::span(in)).subspan(taken), 0s), 0U);
}

TEST(Mbap, AStreamThatIsOutOfStepEnds) {
  const auto end_of = [](const Bytes& in) {
    View view;
    MbapConnection connection(view, 0s);
    EXPECT_TRUE(talk(connection, in, 3, 0s).empty());
    return connection.ended();
  };
  EXPECT_EQ(end_of({0, 1, 0, 1, 0, 6, 7, 3, 0, 0, 0, 1}), MbapEnd::protocol);
  EXPECT_EQ(end_of({0, 1, 0, 0, 0, 1, 7}), MbapEnd::length);
  EXPECT_EQ(end_of({0, 1, 0, 0, 0, 255, 7}), MbapEnd::length);
  EXPECT_EQ(end_of({0, 1, 0, 0, 1, 0, 7}), MbapEnd::length);
}

TEST(Mbap, HalfARequestAndThenSilenceEnds) {
  const Bytes request = frame(1, 7, read_request(3, 0, 1));
  for (std::size_t cut = 1; cut < request.size(); ++cut) {
    View view;
    MbapConnection connection(view, 0s);
    talk(connection, {request.begin(), request.begin() + static_cast<std::ptrdiff_t>(cut)}, 99, 5s);
    EXPECT_EQ(connection.deadline(), 5s + kRequestAtMost);
    // A byte now and then does not keep it open.
    connection.tick(5s + kRequestAtMost - 1ms);
    EXPECT_EQ(connection.ended(), MbapEnd::none);
    connection.tick(5s + kRequestAtMost);
    EXPECT_EQ(connection.ended(), MbapEnd::unfinished) << cut;
  }
  View view;
  MbapConnection idle(view, 0s);
  talk(idle, request, 1, 5s);
  idle.tick(5s + kIdleAtMost - 1ms);
  EXPECT_EQ(idle.ended(), MbapEnd::none);
  idle.tick(5s + kIdleAtMost);
  EXPECT_EQ(idle.ended(), MbapEnd::idle);
}

}  // namespace
}  // namespace dripfeed::modbus

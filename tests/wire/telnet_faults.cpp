// A client whose server answers late, wrongly, in pieces of nonsense or not at all: within the times of the protocol it
// is up or has failed, both by name, and the machine gets the client's data and nothing else. What goes to the server
// is whole, as over any TCP connection.
#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/telnet/telnet.h"

namespace dripfeed::wire {
namespace {

using namespace std::chrono_literals;
using telnet::ClientEvent;
using telnet::ClientFailure;
using telnet::ClientState;
using telnet::Time;

enum class Fault { drops, flips, falls_silent, babbles, repeats, delays };
constexpr std::size_t kFaults = 6;
constexpr Time kStep = 20ms;
// Offer and answers, and one step of ours.
constexpr Time kNamedBy = telnet::kOfferTime + telnet::kAnswerTime + kStep;

class FaultyServer {
 public:
  FaultyServer(Fault fault, std::mt19937& random)
      : fault_(fault),
        random_(random),
        silent_from_(random() % (random() % 2 == 0 ? 12 : 120)),
        delay_(random() % 8000 * 1ms) {
    server_.begin();
  }

  std::string hear(std::span<const std::byte> wire) {
    std::vector<std::byte> data(wire.size());
    const std::size_t count = server_.receive(wire, data);
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += static_cast<char>(data[i]);
    return text;
  }

  // What reaches the client by now.
  std::vector<std::byte> answer(Time now) {
    for (const std::byte byte : server_.pending_out()) spoil(byte, now);
    server_.mark_sent(server_.pending_out().size());
    std::vector<std::byte> due;
    while (!line_.empty() && line_.front().at <= now) {
      due.push_back(line_.front().byte);
      line_.erase(line_.begin());
    }
    return due;
  }

 private:
  struct Late {
    Time at;
    std::byte byte;
  };

  void spoil(std::byte byte, Time now) {
    const bool hit = random_() % 12 == 0;
    ++answers_;
    if (fault_ == Fault::falls_silent && answers_ > silent_from_) return;
    if (fault_ == Fault::drops && hit) return;
    if (fault_ == Fault::flips && hit) byte ^= static_cast<std::byte>(1U << random_() % 8);
    if (fault_ == Fault::babbles && hit) line_.push_back({now, static_cast<std::byte>(random_())});
    line_.push_back({fault_ == Fault::delays ? now + delay_ : now, byte});
    if (fault_ == Fault::repeats && hit) line_.push_back(line_.back());
  }

  Fault fault_;
  std::mt19937& random_;
  std::size_t silent_from_;
  Time delay_;
  std::size_t answers_ = 0;
  telnet::ComPortServer server_;
  std::vector<Late> line_;
};

struct Outcome {
  ClientState state = ClientState::offering;
  ClientFailure failure = ClientFailure::none;
  Time named_at{};
  bool saw_unconfirmed = false;
  bool saw_end = false;  // by an event
  std::string sent;
  std::string got;
};

void read_events(telnet::ComPortClient& client, Outcome& outcome) {
  while (const auto event = client.next_event()) {
    outcome.saw_unconfirmed = outcome.saw_unconfirmed || event->kind == ClientEvent::Kind::unconfirmed;
    outcome.saw_end =
        outcome.saw_end || event->kind == ClientEvent::Kind::up || event->kind == ClientEvent::Kind::failed;
  }
}

Outcome play(Fault fault, unsigned seed) {
  std::mt19937 random(seed);
  telnet::ComPortClient client({.baud = 9600, .data_bits = 7, .parity = telnet::LineParity::even, .stop_bits = 2});
  FaultyServer server(fault, random);
  Outcome outcome;
  client.begin(Time(0));
  for (Time now{}; now < 12s; now += kStep) {
    const std::vector<std::byte> came = server.answer(now);
    std::vector<std::byte> data(came.size());
    client.receive(came, data, now);
    client.tick(now);
    const std::string text = "G01X" + std::to_string(random() % 1000) + "\n";
    const std::size_t taken = client.send(std::as_bytes(std::span(text)));
    outcome.sent += text.substr(0, taken);
    const std::vector<std::byte> out(client.pending_out().begin(), client.pending_out().end());
    client.mark_sent(out.size());
    outcome.got += server.hear(out);
    read_events(client, outcome);
    const bool named = client.state() == ClientState::up || client.state() == ClientState::failed;
    if (named && outcome.named_at == Time{}) outcome.named_at = now;
  }
  outcome.state = client.state();
  outcome.failure = client.failure();
  return outcome;
}

TEST(TelnetFaults, EveryServerLeadsToANamedStateInTime) {
  std::map<std::pair<Fault, ClientFailure>, int> ends;
  int unconfirmed = 0;
  for (unsigned seed = 1; seed <= 1200; ++seed) {
    const auto fault = static_cast<Fault>(seed % kFaults);
    const Outcome outcome = play(fault, seed);
    const std::string where = "seed " + std::to_string(seed);
    ASSERT_TRUE(outcome.state == ClientState::up || outcome.state == ClientState::failed) << where;
    EXPECT_EQ(outcome.state == ClientState::failed, outcome.failure != ClientFailure::none) << where;
    EXPECT_LE(outcome.named_at, kNamedBy) << where;
    EXPECT_TRUE(outcome.saw_end) << where;
    EXPECT_EQ(outcome.got, outcome.sent) << where;
    ++ends[{fault, outcome.failure}];
    unconfirmed += outcome.saw_unconfirmed ? 1 : 0;
  }
  // The faults were there: some servers were believed, some were not, and some only in part.
  for (const Fault fault : {Fault::drops, Fault::babbles, Fault::repeats})
    EXPECT_GT((ends[{fault, ClientFailure::none}]), 50) << static_cast<int>(fault);
  EXPECT_GT((ends[{Fault::falls_silent, ClientFailure::no_answer}]), 10);
  EXPECT_GT((ends[{Fault::delays, ClientFailure::no_answer}]), 30);
  EXPECT_GT((ends[{Fault::flips, ClientFailure::differs}]), 10);
  EXPECT_GT(unconfirmed, 100);
}

}  // namespace
}  // namespace dripfeed::wire

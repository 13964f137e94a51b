// A packet sender and a packet receiver on a line that loses, flips, doubles, inserts, delays and falls silent, in
// virtual time; with restarts of the receiver and a cable that is pulled.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <random>
#include <string>

#include "protocol/packet/packet.h"
#include "tests/wire/packet_player.h"

namespace dripfeed::wire {

// Chances in a hundred thousand for each byte, but where said otherwise.
struct LineFaults {
  int lose = 0;
  int flip = 0;  // one bit
  int twice = 0;
  int insert = 0;     // any byte
  int burst = 0;      // this byte and up to 9 more become anything
  int delay = 0;      // the line stands still for up to 3 s
  int silence = 0;    // nothing passes for up to 60 s, in either direction
  int restart = 0;    // in a thousand for each frame: the receiver was switched off and begins again
  int link_down = 0;  // in a thousand for each frame: the sender's link is lost
  int full = 0;       // in a hundred for each frame: the receiver has no room for up to 30 s
  int stop = 0;       // in a hundred for each frame: a person stops, and resumes up to 60 s later
  int cancel = 0;     // in a hundred for each frame
};

class PacketPair {
 public:
  PacketPair(const packet::Settings& settings, const LineFaults& faults, unsigned seed);

  // Until the job is over, at most three hours of virtual time; a fault is reported through GoogleTest.
  void play();

  packet::Sender& sender() { return *sender_; }
  packet::Receiver& receiver() { return *receiver_; }
  const std::string& text() const { return text_; }
  const std::string& received() const { return sink_.text; }
  std::uint64_t faults_made() const { return faults_made_; }
  bool receiver_restarted() const { return restarted_; }
  // What arrived is the text, its blocks filled up at the end.
  bool same() const;
  bool is_beginning() const;

 private:
  struct Arrival {
    packet::Time at;
    std::byte byte;
  };
  using Wire = std::deque<Arrival>;

  bool chance(int parts, int of) { return static_cast<int>(random_() % static_cast<unsigned>(of)) < parts; }
  packet::Time up_to(packet::Time most);
  void put(Wire& wire, std::byte byte);
  void pump();
  void frame_passed();
  void arrive(Wire& wire, bool at_receiver);
  packet::Time next_time() const;
  void check_named();
  bool over() const;
  void make_receiver();

  packet::Settings settings_;
  LineFaults faults_;
  std::mt19937 random_;
  std::string text_;
  std::optional<packet::Sender> sender_;
  RoomySink sink_;
  std::optional<packet::Receiver> receiver_;
  std::unique_ptr<tape_code::SpanSource> source_;
  Wire to_receiver_;
  Wire to_sender_;
  packet::Time now_{1'000'000'000};
  packet::Time line_free_{};
  packet::Time silent_until_{};
  packet::Time room_at_{};
  packet::Time resume_at_{};
  int burst_left_ = 0;
  std::uint64_t faults_made_ = 0;
  std::uint64_t frames_ = 0;
  bool restarted_ = false;
};

}  // namespace dripfeed::wire

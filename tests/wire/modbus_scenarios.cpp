// Thousands of seeded runs of both sides of the mailbox over a bus that loses, repeats, delays, tears and damages, with
// restarts of either side: the receiver's text is the sender's, byte for byte, or the sender stops and names why.
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/modbus/modbus.h"

namespace dripfeed::wire {
namespace {

using namespace modbus;
using namespace std::chrono_literals;

// Chances in a thousand for each request or step.
struct Faults {
  int drop_request = 0;
  int drop_answer = 0;
  int duplicate = 0;
  int late = 0;      // an earlier write is applied once more, later
  int torn = 0;      // only some registers of a write arrive, in any order of looking
  int flip = 0;      // one bit of a write changes in transit
  int garble = 0;    // one bit of a status changes in transit
  int swap = 0;      // two words of a write, or the bytes of all, change places
  int exchange = 0;  // a write brings the status with it
  int full = 0;      // the receiver cannot store a block
  int restart_sender = 0;
  int restart_receiver = 0;
  bool receiver_forgets = false;
  int abort = 0;
  int hold = 0;
};

class Text final : public TextSink {
 public:
  explicit Text(std::mt19937& random, int full) : random_(&random), full_(full) {}
  void clear() noexcept override { text.clear(); }
  bool append(std::span<const std::byte> bytes) noexcept override {
    if (static_cast<int>((*random_)() % 1000) < full_) return false;
    for (const std::byte byte : bytes) text += static_cast<char>(byte);
    return true;
  }
  std::string text;

 private:
  std::mt19937* random_;
  int full_;
};

class Pieces final : public tape_code::TextSource {
 public:
  Pieces(const std::string& text, unsigned seed) : text_(text), random_(seed) {}
  tape_code::TextPiece next() noexcept override {
    if (given_ == text_.size()) return {.status = tape_code::SourceStatus::end};
    if (random_() % 4 == 0) return {.status = tape_code::SourceStatus::not_ready};
    const std::size_t count = std::min<std::size_t>(1 + random_() % 300, text_.size() - given_);
    given_ += count;
    return {.status = tape_code::SourceStatus::text, .text = std::span(text_).subspan(given_ - count, count)};
  }

 private:
  const std::string& text_;
  std::mt19937 random_;
  std::size_t given_ = 0;
};

std::string random_text(std::mt19937& random, std::size_t size) {
  std::string text = "%\n";
  while (text.size() < size) {
    for (std::size_t i = random() % (random() % 20 == 0 ? 600 : 40); i > 0; --i) {
      text += static_cast<char>('0' + random() % 43);
    }
    text += '\n';
  }
  return text + "M30\n%\n";
}

class Transfer {
 public:
  Transfer(const Faults& faults, unsigned seed)
      : faults_(faults),
        random_(seed),
        seed_(seed),
        text_(random_text(random_, 200 + random_() % 6000)),
        sink_(random_, faults.full),
        receiver_(std::make_unique<Receiver>(sink_, boot_)),
        sender_(std::make_unique<Sender>(settings())) {
    start(false);
  }

  void play() {
    for (int steps = 0; steps < 60'000; ++steps) {
      if (sender_->state() == SenderState::done || sender_->state() == SenderState::stopped ||
          sender_->state() == SenderState::aborted) {
        return;
      }
      step();
      // Never anything but the first bytes of the text, in order, once.
      ASSERT_TRUE(text_.starts_with(sink_.text)) << "seed " << seed_;
      ASSERT_GE(sender_->counters().handed, sender_->counters().confirmed);
      ASSERT_LE(sender_->counters().handed, reserve_) << "seed " << seed_;
    }
  }

  Sender& sender() { return *sender_; }
  Receiver& receiver() { return *receiver_; }
  const std::string& text() const { return text_; }
  const std::string& received() const { return sink_.text; }
  std::uint16_t boots() const { return boot_; }
  modbus::Time now() const { return now_; }

 private:
  static SenderSettings settings() { return {.poll = 5ms, .rewrite_after = 100ms, .gone_after = 60s}; }

  bool chance(int permille) { return static_cast<int>(random_() % 1000) < permille; }

  void start(bool resume) {
    source_ = std::make_unique<Pieces>(text_, static_cast<unsigned>(random_()));
    const SenderJob job{.source = source_.get(), .text_bytes = text_.size(), .session = 77, .reserve = reserve_};
    const auto begun = resume ? sender_->resume(job, journaled_boot_, now_) : sender_->start(job, now_);
    ASSERT_TRUE(begun);
  }

  void step() {
    now_ += 1ms;
    live();
    if (chance(faults_.restart_sender)) return restart_sender();
    if (chance(faults_.restart_receiver)) restart_receiver();
    if (chance(faults_.abort)) static_cast<void>(sender_->command(SenderCommand::abort, now_));
    if (chance(faults_.hold)) static_cast<void>(sender_->command(SenderCommand::hold, now_));
    if (sender_->state() == SenderState::held || chance(faults_.hold)) {
      static_cast<void>(sender_->command(SenderCommand::release, now_));
    }
    if (chance(50)) {
      reserve_ = std::max<std::uint64_t>(reserve_, sender_->counters().confirmed + 300 + random_() % 1000);
      sender_->extend_reserve(reserve_, now_);
    }
    while (const auto event = sender_->next_event()) {
      if (event->kind == SenderEventKind::opened) journaled_boot_ = event->boot_counter;
    }
    const auto request = sender_->next_request(now_);
    if (!request) return;
    if (request->kind == Request::Kind::read_status) return read();
    write(*request);
  }

  // The receiver's own life: credit, progress, heartbeat.
  void live() {
    if (!chance(200)) return;
    receiver_->beat();
    receiver_->set_free_blocks(static_cast<std::uint16_t>(random_() % 4));
    receiver_->set_consumed(receiver_->status().consumed + static_cast<std::uint32_t>(random_() % 400));
  }

  void write(const Request& request) {
    std::vector<std::uint16_t> registers(request.registers.begin(), request.registers.end());
    if (chance(faults_.drop_request)) return sender_->request_failed(now_ += 50ms);
    if (chance(faults_.late) && !earlier_.empty()) receiver_->written(0, earlier_[random_() % earlier_.size()]);
    earlier_.push_back(registers);
    if (faults_.swap > 0 && chance(faults_.swap)) swap(registers);
    if (chance(faults_.flip))
      registers[random_() % registers.size()] ^= static_cast<std::uint16_t>(1U << (random_() % 16));
    if (chance(faults_.torn)) {
      tear(registers);
      return chance(500) ? sender_->request_failed(now_ += 50ms) : sender_->written(now_);
    }
    receiver_->written(0, registers);
    if (chance(faults_.duplicate)) receiver_->written(0, registers);
    if (chance(faults_.drop_answer)) return sender_->request_failed(now_ += 50ms);
    if (faults_.exchange > 0 && chance(faults_.exchange)) {
      sender_->exchanged(receiver_->status_image(), now_);
    } else {
      sender_->written(now_);
    }
  }

  void swap(std::vector<std::uint16_t>& registers) {
    if (chance(300)) {
      for (std::uint16_t& value : registers) value = static_cast<std::uint16_t>(value << 8U | value >> 8U);
    } else {
      const std::size_t at = random_() % (registers.size() - 1);
      std::swap(registers[at], registers[at + 1]);
    }
  }

  // Some registers arrive, the receiver looks in between, the others never come.
  void tear(const std::vector<std::uint16_t>& registers) {
    for (std::size_t i = 0; i < registers.size(); ++i) {
      if (chance(500)) receiver_->written(i, {&registers[i], 1});
    }
  }

  void read() {
    if (chance(faults_.drop_request) || chance(faults_.drop_answer)) return sender_->request_failed(now_ += 50ms);
    StatusImage image = receiver_->status_image();
    if (chance(faults_.garble))
      image[1 + random_() % (image.size() - 1)] ^= static_cast<std::uint16_t>(1U << (random_() % 16));
    sender_->status_read(image, now_);
  }

  void restart_sender() {
    now_ += 1s;
    const SenderState was = sender_->state();
    sender_ = std::make_unique<Sender>(settings());
    const bool opened = receiver_->status().session == 77;
    if (was == SenderState::aborting) return;
    start(opened);
  }

  void restart_receiver() {
    const ReceiverMemory memory = faults_.receiver_forgets ? ReceiverMemory{} : receiver_->memory();
    receiver_ = std::make_unique<Receiver>(sink_, ++boot_, memory);
  }

  Faults faults_;
  std::mt19937 random_;
  unsigned seed_;
  std::string text_;
  std::uint16_t boot_ = 1;
  std::uint16_t journaled_boot_ = 1;
  Text sink_;
  std::unique_ptr<Receiver> receiver_;
  std::unique_ptr<Pieces> source_;
  std::unique_ptr<Sender> sender_;
  std::uint64_t reserve_ = 500;
  std::vector<std::vector<std::uint16_t>> earlier_;
  modbus::Time now_ = 1s;
};

TEST(ModbusScenarios, ABusThatLosesRepeatsDelaysAndTearsChangesNothing) {
  const std::vector<Faults> kinds{
      {},
      {.drop_request = 200},
      {.drop_answer = 200},
      {.duplicate = 500},
      {.late = 300},
      {.torn = 200},
      {.flip = 200},
      {.garble = 200},
      {.full = 300},
      {.swap = 300},
      {.exchange = 1000},
      {.drop_answer = 100, .torn = 100, .flip = 100, .exchange = 500, .hold = 10},
      {.hold = 30},
      {.drop_request = 50,
       .drop_answer = 50,
       .duplicate = 50,
       .torn = 50,
       .flip = 50,
       .garble = 50,
       .full = 50,
       .hold = 5},
  };
  std::uint64_t rewrites = 0;
  for (const Faults& faults : kinds) {
    for (unsigned seed = 1; seed <= 100; ++seed) {
      Transfer run(faults, seed);
      run.play();
      ASSERT_EQ(run.sender().state(), SenderState::done)
          << "seed " << seed << " " << name(run.sender().stop_reason()) << " kind " << (&faults - kinds.data());
      ASSERT_EQ(run.received(), run.text()) << "seed " << seed;
      EXPECT_EQ(run.sender().counters().confirmed, run.text().size());
      rewrites += run.sender().counters().rewrites;
    }
  }
  EXPECT_GT(rewrites, 1000U);
}

// A PLC that shows its registers with swapped bytes, or 32-bit values with the low word first, gets nothing.
TEST(ModbusScenarios, AnotherOrderOfBytesOrWordsIsSeenBeforeAnythingIsWritten) {
  for (const bool bytes : {false, true}) {
    std::mt19937 random(1);
    Text sink(random, 0);
    Receiver receiver(sink, 1);
    StatusImage image = receiver.status_image();
    if (bytes) {
      for (std::uint16_t& value : image) value = static_cast<std::uint16_t>(value << 8U | value >> 8U);
    } else {
      std::swap(image[17], image[18]);  // the check sum; the other long words are 0 still
    }
    Sender sender({});
    const std::string text = "%\nM30\n%\n";
    tape_code::SpanSource source(text);
    ASSERT_TRUE(sender.start({.source = &source, .text_bytes = text.size(), .session = 9, .reserve = UINT64_MAX}, 1s));
    const auto request = sender.next_request(1s);
    ASSERT_TRUE(request);
    EXPECT_EQ(request->kind, Request::Kind::read_status);
    sender.status_read(image, 1s);
    EXPECT_EQ(sender.state(), SenderState::stopped);
    EXPECT_EQ(sender.stop_reason(), StopReason::foreign_registers);
    EXPECT_FALSE(sender.next_request(2s));
  }
}

TEST(ModbusScenarios, ARestartOfTheHostGoesOnWhereTheReceiverIs) {
  int restarts_done = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    Transfer run({.drop_request = 20, .drop_answer = 20, .torn = 20, .restart_sender = 2}, seed);
    run.play();
    ASSERT_EQ(run.sender().state(), SenderState::done) << "seed " << seed << " " << name(run.sender().stop_reason());
    ASSERT_EQ(run.received(), run.text()) << "seed " << seed;
    ++restarts_done;
  }
  EXPECT_EQ(restarts_done, 400);
}

// A host that died leaves a session open. Another job takes its place only on a person's word, and then its text is the
// receiver's, whole and alone.
TEST(ModbusScenarios, ASessionThatIsLeftOpenGoesOnAPersonsWordAlone) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::mt19937 random(seed);
    Text sink(random, 0);
    Receiver receiver(sink, 1);
    const std::string text = random_text(random, 200 + random() % 3000);
    const auto run = [&](Sender& sender, int steps) {
      modbus::Time now = 1s;
      for (int i = 0; i < steps && polls(sender.state()); ++i) {
        receiver.set_free_blocks(4);
        receiver.set_consumed(UINT32_MAX);
        const auto request = sender.next_request(now);
        if (!request) {
          now += 1ms;
        } else if (request->kind == Request::Kind::read_status) {
          sender.status_read(receiver.status_image(), now);
        } else {
          receiver.written(0, request->registers);
          sender.exchanged(receiver.status_image(), now);
        }
      }
    };
    const auto start = [&](Sender& sender, tape_code::SpanSource& source, std::uint32_t session, bool take_over) {
      return sender
          .start({.source = &source,
                  .text_bytes = text.size(),
                  .session = session,
                  .reserve = UINT64_MAX,
                  .take_over = take_over},
                 1s)
          .has_value();
    };
    tape_code::SpanSource first_source(text);
    Sender dies({});
    ASSERT_TRUE(start(dies, first_source, 5, false));
    run(dies, 4);
    ASSERT_TRUE(polls(dies.state()));
    ASSERT_FALSE(sink.text.empty());
    tape_code::SpanSource second_source(text);
    Sender second({});
    ASSERT_TRUE(start(second, second_source, 6, false));
    run(second, 100'000);
    ASSERT_EQ(second.state(), SenderState::stopped);
    ASSERT_EQ(second.stop_reason(), StopReason::session_running);
    ASSERT_EQ(receiver.status().session, 5U);
    tape_code::SpanSource third_source(text);
    ASSERT_TRUE(start(second, third_source, 7, true));
    run(second, 100'000);
    ASSERT_EQ(second.state(), SenderState::done) << name(second.stop_reason());
    ASSERT_EQ(sink.text, text);
  }
}

TEST(ModbusScenarios, ARestartOfTheReceiverStopsTheSender) {
  std::map<StopReason, int> reasons;
  int done = 0;
  for (const bool forgets : {false, true}) {
    for (unsigned seed = 1; seed <= 400; ++seed) {
      Transfer run({.drop_answer = 20, .duplicate = 20, .restart_receiver = 3, .receiver_forgets = forgets}, seed);
      run.play();
      const SenderState end = run.sender().state();
      ASSERT_TRUE(end == SenderState::stopped || end == SenderState::done) << "seed " << seed << " " << name(end);
      if (end == SenderState::done) {
        ASSERT_EQ(run.received(), run.text()) << "seed " << seed;
        ++done;
        continue;
      }
      ++reasons[run.sender().stop_reason()];
      ASSERT_TRUE(run.text().starts_with(run.received()));
      EXPECT_FALSE(run.sender().next_request(run.now() + 1h)) << "a stopped sender asked for something";
    }
  }
  EXPECT_GT(reasons[StopReason::receiver_restarted], 100);
  EXPECT_GT(reasons[StopReason::other_session], 100);
  EXPECT_EQ(reasons.size(), 2U);
  EXPECT_GT(done, 10);
}

TEST(ModbusScenarios, AnAbortEndsTheSessionOnBothSides) {
  int aborted = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    Transfer run({.drop_request = 100, .drop_answer = 100, .abort = 3}, seed);
    run.play();
    if (run.sender().state() == SenderState::done) continue;
    ASSERT_EQ(run.sender().state(), SenderState::aborted) << "seed " << seed;
    EXPECT_EQ(run.receiver().status().state, ReceiverState::idle) << "seed " << seed;
    ASSERT_TRUE(run.text().starts_with(run.received()));
    ++aborted;
  }
  EXPECT_GT(aborted, 60);
}

TEST(ModbusScenarios, TheNumberWrapsFrom65535To1) {
  std::mt19937 random(1);
  Text sink(random, 0);
  Receiver receiver(sink, 1);
  Sender sender({.poll = 1ms, .max_payload = 2});
  std::string text;
  for (int i = 0; i < 70'000; ++i) text += std::string(1, static_cast<char>('A' + i % 26)) + "\n";
  tape_code::SpanSource source(text);
  modbus::Time now = 1s;
  ASSERT_TRUE(sender.start({.source = &source, .text_bytes = text.size(), .session = 5, .reserve = UINT64_MAX}, now));
  while (sender.state() != SenderState::done && sender.state() != SenderState::stopped) {
    receiver.set_free_blocks(1);
    receiver.set_consumed(UINT32_MAX);
    const auto request = sender.next_request(now);
    if (!request) {
      now += 1ms;
    } else if (request->kind == Request::Kind::read_status) {
      sender.status_read(receiver.status_image(), now);
    } else {
      receiver.written(0, request->registers);
      sender.written(now);
    }
    while (sender.next_event()) {
    }
  }
  EXPECT_EQ(sender.state(), SenderState::done) << name(sender.stop_reason());
  EXPECT_EQ(sink.text, text);
}

}  // namespace
}  // namespace dripfeed::wire

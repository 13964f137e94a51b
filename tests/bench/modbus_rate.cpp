// Blocks a second over Modbus TCP on loopback: libmodbus writing 120 registers and nothing else, against the mailbox
// with its blocks of 121 registers, each appended exactly once. One server thread for both (libmodbus). The wake-up of
// a waiting thread costs more than all else, so both must run under the same pinning:
//   cmake --build build/dev --target modbus_rate && taskset -c 0 build/dev/modbus_rate 100000
// With a second number one more transfer, whose server is killed and restarted so often, at random requests, before or
// after what they do; a person's "proceed" follows each restart:
//   taskset -c 0 build/dev/modbus_rate 20000 300
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <modbus.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "protocol/modbus/modbus.h"
#include "server/io/modbus_bus.h"

namespace {

using namespace dripfeed;
using Clock = std::chrono::steady_clock;

constexpr int kRawRegisters = 120;

class Text final : public modbus::TextSink {
 public:
  void clear() noexcept override { text.clear(); }
  bool append(std::span<const std::byte> bytes) noexcept override {
    for (const std::byte byte : bytes) text += static_cast<char>(byte);
    return true;
  }
  std::string text;
};

// What a server keeps over its restarts, all in one step or not at all.
struct Kept {
  Text text;
  modbus::ReceiverMemory memory;
  std::uint16_t boots = 0;
};

// Answers one client after the other from its registers; a write into the mailbox is judged before the answer. `lives`:
// so many requests, then it is killed, the last one done or not; 0: for ever.
class Server {
 public:
  explicit Server(Kept& kept, std::uint16_t port = 0, std::uint64_t lives = 0, bool does_last = false)
      : kept_(kept),
        lives_(lives),
        does_last_(does_last),
        context_(modbus_new_tcp("127.0.0.1", port)),
        mapping_(modbus_mapping_new(0, 0, 256, 0)),
        receiver_(kept.text, ++kept.boots, kept.memory) {
    listener_ = modbus_tcp_listen(context_, 1);
    thread_ = std::thread([this] { loop(); });
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server() {
    stopping_ = true;
    ::shutdown(listener_, SHUT_RDWR);
    thread_.join();
    ::close(listener_);
    kept_.memory = receiver_.memory();
    modbus_mapping_free(mapping_);
    modbus_free(context_);
  }
  [[nodiscard]] std::uint16_t port() const {
    sockaddr_in address{};
    socklen_t length = sizeof(address);
    // The socket interface takes every address by this type.
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &length);
    return ntohs(address.sin_port);
  }
  [[nodiscard]] bool is_dead() const { return dead_; }

 private:
  void loop() {
    while (!stopping_ && !dead_) {
      int listener = listener_;
      if (modbus_tcp_accept(context_, &listener) < 0) continue;
      std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> query{};
      for (int length = 0; (length = modbus_receive(context_, query.data())) > 0;) {
        const bool last = lives_ > 0 && --lives_ == 0;
        if (!last || does_last_) take(query);
        dead_ = last;
        if (last || modbus_reply(context_, query.data(), length, mapping_) < 0) break;
      }
      modbus_close(context_);
    }
  }
  // FC23 alone; a raw FC16 is what it is.
  void take(const std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH>& query) {
    receiver_.set_free_blocks(8);
    receiver_.set_consumed(UINT32_MAX);
    if (query[7] == MODBUS_FC_WRITE_AND_READ_REGISTERS) {
      const std::size_t count = query[14] * 256U + query[15];
      std::array<std::uint16_t, modbus::kMailboxRegisters> words{};
      for (std::size_t i = 0; i < std::min(count, words.size()); ++i)
        words[i] = static_cast<std::uint16_t>(query[17 + 2 * i] * 256U + query[18 + 2 * i]);
      receiver_.written(query[12] * 256U + query[13], std::span(words).first(std::min(count, words.size())));
    }
    std::ranges::copy(receiver_.status_image(), mapping_->tab_registers + app::kStatusAddress);
  }

  Kept& kept_;
  std::uint64_t lives_;
  bool does_last_;
  modbus_t* context_;
  modbus_mapping_t* mapping_;
  int listener_ = -1;
  std::atomic<bool> stopping_{false};
  std::atomic<bool> dead_{false};
  modbus::Receiver receiver_;
  std::thread thread_;  // last: it uses all of the above
};

double seconds_since(Clock::time_point begun) { return std::chrono::duration<double>(Clock::now() - begun).count(); }

long long percent(double ratio) { return std::llround(ratio * 100.0); }

double raw_rate(int blocks) {
  Kept kept;
  const Server server(kept);
  modbus_t* const context = modbus_new_tcp("127.0.0.1", server.port());
  const std::vector<std::uint16_t> registers(kRawRegisters, 0x4142);
  bool ok = modbus_connect(context) == 0;
  const auto begun = Clock::now();
  for (int i = 0; i < blocks && ok; ++i)
    ok = modbus_write_registers(context, 0, kRawRegisters, registers.data()) == kRawRegisters;
  const double rate = blocks / seconds_since(begun);
  modbus_close(context);
  modbus_free(context);
  return ok ? rate : 0.0;
}

// A transfer as a line drives it, in turns on the bus's thread.
class Transfer final : public app::BusUser {
 public:
  explicit Transfer(const std::string& text) : source_(text) {
    begun_ = sender_.start({.source = &source_, .text_bytes = text.size(), .session = 7, .reserve = UINT64_MAX}, now())
                 .has_value();
  }
  [[nodiscard]] bool begun() const { return begun_; }
  void await_end() { over_.wait(false); }
  [[nodiscard]] bool is_over() const { return over_; }
  [[nodiscard]] bool is_done() const { return done_; }
  [[nodiscard]] int proceeded() const { return proceeded_; }

  std::optional<std::chrono::nanoseconds> turn(app::RegisterBus& bus) override {
    while (sender_.next_event()) {
    }
    // A person says that the server's restart is known.
    if (sender_.state() == modbus::SenderState::stopped &&
        sender_.stop_reason() == modbus::StopReason::receiver_restarted &&
        sender_.command(modbus::SenderCommand::proceed, now()))
      ++proceeded_;
    if (sender_.state() == modbus::SenderState::done || sender_.state() == modbus::SenderState::stopped) {
      done_ = sender_.state() == modbus::SenderState::done;
      over_ = true;
      over_.notify_all();
      return std::nullopt;
    }
    const auto request = sender_.next_request(now());
    if (!request) return std::max(sender_.deadline().value_or(now()) - now(), modbus::Time(0));
    // As far as the machine's words, like a line that has them.
    std::array<std::uint16_t, modbus::kStatusAndMachine> image{};
    const auto status = std::span<const std::uint16_t>(image).first(modbus::kStatusRegisters);
    if (request->kind == modbus::Request::Kind::read_status) {
      if (bus.read(app::kStatusAddress, image)) {
        sender_.status_read(status, now());
      } else {
        sender_.request_failed(now());
      }
    } else if (const auto exchanged =
                   bus.exchange(app::kMailboxAddress, request->registers, app::kStatusAddress, image);
               !exchanged) {
      sender_.request_failed(now());
    } else if (*exchanged) {
      sender_.exchanged(status, now());
    } else {
      sender_.written(now());
    }
    return std::chrono::nanoseconds(0);
  }

 private:
  static modbus::Time now() { return Clock::now().time_since_epoch(); }
  tape_code::SpanSource source_;
  modbus::Sender sender_{modbus::SenderSettings{}};
  bool begun_ = false;
  std::atomic<int> proceeded_{0};
  std::atomic<bool> done_{false};
  std::atomic<bool> over_{false};
};

// One line a block.
std::string program_of(int blocks) {
  std::string text;
  for (int i = 0; i < blocks; ++i) {
    std::string line = fmt::format("N{} ", i);
    line.append(modbus::kMaxPayload - 1 - line.size(), 'X');
    text += line + "\n";
  }
  return text;
}

machine::LinkUrl url_at(std::uint16_t port) {
  auto url = machine::parse_link_url("modbus-tcp://127.0.0.1:502/1").value();
  url.port = port;
  return url;
}

// 0 where the server's text is not the program.
double mailbox_rate(int blocks) {
  Kept kept;
  const Server server(kept);
  const std::string text = program_of(blocks);
  Transfer transfer(text);
  if (!transfer.begun()) return 0;
  const auto begun = Clock::now();
  const auto seat = io::take_modbus_seat(url_at(server.port()), transfer);
  if (!seat) return 0;
  transfer.await_end();
  const double rate = blocks / seconds_since(begun);
  return kept.text.text == text ? rate : 0.0;
}

// Whether every byte is there once and in order.
bool survives(int blocks, int kills) {
  Kept kept;
  std::mt19937 random(7);
  const std::string text = program_of(blocks);
  Transfer transfer(text);
  const auto lives = [&] { return 1 + random() % (2 * static_cast<unsigned>(blocks) / static_cast<unsigned>(kills)); };
  std::optional<Server> server(std::in_place, kept, std::uint16_t{0}, lives(), random() % 2 == 0);
  const std::uint16_t port = server->port();
  const auto begun = Clock::now();
  const auto seat = io::take_modbus_seat(url_at(port), transfer);
  if (!seat || !transfer.begun()) return false;
  int killed = 0;
  while (!transfer.is_over()) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    if (!server->is_dead()) continue;
    ++killed;
    server.reset();
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 20));
    server.emplace(kept, port, killed < kills ? lives() : 0, random() % 2 == 0);
  }
  const bool same = transfer.is_done() && kept.text.text == text;
  fmt::print("{} blocks, server killed {} times, {} times proceeded, {} s: {}\n", blocks, killed, transfer.proceeded(),
             std::llround(seconds_since(begun)), same ? "every byte exactly once" : "THE TEXT DIFFERS");
  return same;
}

}  // namespace

int main(int argc, char** argv) {
  const int blocks = argc > 1 ? std::atoi(argv[1]) : 100'000;
  const int kills = argc > 2 ? std::atoi(argv[2]) : 0;
  constexpr int kRuns = 5;
  std::vector<double> ratios;
  for (int run = 0; run < kRuns; ++run) {
    const double raw = raw_rate(blocks);
    const double mailbox = mailbox_rate(blocks);
    if (raw == 0.0 || mailbox == 0.0) return 1;
    ratios.push_back(mailbox / raw);
    fmt::print("raw FC16 {}/s, exactly once {}/s, ratio {} %\n", std::llround(raw), std::llround(mailbox),
               percent(mailbox / raw));
  }
  std::ranges::sort(ratios);
  fmt::print("ratio, middle of {}: {} %\n", kRuns, percent(ratios[kRuns / 2]));
  return kills == 0 || survives(blocks, kills) ? 0 : 1;
}

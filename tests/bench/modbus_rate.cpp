// Blocks a second over Modbus TCP on loopback: libmodbus writing 120 registers and nothing else, against the mailbox
// with its blocks of 121 registers, each appended exactly once. One server thread for both (libmodbus). The wake-up of
// a waiting thread costs more than all else, so both must run under the same pinning:
//   cmake --build build/release --target modbus_rate && taskset -c 0 build/release/tests/bench/modbus_rate 100000
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
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

// Answers one client after the other from its registers; a write into the mailbox is judged before the answer.
class Server {
 public:
  Server() : context_(modbus_new_tcp("127.0.0.1", 0)), mapping_(modbus_mapping_new(0, 0, 256, 0)) {
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
  [[nodiscard]] const std::string& text() const { return text_.text; }

 private:
  void loop() {
    while (!stopping_) {
      int listener = listener_;
      if (modbus_tcp_accept(context_, &listener) < 0) continue;
      std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> query{};
      for (int length = 0; (length = modbus_receive(context_, query.data())) > 0;) {
        take(query);
        if (modbus_reply(context_, query.data(), length, mapping_) < 0) break;
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

  modbus_t* context_;
  modbus_mapping_t* mapping_;
  int listener_ = -1;
  std::atomic<bool> stopping_{false};
  Text text_;
  modbus::Receiver receiver_{text_, 1};
  std::thread thread_;  // last: it uses all of the above
};

double seconds_since(Clock::time_point begun) { return std::chrono::duration<double>(Clock::now() - begun).count(); }

long long percent(double ratio) { return std::llround(ratio * 100.0); }

double raw_rate(int blocks) {
  const Server server;
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

// One whole transfer as a line drives it; 0 where the server's text is not the program.
double mailbox_rate(int blocks) {
  const Server server;
  auto url = machine::parse_link_url("modbus-tcp://127.0.0.1:502/1").value();
  url.port = server.port();
  const auto bus = io::make_modbus_bus(url);
  std::string text;
  const std::string line(modbus::kMaxPayload - 1, 'X');  // one line a block
  for (int i = 0; i < blocks; ++i) text += line + "\n";
  tape_code::SpanSource source(text);
  modbus::Sender sender({});
  const auto now = [] { return modbus::Time(Clock::now().time_since_epoch()); };
  if (!sender.start({.source = &source, .text_bytes = text.size(), .session = 7, .reserve = UINT64_MAX}, now()))
    return 0;
  const auto begun = Clock::now();
  while (sender.state() != modbus::SenderState::done && sender.state() != modbus::SenderState::stopped) {
    while (sender.next_event()) {
    }
    const auto request = sender.next_request(now());
    modbus::StatusImage status{};
    if (!request) {
      std::this_thread::yield();
    } else if (request->kind == modbus::Request::Kind::read_status) {
      if (bus->read(app::kStatusAddress, status)) {
        sender.status_read(status, now());
      } else {
        sender.request_failed(now());
      }
    } else if (const auto exchanged =
                   bus->exchange(app::kMailboxAddress, request->registers, app::kStatusAddress, status);
               !exchanged) {
      sender.request_failed(now());
    } else if (*exchanged) {
      sender.exchanged(status, now());
    } else {
      sender.written(now());
    }
  }
  const double rate = blocks / seconds_since(begun);
  return server.text() == text ? rate : 0.0;
}

}  // namespace

int main(int argc, char** argv) {
  const int blocks = argc > 1 ? std::atoi(argv[1]) : 100'000;
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
  return 0;
}

// libmodbus answers from its registers; this file gathers the requests, so that half a one holds nobody up, looks at
// each write and lets the receiver decide. One client at a time, as small PLCs do: a new one replaces the old.
#include "server/simulator/plc.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <modbus.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "protocol/modbus/modbus.h"

namespace dripfeed::simulator {

namespace {

// As the server's port for register buses has it.
constexpr int kMailboxAddress = 0;
constexpr int kStatusAddress = 128;
constexpr int kRegisters = 256;
constexpr int kPoll_ms = 5;
// Of a request (Modbus Messaging on TCP/IP, 3.1.3): transaction, protocol 0, length of what follows, unit; then the
// PDU.
constexpr std::size_t kLengthAt = 4;
constexpr std::size_t kBeforeUnit = 6;
constexpr std::size_t kFunctionAt = 7;
constexpr std::size_t kShortest = 8;
// FC16: first register, count, bytes of data, data.
constexpr std::size_t kDataBytesAt = 12;
constexpr std::size_t kBeforeData = 13;

class PlcText final : public modbus::TextSink {
 public:
  void clear() noexcept override { text_.clear(); }
  bool append(std::span<const std::byte> bytes) noexcept override {
    for (const std::byte byte : bytes) text_ += static_cast<char>(byte);
    return true;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

struct FreeContext {
  void operator()(modbus_t* context) const { modbus_free(context); }
};
struct FreeMapping {
  void operator()(modbus_mapping_t* mapping) const { modbus_mapping_free(mapping); }
};

class ModbusPlc final : public Plc {
 public:
  ModbusPlc(const PlcSettings& settings, std::unique_ptr<modbus_t, FreeContext> context, int listener)
      : settings_(settings),
        context_(std::move(context)),
        mapping_(modbus_mapping_new(0, 0, kRegisters, 0)),
        listener_(listener),
        clock_(settings.clock),
        receiver_(text_, settings.boot_counter),
        thread_([this](const std::stop_token& stop) { loop(stop); }) {}
  ~ModbusPlc() override {
    thread_.request_stop();
    thread_.join();
    drop_client();
    ::close(listener_);
  }

  [[nodiscard]] PlcReport report() const override {
    const std::lock_guard lock(mutex_);
    return {.text = text_.text(), .requests = requests_, .blocks_run = blocks_run_, .complete = complete()};
  }

  [[nodiscard]] std::uint16_t port() const override {
    sockaddr_in address{};
    socklen_t length = sizeof(address);
    // The socket interface takes every address by this type.
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &length);
    return ntohs(address.sin_port);
  }

 private:
  [[nodiscard]] bool complete() const { return receiver_.memory().complete && consumed_ == text_.text().size(); }

  void loop(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      std::array<pollfd, 2> files = {pollfd{listener_, POLLIN, 0}, pollfd{client_, POLLIN, 0}};
      ::poll(files.data(), client_ < 0 ? 1 : 2, kPoll_ms);
      const std::lock_guard lock(mutex_);
      if ((files[0].revents & POLLIN) != 0) accept_client();
      if (client_ >= 0 && files[1].revents != 0) answer();
      run();
    }
  }

  void accept_client() {
    const int client = ::accept(listener_, nullptr, nullptr);
    if (client < 0) return;
    drop_client();
    client_ = client;
    gathered_ = 0;
    modbus_set_socket(context_.get(), client_);
  }

  void drop_client() {
    if (client_ >= 0) ::close(client_);
    client_ = -1;
  }

  // What has come by now; each request that is whole is answered.
  void answer() {
    const ssize_t count =
        ::recv(client_, gathered_bytes_.data() + gathered_, gathered_bytes_.size() - gathered_, MSG_DONTWAIT);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (count <= 0) return drop_client();
    gathered_ += static_cast<std::size_t>(count);
    while (client_ >= 0 && gathered_ >= kBeforeUnit) {
      const std::size_t length = kBeforeUnit + gathered_bytes_[kLengthAt] * 256U + gathered_bytes_[kLengthAt + 1];
      if (length < kShortest || length > gathered_bytes_.size()) return drop_client();  // the stream is out of step
      if (gathered_ < length) return;
      answer_one(std::span(gathered_bytes_).first(length));
      std::copy(gathered_bytes_.begin() + static_cast<std::ptrdiff_t>(length),
                gathered_bytes_.begin() + static_cast<std::ptrdiff_t>(gathered_), gathered_bytes_.begin());
      gathered_ -= length;
    }
  }

  void answer_one(std::span<const std::uint8_t> request) {
    const bool writes = request[kFunctionAt] == MODBUS_FC_WRITE_MULTIPLE_REGISTERS;
    if (writes && (request.size() < kBeforeData || request.size() != kBeforeData + request[kDataBytesAt]))
      return drop_client();
    std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> query{};  // libmodbus looks no further than the longest one
    std::ranges::copy(request, query.begin());
    publish();
    ++requests_;
    if (request[kFunctionAt] == MODBUS_FC_WRITE_AND_READ_REGISTERS && !take_exchange(request)) return drop_client();
    const auto length = static_cast<int>(request.size());
    if (modbus_reply(context_.get(), query.data(), length, mapping_.get()) < 0) return drop_client();
    take_write(request);
    publish();
  }

  // FC23: the write is done and judged before the read, as the standard has it: first register to be written at 12-13,
  // count at 14-15, bytes at 16, then the data.
  bool take_exchange(std::span<const std::uint8_t> query) {
    constexpr std::size_t kWriteAt = 12;
    constexpr std::size_t kExchangeData = 17;
    if (query.size() < kExchangeData || query.size() != kExchangeData + query[kExchangeData - 1]) return false;
    const int first = query[kWriteAt] * 256 + query[kWriteAt + 1];
    const int count = query[kWriteAt + 2] * 256 + query[kWriteAt + 3];
    if (query[kExchangeData - 1] != count * 2) return false;
    if (first < kMailboxAddress || first + count > kStatusAddress) return true;  // libmodbus refuses what is not there
    std::array<std::uint16_t, kStatusAddress> words{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      words[i] = static_cast<std::uint16_t>(query[kExchangeData + 2 * i] * 256U + query[kExchangeData + 2 * i + 1]);
    receiver_.written(static_cast<std::size_t>(first - kMailboxAddress),
                      std::span(words).first(static_cast<std::size_t>(count)));
    publish();
    return true;
  }

  // FC16 as it stands in the request: function at byte 7, first register at 8-9, count at 10-11.
  void take_write(std::span<const std::uint8_t> query) {
    if (query[kFunctionAt] != MODBUS_FC_WRITE_MULTIPLE_REGISTERS) return;
    const int first = query[8] * 256 + query[9];
    const int count = query[10] * 256 + query[11];
    if (first < kMailboxAddress || first + count > kRegisters) return;
    receiver_.written(static_cast<std::size_t>(first - kMailboxAddress),
                      std::span(mapping_->tab_registers + first, static_cast<std::size_t>(count)));
  }

  void publish() {
    const std::size_t backlog = text_.text().size() - consumed_;
    const std::size_t free_bytes = settings_.buffer_bytes - std::min<std::size_t>(backlog, settings_.buffer_bytes);
    receiver_.set_free_blocks(static_cast<std::uint16_t>(free_bytes / modbus::kMaxPayload));
    receiver_.set_consumed(static_cast<std::uint32_t>(consumed_));
    receiver_.beat();
    std::ranges::copy(receiver_.status_image(), mapping_->tab_registers + kStatusAddress);
  }

  // Runs finished blocks only, each for as long as it takes.
  void run() {
    const auto now = std::chrono::steady_clock::now();
    const std::string& text = text_.text();
    if (receiver_.memory().session != session_) {
      session_ = receiver_.memory().session;
      consumed_ = 0;
      clock_ = BlockClock(settings_.clock);
    }
    while (run_until_ <= now) {
      const std::size_t end = text.find('\n', consumed_);
      if (end == std::string::npos) {
        if (receiver_.memory().complete)
          consumed_ = text.size();  // the last line needs no EOB once the end is announced
        return;
      }
      const double seconds = clock_.run(std::string_view(text).substr(consumed_, end - consumed_)) / settings_.speed;
      consumed_ = end + 1;
      ++blocks_run_;
      const auto duration =
          std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
      run_until_ = std::max(run_until_, now - std::chrono::milliseconds(kPoll_ms)) + duration;
    }
  }

  PlcSettings settings_;
  std::unique_ptr<modbus_t, FreeContext> context_;
  std::unique_ptr<modbus_mapping_t, FreeMapping> mapping_;
  int listener_;
  int client_ = -1;
  std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> gathered_bytes_{};
  std::size_t gathered_ = 0;
  BlockClock clock_;
  PlcText text_;
  modbus::Receiver receiver_;
  std::uint32_t session_ = 0;
  std::size_t consumed_ = 0;
  std::uint64_t requests_ = 0;
  std::uint64_t blocks_run_ = 0;
  std::chrono::steady_clock::time_point run_until_;
  mutable std::mutex mutex_;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace

std::expected<std::unique_ptr<Plc>, std::string> Plc::start(const machine::LinkUrl& url, const PlcSettings& settings) {
  const std::string host = url.host.empty() ? "127.0.0.1" : url.host;
  std::unique_ptr<modbus_t, FreeContext> context(modbus_new_tcp(host.c_str(), url.port));
  const int listener = context ? modbus_tcp_listen(context.get(), 1) : -1;
  if (listener < 0) return std::unexpected(fmt::format("{}: cannot listen: {}", url.text, modbus_strerror(errno)));
  return std::make_unique<ModbusPlc>(settings, std::move(context), listener);
}

}  // namespace dripfeed::simulator

// libmodbus answers from the registers, into a socket of our own; this file looks at each write and lets the receiver
// decide, and does to an answer what the faults say.
#include "server/simulator/plc_unit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

#include <modbus.h>
#include <sys/socket.h>
#include <unistd.h>

#include "protocol/modbus/modbus.h"

namespace dripfeed::simulator {

namespace {

// As the server's port for register buses has it.
constexpr int kMailboxAddress = 0;
constexpr int kAnswerAddress = 121;
constexpr int kStatusAddress = 128;
constexpr int kMachineAddress = kStatusAddress + static_cast<int>(modbus::kStatusRegisters);
constexpr int kRegisters = 256;
constexpr int kPoll_ms = 5;

// The panel's registers.
enum PanelAt : std::size_t { kDoes = 0, kAlarm = 1, kRequest = 3, kProgram = 4, kBell = 6, kPanelRegisters = 7 };

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

// The number of a text that begins with one: "%\nO0042".
std::uint32_t program_number(std::string_view text) {
  const std::size_t at = text.find('O');
  std::uint32_t number = 0;
  if (at == std::string_view::npos || text.find_first_not_of("%\n", 0) != at) return 0;
  std::from_chars(text.data() + at + 1, text.data() + text.size(), number);
  return number;
}

struct FreeContext {
  void operator()(modbus_t* context) const { modbus_free(context); }
};
struct FreeMapping {
  void operator()(modbus_mapping_t* mapping) const { modbus_mapping_free(mapping); }
};

// libmodbus as a machine from request to answer: it writes into one end of a pair, we read the other.
class Answerer {
 public:
  explicit Answerer(bool serial)
      : context_(serial ? modbus_new_rtu("/dev/null", 19200, 'E', 8, 1) : modbus_new_tcp("127.0.0.1", 502)) {
    ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends_.data());
    modbus_set_socket(context_.get(), ends_[1]);
    modbus_set_response_timeout(context_.get(), 0, 1000);  // an exception sleeps so long
  }
  Answerer(const Answerer&) = delete;
  Answerer& operator=(const Answerer&) = delete;
  ~Answerer() {
    for (const int end : ends_) ::close(end);
  }

  std::span<std::uint8_t> reply(const PlcRequest& request, modbus_mapping_t* mapping) {
    auto query = query_of(request);
    modbus_reply(context_.get(), query.data(), static_cast<int>(request.frame.size()), mapping);
    return taken();
  }
  std::span<std::uint8_t> refuse(const PlcRequest& request, unsigned exception) {
    auto query = query_of(request);
    modbus_reply_exception(context_.get(), query.data(), exception);
    return taken();
  }

 private:
  using Frame = std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH>;
  static Frame query_of(const PlcRequest& request) {
    Frame query{};  // libmodbus looks no further than the longest one
    std::ranges::copy(request.frame, query.begin());
    return query;
  }
  std::span<std::uint8_t> taken() {
    const ssize_t count = ::recv(ends_[0], answer_.data(), answer_.size(), MSG_DONTWAIT);
    return std::span(answer_).first(count > 0 ? static_cast<std::size_t>(count) : 0);
  }

  std::unique_ptr<modbus_t, FreeContext> context_;
  std::array<int, 2> ends_{-1, -1};
  Frame answer_{};
};

class ModbusUnit final : public PlcUnit {
 public:
  ModbusUnit(const PlcSettings& settings, std::uint8_t unit, bool is_serial)
      : settings_(settings),
        unit_(unit),
        is_serial_(is_serial),
        answerer_(is_serial),
        mapping_(modbus_mapping_new(0, 0, kRegisters, 0)),
        clock_(settings.clock),
        boot_counter_(settings.boot_counter),
        receiver_(std::in_place, text_, boot_counter_) {}

  [[nodiscard]] std::uint8_t number() const override { return unit_; }
  [[nodiscard]] PlcReport report() const override {
    const std::lock_guard lock(mutex_);
    return {.text = text_.text(), .requests = requests_, .blocks_run = blocks_run_, .complete = complete()};
  }
  bool take_restarted() override {
    const std::lock_guard lock(mutex_);
    return std::exchange(restarted_, false);
  }

  std::span<const std::uint8_t> answer(const PlcRequest& request) override {
    const std::lock_guard lock(mutex_);
    ++requests_;
    if (const auto at = find_fault(settings_.faults, FaultKind::plc_restart); at && requests_ == *at) {
      restart();
      return {};
    }
    if (strikes(FaultKind::plc_lose)) return {};
    if (strikes(FaultKind::plc_busy)) return answerer_.refuse(request, MODBUS_EXCEPTION_SLAVE_OR_SERVER_BUSY);
    const std::span<std::uint8_t> out = handle(request);
    if (strikes(FaultKind::plc_silent)) return {};
    // The check sum's last byte on a line, the transaction's number by TCP.
    if (strikes(FaultKind::plc_damage) && !out.empty()) out[is_serial_ ? out.size() - 1 : 1] ^= 0x55;
    return out;
  }

  // Runs finished blocks only, each for as long as it takes.
  void run() override {
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    const std::string& text = text_.text();
    if (receiver_->memory().session != session_) {
      session_ = receiver_->memory().session;
      consumed_ = 0;
      lines_run_ = 0;
      clock_ = BlockClock(settings_.clock);
    }
    while (run_until_ <= now && !stands()) {
      const std::size_t end = text.find('\n', consumed_);
      if (end == std::string::npos) {
        if (receiver_->memory().complete)
          consumed_ = text.size();  // the last line needs no EOB once the end is announced
        return;
      }
      const double seconds = clock_.run(std::string_view(text).substr(consumed_, end - consumed_)) / settings_.speed;
      consumed_ = end + 1;
      ++blocks_run_;
      ++lines_run_;
      const auto duration =
          std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
      run_until_ = std::max(run_until_, now - std::chrono::milliseconds(kPoll_ms)) + duration;
    }
  }

 private:
  [[nodiscard]] bool complete() const { return receiver_->memory().complete && consumed_ == text_.text().size(); }

  [[nodiscard]] bool strikes(FaultKind kind) const {
    const auto every = find_fault(settings_.faults, kind);
    return every && *every > 0 && requests_ % *every == 0;
  }

  std::span<std::uint8_t> handle(const PlcRequest& request) {
    publish();
    const auto pdu = request.frame.subspan(request.function_at);
    if (!settings_.has_words && reaches_words(pdu))
      return answerer_.refuse(request, MODBUS_EXCEPTION_ILLEGAL_DATA_ADDRESS);
    if (pdu[0] == MODBUS_FC_WRITE_AND_READ_REGISTERS) take_exchange(pdu);
    const auto out = answerer_.reply(request, mapping_.get());
    if (pdu[0] == MODBUS_FC_WRITE_MULTIPLE_REGISTERS) take_write(pdu);
    publish();
    return out;
  }

  static int word_at(std::span<const std::uint8_t> pdu, std::size_t at) { return pdu[at] * 256 + pdu[at + 1]; }

  // A read of the machine's words: function, first register, count; of an exchange those after the function, too.
  static bool reaches_words(std::span<const std::uint8_t> pdu) {
    const bool reads = pdu[0] == MODBUS_FC_READ_HOLDING_REGISTERS || pdu[0] == MODBUS_FC_WRITE_AND_READ_REGISTERS;
    if (!reads || pdu.size() < 5) return false;
    const int first = word_at(pdu, 1);
    return first < kPanelAddress && first + word_at(pdu, 3) > kMachineAddress;
  }

  // FC23: the write is done and judged before the read, as the standard has it: first register to be written at 5,
  // count at 7, bytes at 9, then the data.
  void take_exchange(std::span<const std::uint8_t> pdu) {
    constexpr std::size_t kData = 10;
    if (pdu.size() < kData) return;
    const int first = word_at(pdu, 5);
    const int count = word_at(pdu, 7);
    if (pdu[9] != count * 2 || pdu.size() < kData + pdu[9]) return;
    if (first < kMailboxAddress || first + count > kAnswerAddress) return;  // libmodbus refuses what is not there
    std::array<std::uint16_t, kAnswerAddress> words{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      words[i] = static_cast<std::uint16_t>(word_at(pdu, kData + 2 * i));
    receiver_->written(static_cast<std::size_t>(first - kMailboxAddress),
                       std::span(words).first(static_cast<std::size_t>(count)));
    publish();
  }

  // FC16: first register at 1, count at 3; the data is in the registers already.
  void take_write(std::span<const std::uint8_t> pdu) {
    const int first = word_at(pdu, 1);
    const int count = word_at(pdu, 3);
    if (first < kMailboxAddress || first + count > kAnswerAddress) return;
    receiver_->written(static_cast<std::size_t>(first - kMailboxAddress),
                       std::span(mapping_->tab_registers + first, static_cast<std::size_t>(count)));
  }

  // Power off and on: the text and its account stay, the panel and the doorbell's answer do not.
  void restart() {
    const modbus::ReceiverMemory memory = receiver_->memory();
    receiver_.emplace(text_, ++boot_counter_, memory);
    std::fill_n(mapping_->tab_registers + kAnswerAddress, modbus::kAnswerRegisters, std::uint16_t{0});
    std::fill_n(mapping_->tab_registers + kPanelAddress, std::size_t{kPanelRegisters}, std::uint16_t{0});
    restarted_ = true;
  }

  [[nodiscard]] std::uint16_t panel(std::size_t at) const { return mapping_->tab_registers[kPanelAddress + at]; }
  [[nodiscard]] std::uint32_t panel_32(std::size_t at) const { return std::uint32_t{panel(at)} << 16U | panel(at + 1); }
  [[nodiscard]] modbus::MachineState state() const {
    if (panel(kDoes) > 0 && panel(kDoes) <= static_cast<std::uint16_t>(modbus::MachineState::manual))
      return static_cast<modbus::MachineState>(panel(kDoes));
    const bool has_work = !text_.text().empty() && !complete();
    return has_work && receiver_->status().state != modbus::ReceiverState::idle ? modbus::MachineState::running
                                                                                : modbus::MachineState::idle;
  }
  [[nodiscard]] bool stands() const {
    const modbus::MachineState now = state();
    return now == modbus::MachineState::held || now == modbus::MachineState::alarm ||
           now == modbus::MachineState::emergency_stop || receiver_->status().state == modbus::ReceiverState::held;
  }

  void publish() {
    const std::size_t backlog = text_.text().size() - consumed_;
    const std::size_t free_bytes = settings_.buffer_bytes - std::min<std::size_t>(backlog, settings_.buffer_bytes);
    receiver_->set_free_blocks(static_cast<std::uint16_t>(free_bytes / modbus::kMaxPayload));
    receiver_->set_consumed(static_cast<std::uint32_t>(consumed_));
    receiver_->beat();
    std::ranges::copy(receiver_->status_image(), mapping_->tab_registers + kStatusAddress);
    modbus::MachineImage image{};
    const bool runs = state() != modbus::MachineState::idle && !text_.text().empty();
    modbus::encode({.state = state(),
                    .program = program_number(text_.text()),
                    .line = runs ? lines_run_ : 0,  // the block that was begun last
                    .alarm = state() == modbus::MachineState::alarm ? panel_32(kAlarm) : 0,
                    .bell = panel(kBell),
                    .request = panel(kRequest),
                    .requested = panel_32(kProgram)},
                   image);
    if (settings_.has_words) std::ranges::copy(image, mapping_->tab_registers + kMachineAddress);
  }

  PlcSettings settings_;
  std::uint8_t unit_;
  bool is_serial_;
  Answerer answerer_;
  std::unique_ptr<modbus_mapping_t, FreeMapping> mapping_;
  BlockClock clock_;
  PlcText text_;
  std::uint16_t boot_counter_;
  std::optional<modbus::Receiver> receiver_;
  std::uint32_t session_ = 0;
  std::size_t consumed_ = 0;
  std::uint32_t lines_run_ = 0;
  std::uint64_t requests_ = 0;
  std::uint64_t blocks_run_ = 0;
  std::chrono::steady_clock::time_point run_until_;
  bool restarted_ = false;
  mutable std::mutex mutex_;
};

}  // namespace

std::unique_ptr<PlcUnit> PlcUnit::make(const PlcSettings& settings, std::uint8_t unit, bool is_serial) {
  return std::make_unique<ModbusUnit>(settings, unit, is_serial);
}

}  // namespace dripfeed::simulator

// The session is the socket's listener and outlives the link by its own callbacks. The link counts as up once the
// server has set the line; what the control said before that is kept and handed on then.
#include "server/io/com_port_link.h"

#include <algorithm>
#include <array>
#include <vector>

#include <boost/asio/steady_timer.hpp>
#include <fmt/format.h>

#include "protocol/telnet/telnet.h"
#include "server/io/steady_clock.h"
#include "server/io/tcp_link.h"

namespace dripfeed::io {

namespace {

constexpr std::size_t kMostEarly = 1024;

// The line as the server's UART is to be set. A character of 7 bits with parity is the same on the wire as one of 8
// with the parity made here, so that a wrong parity of the control is seen with its place.
telnet::ComPortSettings com_port_settings(const machine::LineSettings& line) {
  telnet::ComPortSettings settings{.baud = line.baud,
                                   .data_bits = 8,
                                   .parity = telnet::LineParity::none,
                                   .stop_bits = static_cast<std::uint8_t>(line.framing.stop_bits),
                                   .flow = telnet::LineFlow::none};
  // Held by the device server itself: its UART by the lines, its software by XOFF where the profile says so.
  if (feed::cts_is_flow(line.flow)) settings.flow = telnet::LineFlow::hardware;
  if (line.xoff_by == feed::XoffBy::device && line.flow == feed::Flow::xonxoff)
    settings.flow = telnet::LineFlow::xonxoff;
  const bool seven_alone = line.framing.data_bits == 7 && line.framing.parity == tape_code::Parity::none;
  if (seven_alone) settings.data_bits = 7;
  if (line.framing.data_bits == 8 && line.framing.parity != tape_code::Parity::none) {
    settings.parity =
        line.framing.parity == tape_code::Parity::even ? telnet::LineParity::even : telnet::LineParity::odd;
  }
  return settings;
}

class Session final : public app::LinkListener, public std::enable_shared_from_this<Session> {
 public:
  Session(asio::io_context& context, const machine::LineSettings& line, app::LinkListener& outer)
      : outer_(&outer),
        client_(com_port_settings(line)),
        timer_(context),
        core_(std::make_shared<TcpCore>(asio::ip::tcp::socket(context), *this)) {
    early_.reserve(kMostEarly);
  }

  void connect(const std::string& host, std::uint16_t port) { io::connect(core_, host, port); }

  // The link is gone. What the server has not sent is asked to be dropped; the socket takes that or not.
  void detach() {
    outer_ = nullptr;
    timer_.cancel();
    client_.purge_output();
    flush();
    reset_on_close(*core_, false);
    core_->detach();
    core_.reset();
  }

  std::size_t write(std::span<const std::byte> bytes) {
    if (core_->resting()) return 0;  // on_writable() follows
    const std::size_t taken = client_.send(bytes);
    flush();
    return taken;
  }

  void set_rts(bool on) {
    client_.set_rts(on);
    flush();
  }

  std::size_t read(std::span<std::byte> into) {
    if (!announced_) return 0;
    std::size_t count = 0;
    do {  // a piece may hold commands alone; the core's allowance ends it
      const std::size_t most = std::min(into.size(), raw_.size());
      const std::size_t came = core_->read(std::span(raw_).first(most));
      if (came == 0) break;
      count = client_.receive(std::span(raw_).first(came), into, clock_.now());
    } while (count == 0);
    follow_up_later();
    return count;
  }

  [[nodiscard]] std::optional<std::uint64_t> unconfirmed() const {
    if (!core_->up()) return std::nullopt;
    const auto below = read_unconfirmed(core_->stream().native_handle());
    return below ? std::optional(*below + client_.pending_out().size()) : std::nullopt;
  }
  [[nodiscard]] const app::LineErrors& errors() const { return errors_; }
  [[nodiscard]] bool unheard() const { return core_ && core_->unheard(); }
  [[nodiscard]] std::string_view note() const {
    const std::string_view flood = core_ ? core_->note() : std::string_view();
    return flood.empty() ? note_ : flood;
  }

 private:
  void on_up() override {
    const auto self = shared_from_this();
    client_.begin(clock_.now());
    follow_up();
  }

  void on_receive(std::span<const std::byte> bytes) override {
    const auto self = shared_from_this();  // the outer listener may drop the link
    const std::size_t count = client_.receive(bytes, data_, clock_.now());
    follow_up();
    if (count == 0 || outer_ == nullptr) return;
    const std::span<const std::byte> data = std::span(data_).first(count);
    if (announced_) return outer_->on_receive(data);
    if (early_.size() + count > kMostEarly)
      return core_->lose("the device server sent more than 1024 characters before it had set the line");
    early_.insert(early_.end(), data.begin(), data.end());
  }

  void on_writable() override {
    const auto self = shared_from_this();
    flush();
    if (outer_ != nullptr && announced_) outer_->on_writable();
  }
  void on_cts(bool) override {}  // a socket has none
  void on_dsr(bool) override {}

  void on_lost(std::string_view reason) override {
    const auto self = shared_from_this();
    timer_.cancel();
    app::LinkListener* outer = std::exchange(outer_, nullptr);
    if (outer != nullptr) outer->on_lost(announced_ ? std::string(reason) : with_early_words(reason));
  }

  // Device servers say in plain text why they hang up.
  std::string with_early_words(std::string_view reason) const {
    std::string words;
    for (const std::byte byte : early_) {
      const auto c = static_cast<char>(byte);
      words += c >= ' ' && c <= '~' ? c : ' ';
    }
    while (words.ends_with(' ')) words.pop_back();
    return words.empty() ? std::string(reason) : fmt::format("{} (the device server reports: {})", reason, words);
  }

  void follow_up_later() {
    asio::post(timer_.get_executor(), [self = shared_from_this()] { self->follow_up(); });
  }

  // After each input: what the client has to say goes out, what it learned is handed on, its deadline is set.
  void follow_up() {
    const auto self = shared_from_this();
    if (outer_ == nullptr) return;
    flush();
    while (const auto event = client_.next_event()) {
      on_event(*event);
      if (outer_ == nullptr) return;
    }
    set_timer();
  }

  void on_event(const telnet::ClientEvent& event) {
    using Kind = telnet::ClientEvent::Kind;
    switch (event.kind) {
      case Kind::up: return announce();
      case Kind::failed: return core_->lose(failure());
      case Kind::unconfirmed:
        note_ += fmt::format("{}{} not confirmed", note_.empty() ? "" : ", ", telnet::name(event.setting));
        return;
      case Kind::differs:
        difference_ = fmt::format("{} is {} instead of {}", telnet::name(event.setting), event.value, event.asked);
        if (client_.state() == telnet::ClientState::up) note_ = difference_;
        return;
      case Kind::modem_change: return on_modem(static_cast<std::uint8_t>(event.value));
      case Kind::line_error:
        errors_.parity += (event.value & telnet::line::kParity) != 0 ? 1 : 0;
        errors_.framing += (event.value & telnet::line::kFraming) != 0 ? 1 : 0;
        errors_.overrun += (event.value & telnet::line::kOverrun) != 0 ? 1 : 0;
        errors_.breaks += (event.value & telnet::line::kBreak) != 0 ? 1 : 0;
        return;
      case Kind::suspended: return;  // write() takes nothing now
      case Kind::resumed:
        if (announced_) outer_->on_writable();
        return;
    }
  }

  [[nodiscard]] std::string failure() const {
    const std::string_view words = telnet::message(client_.failure());
    return client_.failure() == telnet::ClientFailure::differs ? fmt::format("{}: {}", words, difference_)
                                                               : std::string(words);
  }

  void announce() {
    announced_ = true;
    outer_->on_up();
    if (outer_ != nullptr) report_lines();
    if (outer_ != nullptr && !early_.empty()) outer_->on_receive(early_);
    early_.clear();
  }

  void on_modem(std::uint8_t lines) {
    cts_ = (lines & telnet::modem::kCts) != 0;
    dsr_ = (lines & telnet::modem::kDsr) != 0;
    if (announced_) report_lines();
  }
  // The listener takes both as on until it learns otherwise.
  void report_lines() {
    if (cts_ != reported_cts_) outer_->on_cts(reported_cts_ = cts_);
    if (outer_ != nullptr && dsr_ != reported_dsr_) outer_->on_dsr(reported_dsr_ = dsr_);
  }

  void flush() {
    while (core_ && !client_.pending_out().empty()) {
      const std::size_t taken = core_->write(client_.pending_out());
      client_.mark_sent(taken);
      if (taken == 0) return;  // on_writable() goes on
    }
  }

  void set_timer() {
    const auto deadline = client_.deadline();
    if (!deadline || deadline == armed_for_) return;
    armed_for_ = deadline;
    timer_.expires_at(std::chrono::steady_clock::time_point(*deadline));
    timer_.async_wait([self = shared_from_this()](boost::system::error_code error) {
      if (error || self->outer_ == nullptr) return;
      self->client_.tick(self->clock_.now());
      self->follow_up();
    });
  }

  app::LinkListener* outer_;
  telnet::ComPortClient client_;
  asio::steady_timer timer_;
  std::shared_ptr<TcpCore> core_;
  SteadyClock clock_;
  std::optional<telnet::Time> armed_for_;
  bool announced_ = false;
  bool cts_ = true;
  bool dsr_ = true;
  bool reported_cts_ = true;
  bool reported_dsr_ = true;
  app::LineErrors errors_;
  std::string note_;
  std::string difference_;
  std::vector<std::byte> early_;
  std::array<std::byte, kReadBytes> raw_{};
  std::array<std::byte, kReadBytes> data_{};
};

class ComPortLink final : public app::Link {
 public:
  explicit ComPortLink(std::shared_ptr<Session> session) : session_(std::move(session)) {}
  ~ComPortLink() override { session_->detach(); }

  std::size_t write(std::span<const std::byte> bytes) override { return session_->write(bytes); }
  std::size_t read(std::span<std::byte> into) override { return session_->read(into); }
  // RFC 2217 has no word for how much the server holds.
  std::optional<std::uint64_t> unsent() override { return std::nullopt; }
  std::optional<std::uint64_t> unconfirmed() override { return session_->unconfirmed(); }
  bool set_rts(bool on) override {
    session_->set_rts(on);
    return true;
  }
  [[nodiscard]] app::LineErrors errors() const override { return session_->errors(); }
  [[nodiscard]] bool unheard() const override { return session_->unheard(); }
  [[nodiscard]] std::string_view note() const override { return session_->note(); }

 private:
  std::shared_ptr<Session> session_;
};

}  // namespace

std::expected<std::unique_ptr<app::Link>, std::string> open_com_port_link(boost::asio::io_context& context,
                                                                          const machine::LineSettings& line,
                                                                          app::LinkListener& listener) {
  const auto session = std::make_shared<Session>(context, line, listener);
  session->connect(line.link.host, line.link.port);
  return std::make_unique<ComPortLink>(session);
}

}  // namespace dripfeed::io

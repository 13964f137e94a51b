// A link is a handle; the core behind it lives as long as Asio has operations pending, so that a link may be destroyed
// from inside its own callback. After that the core's listener is gone and nothing is called.
#include "server/io/stream_link.h"

#include <array>
#include <utility>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <fmt/format.h>
#include <linux/sockios.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include "server/io/serial_port.h"

namespace dripfeed::io {

namespace {

namespace asio = boost::asio;
using tcp = asio::ip::tcp;

constexpr std::size_t kReadBytes = 4096;
constexpr std::chrono::milliseconds kModemPoll{100};
// A small send buffer bounds what the network holds of a program; keepalive finds a half-open peer in about 20 s.
constexpr int kSocketSendBytes = 4096;
constexpr std::chrono::seconds kConnectTimeout{10};
constexpr int kKeepIdle_s = 10;
constexpr int kKeepInterval_s = 3;
constexpr int kKeepCount = 3;

template <class Stream>
class Core : public std::enable_shared_from_this<Core<Stream>> {
 public:
  Core(Stream stream, app::LinkListener& listener) : stream_(std::move(stream)), listener_(&listener) {}

  // From here on bytes flow.
  void begin() {
    up_ = true;
    listener_->on_up();
    if (listener_ != nullptr) read_next();
  }

  void detach() {
    listener_ = nullptr;
    boost::system::error_code ignored;  // what is closed twice stays closed
    stream_.close(ignored);
  }

  // Through Asio and not ::write: a socket whose peer is gone must give an error, no SIGPIPE. Before on_up() nothing is
  // taken, and nothing is lost by it.
  std::size_t write(std::span<const std::byte> bytes) {
    if (!up_) return 0;
    boost::system::error_code error;
    const std::size_t taken = stream_.write_some(asio::buffer(bytes.data(), bytes.size()), error);
    if (taken == bytes.size()) return taken;
    if (!error || error == asio::error::would_block || error == asio::error::try_again ||
        error == asio::error::interrupted) {
      wait_writable();
      return taken;
    }
    // The listener must not hear of it from inside its own call.
    asio::post(stream_.get_executor(),
               [self = this->shared_from_this(), reason = error.message()] { self->lose(reason); });
    return taken;
  }

  // What fails here fails again in the read that waits, which tells of it.
  std::size_t read(std::span<std::byte> into) {
    if (!up_) return 0;
    boost::system::error_code ignored;
    return stream_.read_some(asio::buffer(into.data(), into.size()), ignored);
  }

  void lose(const std::string& reason) {
    if (listener_ == nullptr) return;
    app::LinkListener* listener = std::exchange(listener_, nullptr);
    boost::system::error_code ignored;  // it is lost already
    stream_.close(ignored);
    listener->on_lost(reason);
  }

  bool up() const { return up_; }
  Stream& stream() { return stream_; }
  app::LinkListener* listener() { return listener_; }

 private:
  void read_next() {
    stream_.async_read_some(
        asio::buffer(buffer_), [self = this->shared_from_this()](boost::system::error_code error, std::size_t count) {
          if (self->listener_ == nullptr) return;
          if (error) return self->lose(error == asio::error::eof ? "the other side closed the line" : error.message());
          self->listener_->on_receive(std::span(self->buffer_).first(count));
          if (self->listener_ != nullptr) self->read_next();
        });
  }

  void wait_writable() {
    if (std::exchange(waiting_, true)) return;
    stream_.async_wait(Stream::wait_write, [self = this->shared_from_this()](boost::system::error_code error) {
      self->waiting_ = false;
      if (!error && self->listener_ != nullptr) self->listener_->on_writable();
    });
  }

  Stream stream_;
  app::LinkListener* listener_;
  std::array<std::byte, kReadBytes> buffer_{};
  bool up_ = false;
  bool waiting_ = false;
};

// --- tty
// -------------------------------------------------------------------------------------------------------------------

using SerialCore = Core<asio::posix::stream_descriptor>;

class SerialLink final : public app::Link {
 public:
  SerialLink(asio::io_context& context, int descriptor, bool watch_lines, app::LinkListener& listener)
      : core_(std::make_shared<SerialCore>(asio::posix::stream_descriptor(context, descriptor), listener)),
        poll_(std::make_shared<asio::steady_timer>(context)) {
    core_->stream().non_blocking(true);
    asio::post(context, [core = core_] {
      if (core->listener() != nullptr) core->begin();
    });
    if (watch_lines) poll_lines(core_, poll_, ModemLines{});
  }
  ~SerialLink() override {
    poll_->cancel();
    core_->detach();
  }

  std::size_t write(std::span<const std::byte> bytes) override { return core_->write(bytes); }
  std::size_t read(std::span<std::byte> into) override { return core_->read(into); }
  std::optional<std::uint64_t> unsent() override { return read_unsent(core_->stream().native_handle()); }
  std::optional<std::uint64_t> unconfirmed() override { return std::nullopt; }

 private:
  static void poll_lines(const std::shared_ptr<SerialCore>& core, const std::shared_ptr<asio::steady_timer>& timer,
                         ModemLines before) {
    timer->expires_after(kModemPoll);
    timer->async_wait([core, timer, before](boost::system::error_code error) {
      if (error || core->listener() == nullptr) return;
      const ModemLines now = read_modem_lines(core->stream().native_handle()).value_or(before);
      if (now.cts != before.cts) core->listener()->on_cts(now.cts);
      if (core->listener() != nullptr && now.dsr != before.dsr) core->listener()->on_dsr(now.dsr);
      poll_lines(core, timer, now);
    });
  }

  std::shared_ptr<SerialCore> core_;
  std::shared_ptr<asio::steady_timer> poll_;
};

// --- sockets
// ---------------------------------------------------------------------------------------------------------------

using TcpCore = Core<tcp::socket>;

void set_option(int descriptor, int level, int name, int value) {
  ::setsockopt(descriptor, level, name, &value, sizeof(value));  // a hint: the link works without it
}

// What was written and not acknowledged by the peer's TCP.
std::optional<std::uint64_t> read_unconfirmed(int descriptor) {
  int count = 0;
  if (::ioctl(descriptor, SIOCOUTQ, &count) != 0 || count < 0) return std::nullopt;
  return static_cast<std::uint64_t>(count);
}

void tune(tcp::socket& socket) {
  const int descriptor = socket.native_handle();
  set_option(descriptor, IPPROTO_TCP, TCP_NODELAY, 1);
  set_option(descriptor, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(descriptor, IPPROTO_TCP, TCP_KEEPIDLE, kKeepIdle_s);
  set_option(descriptor, IPPROTO_TCP, TCP_KEEPINTVL, kKeepInterval_s);
  set_option(descriptor, IPPROTO_TCP, TCP_KEEPCNT, kKeepCount);
  socket.non_blocking(true);
}

class TcpLink : public app::Link {
 public:
  TcpLink(asio::io_context& context, app::LinkListener& listener)
      : core_(std::make_shared<TcpCore>(tcp::socket(context), listener)) {}
  ~TcpLink() override { core_->detach(); }

  // A name is looked up on a thread of Asio's own: a slow name server must not hold up the lines that run.
  void connect(asio::io_context& context, const std::string& host, std::uint16_t port) {
    give_up_later(context, host);
    const auto resolver = std::make_shared<tcp::resolver>(context);
    resolver->async_resolve(
        host, std::to_string(port),
        [core = core_, resolver](boost::system::error_code error, const tcp::resolver::results_type& peers) {
          if (core->listener() == nullptr) return;
          if (error) return core->lose(error.message());
          connect_to(core, *peers.begin());
        });
  }

  std::size_t write(std::span<const std::byte> bytes) override { return core_->write(bytes); }
  std::size_t read(std::span<std::byte> into) override { return core_->read(into); }
  // What TCP holds says nothing of the line behind the device server.
  std::optional<std::uint64_t> unsent() override { return std::nullopt; }
  std::optional<std::uint64_t> unconfirmed() override {
    return core_->up() ? read_unconfirmed(core_->stream().native_handle()) : std::nullopt;
  }

 protected:
  std::shared_ptr<TcpCore>& core() { return core_; }

 private:
  // A peer that does not answer at all would keep the system trying for minutes.
  void give_up_later(asio::io_context& context, const std::string& host) {
    const auto timer = std::make_shared<asio::steady_timer>(context, kConnectTimeout);
    timer->async_wait([core = std::weak_ptr(core_), timer, host](boost::system::error_code) {
      const auto still = core.lock();
      if (still && !still->up()) still->lose(fmt::format("{} does not answer", host));
    });
  }
  static void connect_to(const std::shared_ptr<TcpCore>& core, const tcp::endpoint& peer) {
    boost::system::error_code failed;
    core->stream().open(peer.protocol(), failed);
    if (failed) return core->lose(failed.message());
    set_option(core->stream().native_handle(), SOL_SOCKET, SO_SNDBUF, kSocketSendBytes);
    core->stream().async_connect(peer, [core](boost::system::error_code error) {
      if (core->listener() == nullptr) return;
      if (error) return core->lose(error.message());
      tune(core->stream());
      core->begin();
    });
  }

  std::shared_ptr<TcpCore> core_;
};

// Waits for one peer (a device server in client mode).
class TcpListenLink final : public TcpLink {
 public:
  TcpListenLink(asio::io_context& context, const tcp::endpoint& local, app::LinkListener& listener)
      : TcpLink(context, listener), acceptor_(std::make_shared<tcp::acceptor>(context, local)) {
    acceptor_->async_accept(core()->stream(), [core = core(), acceptor = acceptor_](boost::system::error_code error) {
      if (core->listener() == nullptr) return;
      boost::system::error_code ignored;  // one peer is enough: the next one is refused by the system
      acceptor->close(ignored);
      if (error) return core->lose(error.message());
      tune(core->stream());
      core->begin();
    });
  }
  ~TcpListenLink() override {
    boost::system::error_code ignored;  // closed already once a peer came
    acceptor_->close(ignored);
  }

 private:
  std::shared_ptr<tcp::acceptor> acceptor_;
};

// --- opening
// ---------------------------------------------------------------------------------------------------------------

using Opened = std::expected<std::unique_ptr<app::Link>, std::string>;

Opened open_serial(asio::io_context& context, const machine::LineSettings& line, app::LinkListener& listener) {
  const auto descriptor = open_serial_port(line.link.path, line.baud, line.framing);
  if (!descriptor) return std::unexpected(descriptor.error());
  return std::make_unique<SerialLink>(context, *descriptor, line.watch_cts || line.watch_dsr, listener);
}

Opened open_tcp(asio::io_context& context, const machine::LineSettings& line, app::LinkListener& listener) {
  auto link = std::make_unique<TcpLink>(context, listener);
  link->connect(context, line.link.host, line.link.port);
  return link;
}

Opened open_listener(asio::io_context& context, const machine::LineSettings& line, app::LinkListener& listener) {
  const std::string host = line.link.host.empty() ? "127.0.0.1" : line.link.host;
  return std::make_unique<TcpListenLink>(context, tcp::endpoint(asio::ip::make_address(host), line.link.port),
                                         listener);
}

Opened open_modbus(asio::io_context&, const machine::LineSettings& line, app::LinkListener&) {
  return std::unexpected(fmt::format("{} is a register bus, not a link of bytes", line.link.text));
}

struct OpenerRow {
  machine::LinkKind kind;
  Opened (*open)(asio::io_context&, const machine::LineSettings&, app::LinkListener&);
};
constexpr std::array kOpeners = {
    OpenerRow{machine::LinkKind::serial, open_serial},     OpenerRow{machine::LinkKind::pty, open_serial},
    OpenerRow{machine::LinkKind::tcp, open_tcp},           OpenerRow{machine::LinkKind::tcp_listen, open_listener},
    OpenerRow{machine::LinkKind::modbus_tcp, open_modbus},
};

}  // namespace

Opened open_link(asio::io_context& context, const machine::LineSettings& line, app::LinkListener& listener) {
  for (const OpenerRow& row : kOpeners) {
    if (row.kind != line.link.kind) continue;
    try {
      return row.open(context, line, listener);
    } catch (const boost::system::system_error& error) {
      return std::unexpected(fmt::format("{}: {}", line.link.text, error.code().message()));
    }
  }
  return std::unexpected(fmt::format("{}: no driver for this kind of link", line.link.text));
}

}  // namespace dripfeed::io

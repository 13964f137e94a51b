// A peer that does not read holds what it was sent last and no more, and is let go; so is one that asked and fell
// silent.
#include "server/io/text_listener.h"

#include <chrono>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>

namespace dripfeed::io {

namespace {

namespace asio = boost::asio;
using tcp = asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::milliseconds kLookEvery{250};
constexpr std::chrono::seconds kSilentAtMost{30};
constexpr std::size_t kLongestLine_bytes = 1024;

class Connection final : public PeerConnection, public std::enable_shared_from_this<Connection> {
 public:
  Connection(tcp::socket socket, std::unique_ptr<app::TextFeed> feed)
      : socket_(std::move(socket)), timer_(socket_.get_executor()), feed_(std::move(feed)) {}

  void begin() override {
    out_ = feed_->greeting();
    send();
    read();
    look_later();
  }
  void close() override {
    error_code ignored;  // it is going away
    timer_.cancel();
    socket_.close(ignored);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void read() {
    asio::async_read_until(socket_, asio::dynamic_buffer(in_, kLongestLine_bytes), '\n',
                           [self = shared_from_this()](error_code error, std::size_t count) {
                             if (error) return self->close();
                             self->take_line(count);
                             self->read();
                           });
  }

  void take_line(std::size_t count) {
    const std::string answer = feed_->answer(std::string_view(in_).substr(0, count));
    in_.erase(0, count);
    if (answer.empty()) return;
    asks_ = true;
    heard_ = Clock::now();
    out_ += answer;
    send();
  }

  // Only what the last write has left is added to: nothing piles up for one that does not read.
  void look() {
    const bool is_silent = asks_ && Clock::now() - heard_ > kSilentAtMost;
    const bool is_stuck = is_sending_ && Clock::now() - sent_ > kSilentAtMost;
    if (is_silent || is_stuck) return close();
    if (!is_sending_) {
      out_ += feed_->changes();
      send();
    }
    look_later();
  }

  void look_later() {
    timer_.expires_after(kLookEvery);
    timer_.async_wait([self = shared_from_this()](error_code error) {
      if (!error && self->socket_.is_open()) self->look();
    });
  }

  void send() {
    if (is_sending_ || out_.empty()) return;
    is_sending_ = true;
    sent_ = Clock::now();
    sending_ = std::exchange(out_, {});
    asio::async_write(socket_, asio::buffer(sending_), [self = shared_from_this()](error_code error, std::size_t) {
      self->is_sending_ = false;
      if (error) return self->close();
      self->send();
    });
  }

  tcp::socket socket_;
  asio::steady_timer timer_;
  std::unique_ptr<app::TextFeed> feed_;
  std::string in_;
  std::string out_;
  std::string sending_;
  bool is_sending_ = false;
  Clock::time_point sent_;
  bool asks_ = false;  // it has asked whether this end lives, and does so again and again
  Clock::time_point heard_;
};

}  // namespace

std::expected<std::unique_ptr<PeerListener>, std::string> listen_for_readers(const PeerSettings& settings,
                                                                             std::string protocol,
                                                                             app::MakeTextFeed make) {
  return PeerListener::listen(settings, std::move(protocol), [make = std::move(make)](tcp::socket socket) {
    return std::make_shared<Connection>(std::move(socket), make());
  });
}

}  // namespace dripfeed::io

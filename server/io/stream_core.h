// What every link of bytes has below it: a stream of Asio and its listener. A link is a handle; the core lives as long
// as Asio has operations pending, so that a link may be destroyed from inside its own callback. After that the core's
// listener is gone and nothing is called.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/system/error_code.hpp>

#include "server/app/ports/link.h"
#include "server/io/read_allowance.h"
#include "server/io/steady_clock.h"

namespace dripfeed::io {

namespace asio = boost::asio;

inline constexpr std::size_t kReadBytes = 4096;

template <class Stream>
class Core : public std::enable_shared_from_this<Core<Stream>> {
 public:
  Core(Stream stream, app::LinkListener& listener)
      : stream_(std::move(stream)), rest_(stream_.get_executor()), listener_(&listener) {}

  // From here on bytes flow.
  void begin() {
    up_ = true;
    listener_->on_up();
    if (listener_ != nullptr) read_next();
  }

  void detach() {
    listener_ = nullptr;
    rest_.cancel();
    boost::system::error_code ignored;  // what is closed twice stays closed
    stream_.close(ignored);
  }

  // Through Asio and not ::write: a socket whose peer is gone must give an error, no SIGPIPE. Before on_up() nothing is
  // taken, and nothing is lost by it. Nor while reading rests: a stop sign may stand in what was not read yet.
  std::size_t write(std::span<const std::byte> bytes) {
    if (!up_ || resting_) return 0;
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

  // What fails here fails again in the read that waits, which reports it. Bounded by the link's allowance: a caller
  // that reads until nothing comes ends, however fast the other side is.
  std::size_t read(std::span<std::byte> into) {
    if (!up_ || resting_) return 0;
    const std::size_t most = std::min(into.size(), static_cast<std::size_t>(allowance_.left(clock_.now())));
    boost::system::error_code ignored;
    const std::size_t count = stream_.read_some(asio::buffer(into.data(), most), ignored);
    took(count);
    return count;
  }
  [[nodiscard]] bool resting() const { return resting_; }
  [[nodiscard]] bool unheard() const { return resting_ || allowance_.pressed(clock_.now()); }
  [[nodiscard]] std::string_view note() const {
    return allowance_.flooded(clock_.now()) ? app::kFloodNote : std::string_view();
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
  // Waits and then reads, never both at once: what a read that was started ahead holds would be overtaken by read().
  void read_next() {
    if (resting_ || std::exchange(reading_, true)) return;
    stream_.async_wait(Stream::wait_read, [self = this->shared_from_this()](boost::system::error_code error) {
      self->reading_ = false;
      if (error) return self->lose(error.message());
      self->hear();
      if (self->listener_ != nullptr) self->read_next();
    });
  }

  void hear() {
    if (listener_ == nullptr || resting_) return;
    const std::size_t most = std::min(buffer_.size(), static_cast<std::size_t>(allowance_.left(clock_.now())));
    boost::system::error_code error;
    const std::size_t count = stream_.read_some(asio::buffer(buffer_.data(), most), error);
    if (error == asio::error::would_block || error == asio::error::try_again || error == asio::error::interrupted)
      return;
    if (error) return lose(error == asio::error::eof ? "the other side closed the line" : error.message());
    took(count);
    listener_->on_receive(std::span(buffer_).first(count));
  }

  void took(std::size_t count) {
    const feed::Time now = clock_.now();
    allowance_.took(count, now);
    if (allowance_.left(now) > 0 || std::exchange(resting_, true)) return;
    rest_.expires_after(ReadAllowance::kRest);
    rest_.async_wait([self = this->shared_from_this()](boost::system::error_code) { self->end_rest(); });
  }

  // First what is there is heard, then what waits may go out.
  void end_rest() {
    resting_ = false;
    hear();
    if (listener_ != nullptr) read_next();
    if (listener_ != nullptr) listener_->on_writable();
  }

  void wait_writable() {
    if (std::exchange(waiting_, true)) return;
    stream_.async_wait(Stream::wait_write, [self = this->shared_from_this()](boost::system::error_code error) {
      self->waiting_ = false;
      if (!error && self->listener_ != nullptr) self->listener_->on_writable();
    });
  }

  Stream stream_;
  asio::steady_timer rest_;
  app::LinkListener* listener_;
  SteadyClock clock_;
  ReadAllowance allowance_;
  std::array<std::byte, kReadBytes> buffer_{};
  bool up_ = false;
  bool reading_ = false;
  bool resting_ = false;  // the allowance is used up
  bool waiting_ = false;
};

}  // namespace dripfeed::io

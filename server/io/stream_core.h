// What every link of bytes has below it: a stream of Asio and its listener. A link is a handle; the core lives as long
// as Asio has operations pending, so that a link may be destroyed from inside its own callback. After that the core's
// listener is gone and nothing is called.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/system/error_code.hpp>

#include "server/app/ports/link.h"

namespace dripfeed::io {

namespace asio = boost::asio;

inline constexpr std::size_t kReadBytes = 4096;

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

}  // namespace dripfeed::io

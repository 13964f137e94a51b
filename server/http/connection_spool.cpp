// A long body that is written to a file. One piece is in memory at a time; the next is read when the disk has the one
// before.
#include <chrono>
#include <utility>

#include <boost/asio/post.hpp>
#include <boost/beast/http/read.hpp>

#include "server/http/connection_state.h"

namespace dripfeed::http {

namespace {

namespace asio = boost::asio;
namespace bhttp = boost::beast::http;

constexpr std::size_t kPiece_bytes = std::size_t{256} << 10U;
constexpr std::chrono::seconds kDiskTimeout{30};  // for one piece

}  // namespace

void Connection::spool_body() {
  long_parser_.emplace(std::move(*parser_));
  request_.spooled = shared_.spool->begin();
  read_piece();
}

void Connection::read_piece() {
  piece_.resize(kPiece_bytes);
  auto& body = long_parser_->get().body();
  body.data = piece_.data();
  body.size = piece_.size();
  body.more = true;
  bhttp::async_read(wire_, buffer_, *long_parser_, fenced([this](Error error, auto) { on_piece(error); }));
}

void Connection::on_piece(Error error) {
  if (error && error != bhttp::error::need_buffer) {
    request_.spooled.reset();
    return refuse_unread(error);
  }
  piece_.resize(piece_.size() - long_parser_->get().body().size);
  // The disk may take longer than the connection lasts: then nothing waits for what it says.
  const bool taken = shared_.spool->append(
      request_.spooled, std::move(piece_), [weak = weak_from_this(), executor = wire_.get_executor()](auto written) {
        asio::post(executor, [weak, written = std::move(written)] {
          if (const auto self = weak.lock())
            self->fenced([connection = self.get(), &written] { connection->on_written(written); })();
        });
      });
  piece_ = {};
  if (!taken) return refuse_upload("the disk does not take this upload: too much waits for it");
  waits_for_disk_ = true;
  waits_since_.reset();
  timer_.expires_after(kDiskTimeout);
  timer_.async_wait(fenced([this](Error stopped) {
    if (!stopped && waits_for_disk_) refuse_upload("the disk does not take this upload: it does not answer");
  }));
}

void Connection::on_written(const std::expected<void, std::string>& written) {
  timer_.cancel();
  if (!waits_for_disk_) return;  // refused meanwhile
  waits_for_disk_ = false;
  if (!request_.spooled) return;  // closed meanwhile
  if (!written) return refuse_upload(written.error());
  if (long_parser_->is_done()) return on_read({});
  waits_since_ = Clock::now();
  read_piece();
}

void Connection::refuse_upload(std::string_view why) {
  waits_for_disk_ = false;
  request_.spooled.reset();
  respond_unread(plain_problem(507, why));
}

}  // namespace dripfeed::http

// Modem lines and error counters have no descriptor to wait on, so they are looked at on a timer; a device that has
// neither (a pty) is not asked twice.
#include "server/io/serial_link.h"

#include <chrono>

#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>

#include "server/io/serial_port.h"
#include "server/io/stream_core.h"

namespace dripfeed::io {

namespace {

constexpr std::chrono::microseconds kLook{20'000};

constexpr std::chrono::microseconds kFlowLook{static_cast<std::int64_t>(machine::kLinePoll_ms * 1000)};

using SerialCore = Core<asio::posix::stream_descriptor>;

// What is looked at; shared with the timer's handler, which may outlive the link by one call.
struct Look {
  Look(asio::io_context& context, std::chrono::microseconds look_every) : timer(context), every(look_every) {}
  asio::steady_timer timer;
  std::chrono::microseconds every;
  ModemLines lines;
  std::optional<app::LineErrors> at_open;
  app::LineErrors errors;
};

app::LineErrors since(const app::LineErrors& before, const app::LineErrors& now) {
  return {.parity = now.parity - before.parity,
          .framing = now.framing - before.framing,
          .overrun = now.overrun - before.overrun,
          .breaks = now.breaks - before.breaks};
}

class SerialLink final : public app::Link {
 public:
  SerialLink(asio::io_context& context, int descriptor, bool has_queue, std::chrono::microseconds look_every,
             app::LinkListener& listener)
      : has_queue_(has_queue),
        core_(std::make_shared<SerialCore>(asio::posix::stream_descriptor(context, descriptor), listener)),
        look_(std::make_shared<Look>(context, look_every)) {
    core_->stream().non_blocking(true);
    asio::post(context, [core = core_] {
      if (core->listener() != nullptr) core->begin();
    });
    look_->at_open = read_line_errors(descriptor);
    if (look_->at_open || read_modem_lines(descriptor)) look_again(core_, look_);
  }
  ~SerialLink() override {
    look_->timer.cancel();
    leave_port(core_->stream().native_handle());
    core_->detach();
  }

  std::size_t write(std::span<const std::byte> bytes) override { return core_->write(bytes); }
  std::size_t read(std::span<std::byte> into) override { return core_->read(into); }
  // A pseudo-terminal says 0 whatever it holds; it is not asked.
  std::optional<std::uint64_t> unsent() override {
    return has_queue_ ? read_unsent(core_->stream().native_handle()) : std::nullopt;
  }
  std::optional<std::uint64_t> unconfirmed() override { return std::nullopt; }
  bool set_rts(bool on) override { return io::set_rts(core_->stream().native_handle(), on); }
  [[nodiscard]] app::LineErrors errors() const override { return look_->errors; }
  [[nodiscard]] bool unheard() const override { return core_->unheard(); }
  [[nodiscard]] std::string_view note() const override { return core_->note(); }

 private:
  static void look_again(const std::shared_ptr<SerialCore>& core, const std::shared_ptr<Look>& look) {
    look->timer.expires_after(look->every);
    look->timer.async_wait([core, look](boost::system::error_code error) {
      if (error || core->listener() == nullptr) return;
      const int descriptor = core->stream().native_handle();
      if (const auto counted = read_line_errors(descriptor); counted && look->at_open) {
        look->errors = since(*look->at_open, *counted);
      }
      const ModemLines before = look->lines;
      look->lines = read_modem_lines(descriptor).value_or(before);
      const ModemLines now = look->lines;
      if (now.cts != before.cts) core->listener()->on_cts(now.cts);
      if (core->listener() != nullptr && now.dsr != before.dsr) core->listener()->on_dsr(now.dsr);
      look_again(core, look);
    });
  }

  bool has_queue_;
  std::shared_ptr<SerialCore> core_;
  std::shared_ptr<Look> look_;
};

}  // namespace

std::expected<std::unique_ptr<app::Link>, std::string> open_serial_link(boost::asio::io_context& context,
                                                                        const machine::LineSettings& line,
                                                                        app::LinkListener& listener) {
  const auto descriptor = open_serial_port(line);
  if (!descriptor) return std::unexpected(descriptor.error());
  return std::make_unique<SerialLink>(context, *descriptor, line.link.kind != machine::LinkKind::pty,
                                      machine::polls_flow_lines(line) ? kFlowLook : kLook, listener);
}

}  // namespace dripfeed::io

// One io_context, one thread. After the handlers that were ready the earliest deadline of all tickers is looked up and
// the one timer set to it, in absolute time.
#include "server/io/link_thread.h"

#include <algorithm>
#include <exception>
#include <future>
#include <thread>
#include <vector>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>

#include "server/app/ports/line_mutex.h"
#include "server/io/steady_clock.h"
#include "server/io/stream_link.h"
#include "server/io/thread_priority.h"

namespace dripfeed::io {

namespace {

namespace asio = boost::asio;

// Handlers between two looks at the tickers, at most, and how long they may take together.
constexpr std::size_t kMostAtOnce = 256;
constexpr feed::Time kLongestAtOnce = std::chrono::milliseconds(1);
constexpr feed::Time kAfterException = std::chrono::milliseconds(1);
constexpr feed::Time kComplainEvery = std::chrono::seconds(10);

class AsioLinkThread final : public app::LinkThread {
 public:
  AsioLinkThread() : timer_(context_), work_(asio::make_work_guard(context_)), thread_([this] { loop(); }) {}
  ~AsioLinkThread() override {
    asio::post(context_, [this] {
      timer_.cancel();
      work_.reset();
      stopping_ = true;
    });
    thread_.join();
  }

  [[nodiscard]] const app::Clock& clock() const override { return clock_; }
  void post(std::function<void()> work) override { asio::post(context_, std::move(work)); }
  void run(const std::function<void()>& work) override {
    std::promise<void> done;
    asio::post(context_, [&] {
      try {
        work();
      } catch (...) {
        return done.set_exception(std::current_exception());  // it is the caller's
      }
      done.set_value();
    });
    done.get_future().get();
  }
  void add(app::Ticker& ticker) override { tickers_.push_back(&ticker); }
  void remove(app::Ticker& ticker) override { std::erase(tickers_, &ticker); }
  std::expected<std::unique_ptr<app::Link>, std::string> open(const machine::LineSettings& line,
                                                              app::LinkListener& listener) override {
    return open_link(context_, line, listener);
  }

 private:
  // Everything that is ready first (what came in may stop what would go out), then one look at all tickers: so a look
  // costs the same whether one line spoke or hundreds did.
  void loop() {
    // A character that leaves late costs line time.
    ::prctl(PR_SET_NAME, "lines");
    app::LineWaits::serve_lines_here();
    go_before_others();
    stay_in_memory();
    while (!stopping_ && turn()) continue;
    // What the links left over (aborted waits) still refers to the context: give each its last call.
    context_.poll();
  }

  // False: there is nothing left to wait for. This is the fence of the thread: what one line throws (no memory, say) is
  // reported, and the others are served on.
  bool turn() {
    try {
      if (context_.run_one() == 0) return false;
      const feed::Time until = clock_.now() + kLongestAtOnce;
      for (std::size_t i = 0; i < kMostAtOnce && !stopping_ && context_.poll_one() > 0 && clock_.now() < until; ++i)
        continue;
      set_timer(run_due());
    } catch (const std::exception& error) {
      complain(error);
      set_timer(clock_.now() + kAfterException);  // the tickers that were not reached
    }
    return true;
  }

  void complain(const std::exception& error) {
    const feed::Time now = clock_.now();
    if (now < complain_at_) return;
    complain_at_ = now + kComplainEvery;
    spdlog::critical("the thread of the lines: {}", error.what());
  }

  // False: it threw. A fence of its own: who throws at each call must not keep those after it in the list from theirs.
  bool tick(app::Ticker& ticker, feed::Time now) {
    try {
      ticker.tick(now);
      return true;
    } catch (const std::exception& error) {
      complain(error);
      return false;
    }
  }

  // Ticks who is due; when the next one will be.
  std::optional<feed::Time> run_due() {
    std::optional<feed::Time> earliest;
    const feed::Time now = clock_.now();
    for (std::size_t i = 0; i < tickers_.size(); ++i) {
      app::Ticker* const ticker = tickers_[i];
      auto deadline = ticker->deadline();
      if (deadline && *deadline <= now) {
        const bool is_well = tick(*ticker, now);
        if (i >= tickers_.size() || tickers_[i] != ticker) {
          earliest = now;  // it left, and another stands in its place: look again
          continue;
        }
        deadline = is_well ? ticker->deadline() : now + kAfterException;
      }
      if (deadline && (!earliest || *deadline < *earliest)) earliest = deadline;
    }
    return earliest;
  }

  void set_timer(std::optional<feed::Time> earliest) {
    if (earliest == armed_for_) return;
    armed_for_ = earliest;
    if (!earliest) {
      timer_.cancel();
      return;
    }
    timer_.expires_at(std::chrono::steady_clock::time_point(*earliest));
    timer_.async_wait([this](boost::system::error_code error) {
      if (!error) armed_for_.reset();  // run_due() follows every handler
    });
  }

  SteadyClock clock_;
  asio::io_context context_{1};
  asio::steady_timer timer_;
  asio::executor_work_guard<asio::io_context::executor_type> work_;
  std::vector<app::Ticker*> tickers_;
  std::optional<feed::Time> armed_for_;
  feed::Time complain_at_{};
  bool stopping_ = false;
  std::jthread thread_;
};

}  // namespace

std::unique_ptr<app::LinkThread> start_link_thread() { return std::make_unique<AsioLinkThread>(); }

}  // namespace dripfeed::io

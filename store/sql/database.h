// The store as a whole: one connection that writes, one transaction at a time, and as many that read as threads want at
// once. A body runs inside one transaction and is undone when it or the engine fails.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "store/sql/session.h"
#include "store/sql/write_lane.h"

namespace dripfeed::sql {

class Database {
 public:
  enum class May : std::uint8_t { write, read };
  // The store exists and its schema is up to date.
  static store::Result<std::unique_ptr<Database>> open(std::unique_ptr<Engine> engine, May may = May::write);

  // Runs body(Session&) -> store::Result<T> as one transaction. On a thread that is inside another one already, it
  // joins that, and is undone alone when it fails.
  template <class F>
  auto write(std::string_view about, F&& body) -> std::invoke_result_t<F, Session&> {
    return write_in_turn(Turn::in_order, about, std::forward<F>(body));
  }
  // The same for what a feed waits for: it goes before all others that wait. Keep it short.
  template <class F>
  auto write_first(std::string_view about, F&& body) -> std::invoke_result_t<F, Session&> {
    return write_in_turn(Turn::first, about, std::forward<F>(body));
  }

  // The same for small changes that come from many callers at once: those that wait together are made one after the
  // other and share one commit. One that is refused is undone alone. Each returns when that commit is durable; if it
  // fails, all of them fail. Whoever has the lane runs the body, so it must not rest on its thread, nor take a lock
  // that a caller may hold.
  template <class F>
  auto write_shared(std::string_view about, F&& body) -> std::invoke_result_t<F, Session&> {
    if (writing_here()) return write(about, std::forward<F>(body));
    OneShared<std::remove_reference_t<F>> change(*this, about, body);
    make_shared(change);
    if (change.thrown) std::rethrow_exception(change.thrown);
    if (!change.committed) return std::unexpected(change.committed.error());
    return std::move(*change.result);
  }

  // Runs body(Session&) -> store::Result<T> on one state of the database. It may not change anything. Inside a
  // transaction of the same thread it sees what that wrote.
  template <class F>
  auto read(std::string_view about, F&& body) -> std::invoke_result_t<F, Session&> {
    Reading reading(*this);
    if (auto begun = reading.begin(); !begun) return std::unexpected(begun.error());
    Session session(reading.connection(), about);
    auto result = std::invoke(std::forward<F>(body), session);
    if (!session.ok()) return std::unexpected(session.error());
    return result;
  }

  // Another number after every commit, see Store::version().
  store::Result<std::uint64_t> version();

  [[nodiscard]] store::StoreUse use() const { return lane_.use(); }

 private:
  explicit Database(std::unique_ptr<Engine> engine) : engine_(std::move(engine)) {}

  template <class F>
  auto write_in_turn(Turn turn, std::string_view about, F&& body) -> std::invoke_result_t<F, Session&> {
    Writing writing(*this, turn);
    if (auto begun = writing.begin(); !begun) return std::unexpected(begun.error());
    Session session(*writer_, about);
    auto result = std::invoke(std::forward<F>(body), session);
    if (!session.ok()) return std::unexpected(session.error());
    if (!result) return result;
    if (auto committed = writing.commit(); !committed) return std::unexpected(committed.error());
    return result;
  }

  // The change of one caller of write_shared().
  template <class F>
  struct OneShared final : SharedChange {
    OneShared(Database& to, std::string_view what, F& change) : database(to), about(what), body(change) {}
    void make() override {
      try {
        result = database.write(about, body);
        if (!*result) refused = result->error();
      } catch (const std::exception&) {
        thrown = std::current_exception();
      }
    }
    Database& database;
    std::string_view about;
    F& body;
    std::optional<std::invoke_result_t<F&, Session&>> result{};
    std::exception_ptr thrown{};
  };
  // Returns when the change is durable or has failed.
  void make_shared(SharedChange& change);

  // The outer transaction holds the lane; inner ones are savepoints. The destructor undoes what was not committed.
  class Writing {
   public:
    Writing(Database& database, Turn turn) : database_(database), turn_(turn) {}
    Writing(const Writing&) = delete;
    Writing& operator=(const Writing&) = delete;
    ~Writing();
    store::Result<void> begin();
    store::Result<void> commit();

   private:
    void undo();

    Database& database_;
    Turn turn_;
    bool holds_lane_ = false;  // the outer one does
    bool open_ = false;
  };

  class Reading {
   public:
    explicit Reading(Database& database) : database_(database) {}
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
    ~Reading();
    store::Result<void> begin();
    [[nodiscard]] Connection& connection() const { return *connection_; }

   private:
    store::Result<void> begin_on(Connection& connection);

    Database& database_;
    std::unique_ptr<Connection> own_;  // from the pool
    Connection* connection_ = nullptr;
  };

  store::Result<std::uint64_t> ask_version();
  store::Result<void> begin_to_write();
  [[nodiscard]] bool writing_here() const { return writing_thread_.load() == std::this_thread::get_id(); }

  std::unique_ptr<Engine> engine_;
  bool may_write_ = false;
  std::unique_ptr<Connection> writer_;  // another one after it broke; while the lane is taken
  WriteLane lane_;
  std::atomic<std::thread::id> writing_thread_;
  int depth_ = 0;  // of transactions inside each other; while the lane is taken
  std::mutex pool_mutex_;
  std::vector<std::unique_ptr<Connection>> pool_;
  std::mutex version_mutex_;
  std::unique_ptr<Connection> version_reader_;  // never writes: every commit is another's to it
};

}  // namespace dripfeed::sql

// The file as a whole: one connection that writes, with a lock around it, and as many that read as threads want at
// once. A body runs inside one transaction and is undone when it or the engine fails.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "store/sqlite/session.h"

namespace dripfeed::sqlite {

class Database {
 public:
  // The file exists and its schema is up to date.
  static store::Result<std::unique_ptr<Database>> open(const std::string& path, const OpenSettings& settings);

  // Runs body(Session&) -> store::Result<T> as one transaction. On a thread that is inside another one already, it
  // joins that, and is undone alone when it fails.
  template <class F>
  auto write(std::string_view about, F&& body) -> std::invoke_result_t<F, Session&> {
    Writing writing(*this);
    if (auto begun = writing.begin(); !begun) return std::unexpected(begun.error());
    Session session(*writer_, about);
    auto result = std::invoke(std::forward<F>(body), session);
    if (!session.ok()) return std::unexpected(session.error());
    if (!result) return result;
    if (auto committed = writing.commit(); !committed) return std::unexpected(committed.error());
    return result;
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

  // A connection of one's own, for long reads.
  [[nodiscard]] store::Result<std::unique_ptr<Connection>> connect_to_read() const;
  [[nodiscard]] const OpenSettings& settings() const { return settings_; }

 private:
  Database(std::string path, OpenSettings settings) : path_(std::move(path)), settings_(std::move(settings)) {}

  // The outer transaction holds the lock; inner ones are savepoints. The destructor undoes what was not committed.
  class Writing {
   public:
    explicit Writing(Database& database) : database_(database) {}
    Writing(const Writing&) = delete;
    Writing& operator=(const Writing&) = delete;
    ~Writing();
    store::Result<void> begin();
    store::Result<void> commit();

   private:
    Database& database_;
    std::unique_lock<std::mutex> lock_;  // held by the outer one
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
    Database& database_;
    std::unique_ptr<Connection> own_;  // from the pool
    Connection* connection_ = nullptr;
  };

  [[nodiscard]] bool writing_here() const { return writing_thread_.load() == std::this_thread::get_id(); }

  std::string path_;
  OpenSettings settings_;
  std::unique_ptr<Connection> writer_;
  std::mutex write_mutex_;
  std::atomic<std::thread::id> writing_thread_;
  int depth_ = 0;  // of transactions inside each other; under write_mutex_
  std::mutex pool_mutex_;
  std::vector<std::unique_ptr<Connection>> pool_;
};

}  // namespace dripfeed::sqlite

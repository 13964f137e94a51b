// Looks at the log's length five times a second.
#include "store/sqlite/checkpointer.h"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include "store/sql/session.h"

namespace dripfeed::sqlite {
namespace {

using sql::Query;
using sql::Session;

constexpr std::chrono::milliseconds kLookEvery{200};

}  // namespace

Checkpointer::Checkpointer(std::string path, std::unique_ptr<Connection> connection)
    : log_path_(std::move(path) + "-wal"),
      connection_(std::move(connection)),
      thread_([this](const std::stop_token& stop) { loop(stop); }) {}

Checkpointer::~Checkpointer() {
  thread_.request_stop();
  thread_.join();
}

void Checkpointer::loop(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(mutex_);
      woken_.wait_for(lock, stop, kLookEvery, [] { return false; });
    }
    std::error_code unknown;
    const auto length = std::filesystem::file_size(log_path_, unknown);
    if (unknown || length < kLogBytes) continue;
    // A failure leaves the log as it is: the next look tries again, and at kFallbackPages a commit does it and reports.
    Session session(*connection_, "checkpoint");
    Query(session, "PRAGMA wal_checkpoint(PASSIVE)").next();
  }
}

}  // namespace dripfeed::sqlite

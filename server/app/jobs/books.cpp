// The ledger hands to the follower, so it is waited for, and stopped, first.
#include "server/app/jobs/books.h"

#include <algorithm>
#include <utility>

namespace dripfeed::app {

namespace {

constexpr std::chrono::milliseconds kPatience{5'000};  // a person waits for an answer

}  // namespace

Books::Books(store::Store& store, Lines& lines, Events& events, Alarms& alarms, const Clock& clock,
             DiskReserve* disk_reserve)
    : disk_reserve_(disk_reserve),
      follower_(store, events, alarms, texts_, clock),
      ledger_(store, lines, clock, disk_reserve, [this](std::vector<Booked> booked, const std::string& complaint) {
        follower_.take(std::move(booked), complaint);
      }) {}

Books::~Books() {
  ledger_.stop();
  follower_.stop();
}

void Books::expect(store::Id job, std::uint64_t session, std::string_view machine) {
  ledger_.expect(job, session, machine);
}

void Books::reset_confirmed(const std::string& machine, std::string_view reason) {
  ledger_.reset_confirmed(machine, reason);
  ledger_.wake();
}

void Books::read_for(std::uint64_t session, std::shared_ptr<ContentSource> source) {
  texts_.read_for(session, std::move(source));
}

bool Books::wait_until_booked() {
  const auto until = std::chrono::steady_clock::now() + kPatience;
  const auto left = [&] {
    return std::max(std::chrono::milliseconds(0),
                    std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now()));
  };
  return ledger_.wait_for_round(left()) && follower_.wait_for_round(left());
}

}  // namespace dripfeed::app

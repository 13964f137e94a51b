// What the tests of the use cases share: a shop with a real store in a folder that goes away, lines over links without
// a system, and the steps from a text to a job that may be armed.
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "server/app/application.h"
#include "store/sqlite/open.h"
#include "tests/support/fake_links.h"
#include "tests/support/temp_folder.h"
#include "tests/support/watched_store.h"
#include "tests/unit/server/app/feeding.h"

namespace dripfeed::app::test {

// A profile is "NAME URL" of a Fanuc mill; values are "name=value;…"; a report is its verdict.
class PlainDocuments final : public Documents {
 public:
  [[nodiscard]] Result<machine::Profile> read_profile(std::string_view document) const override;
  [[nodiscard]] Result<Values> read_values(std::string_view document) const override;
  [[nodiscard]] std::string write_values(const Values& values) const override;
  [[nodiscard]] std::string write_report(const CheckReport& report) const override;
  [[nodiscard]] std::optional<double> cycle_s(std::string_view report) const override;
  [[nodiscard]] std::string write_drawing(const std::vector<family::DrawnView>& drawing) const override;
};

// The value, or the test ends with the error's text.
template <class T>
T must(Result<T> result) {
  if (!result) ADD_FAILURE() << result.error().text;
  return std::move(result).value();
}
template <class T>
T must(store::Result<T> result) {
  if (!result) ADD_FAILURE() << store::message_of(result.error());
  return std::move(result).value();
}
inline void must(const Result<void>& result) {
  if (!result) ADD_FAILURE() << result.error().text;
}
inline void must(const store::Result<void>& result) {
  if (!result) ADD_FAILURE() << store::message_of(result.error());
}
// What a refused call said. One that was not refused fails the test.
template <class T>
Error refusal(const Result<T>& result) {
  if (result) ADD_FAILURE() << "it was not refused";
  return result ? Error{} : result.error();
}

inline store::Stamp by(std::string actor) { return {std::move(actor), dripfeed::test::VirtualClock::kWallStart_ms}; }
inline std::string url_of(const std::string& machine) { return "pty:/machine/" + machine; }

// A copy of what a server that is killed now leaves on its disk.
std::string killed_copy(const std::string& database);

// A text that is released for this machine, with a passing verdict and an approval.
store::Release release_text(store::Store& store, const std::string& machine, const std::string& text,
                            store::Delivery delivery = store::Delivery::drip);

// The use cases without the object that holds them together in a server: so that a test can end them as kill -9 would.
class Shop {
 public:
  explicit Shop(const std::string& database, BusSeatMaker take_seat = nullptr, DiskReserve* disk_reserve = nullptr,
                ClaimLine claim = {});
  ~Shop();
  Shop(const Shop&) = delete;
  Shop& operator=(const Shop&) = delete;

  void add_machine(const std::string& name, const std::string& url = {});
  store::Job add_job(const std::string& machine, const std::string& text);
  // Added, armed and asked for by the control; its first window is reserved.
  store::Job start_job(const std::string& machine, const std::string& text);
  // Time passes; the books follow.
  void run(feed::Time span);
  void round();
  [[nodiscard]] std::string written(const std::string& machine);
  [[nodiscard]] LineReport report(const std::string& machine) const { return lines.find(machine)->report(); }
  [[nodiscard]] store::Job job(store::Id id) { return must(store.jobs().get(id)); }
  [[nodiscard]] store::JobState state(store::Id id) { return job(id).state; }
  // Texts of the events so far, "KIND MACHINE TEXT" each.
  [[nodiscard]] std::vector<std::string> published() const;
  // The last one but for the machine's, which come when the books get round to it.
  [[nodiscard]] std::string last_published() const;
  // Actions on a job in the audit, oldest first: "ACTION: DETAIL".
  [[nodiscard]] std::vector<std::string> audited(store::Id job);
  [[nodiscard]] std::vector<store::LedgerRow> ledger_of(store::Id job);

 private:
  std::unique_ptr<store::Store> sqlite_;

 public:
  dripfeed::test::FakeLinkThread links;
  PlainDocuments documents;
  dripfeed::test::WatchedStore store;
  Events events;
  Alarms alarms;
  Lines lines;
  Books books;
  Catalog catalog;
  Jobs jobs;
};

class ShopTest : public ::testing::Test {
 protected:
  static constexpr const char* kLathe = "lathe";
  [[nodiscard]] std::string database() const { return folder_.file("shop.db"); }

  dripfeed::test::TempFolder folder_{dripfeed::test::TempFolder::Where::memory};
};

}  // namespace dripfeed::app::test

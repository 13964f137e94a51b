// What the tests of the store share: a folder that goes away, a store in it, and the steps from a machine to a job.
#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "store/sqlite/open.h"

namespace dripfeed::store {

void PrintTo(ErrorCode code, std::ostream* out);  // by the name that googletest looks for

}  // namespace dripfeed::store

namespace dripfeed::store_test {

class TempFolder {
 public:
  // In memory where the system has such a place: for tests that open small stores very often.
  enum class Where : std::uint8_t { disk, memory };
  explicit TempFolder(Where where = Where::disk);
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  ~TempFolder();
  [[nodiscard]] std::string file(std::string_view name) const;

 private:
  std::filesystem::path path_;
};

// The value, or the test ends with the error's text.
template <class T>
T must(store::Result<T> result) {
  if (!result) ADD_FAILURE() << store::message_of(result.error());
  return std::move(result).value();
}
inline void must(const store::Result<void>& result) {
  if (!result) ADD_FAILURE() << store::message_of(result.error());
}

// The code of a refused call. A call that was not refused fails the test.
template <class T>
store::ErrorCode refusal(const store::Result<T>& result) {
  if (result) ADD_FAILURE() << "it was not refused";
  return result ? store::ErrorCode::internal : result.error().code;
}

inline store::Stamp by(std::string actor, std::int64_t at_ms = 1000) { return {std::move(actor), at_ms}; }

// A machine, a family, a part, a program rendered from it, a passing verdict, and a release that is approved.
struct Released {
  store::Program program;
  store::Verdict verdict;
  store::Release release;
};
store::Program add_program(store::Store& store, const std::string& text, const std::string& name = "O0100");
store::Program add_rendered(store::Store& store, const std::string& text, const std::string& machine);
store::Verdict add_verdict(store::Store& store, const store::Program& program, const std::string& machine,
                           store::Outcome outcome = store::Outcome::pass);
store::Release approve(store::Store& store, const store::Program& program, const std::string& machine);
// From here on no operator has to sign a proving of this machine off.
void waive_operators(store::Store& store, const std::string& machine);
Released add_released(store::Store& store, const std::string& machine, const std::string& text = "%\nM30\n%\n");
store::Job add_job(store::Store& store, const std::string& machine);
// Moves a queued job by allowed steps.
void bring(store::Store& store, store::Id job, store::JobState state);

// What the tests run on: the environment's DRIPFEED_STORE_ENGINE names it; SQLite without it.
enum class EngineKind : std::uint8_t { sqlite, postgresql };
EngineKind engine();

class StoreTest : public ::testing::Test {
 protected:
  explicit StoreTest(TempFolder::Where where = TempFolder::Where::memory);
  ~StoreTest() override;
  void reopen(const sqlite::OpenSettings& settings = {});
  // The same store once more, as another process has it.
  [[nodiscard]] store::Result<std::unique_ptr<store::Store>> open_second(
      const sqlite::OpenSettings& settings = {}) const;
  [[nodiscard]] std::string path() const { return folder_.file("dripfeed.db"); }  // on SQLite
  // Runs SQL next to the store; the engine's words, "" when it went well.
  [[nodiscard]] std::string sql(const std::string& text) const;
  [[nodiscard]] static std::string_view zero_byte() { return engine() == EngineKind::postgresql ? "'\\x00'" : "x'00'"; }
  void drop_trigger(const std::string& name, const std::string& table) const;

  TempFolder folder_;
  std::string database_;  // on PostgreSQL
  std::unique_ptr<store::Store> store_;
};

}  // namespace dripfeed::store_test

// What becomes of a punch, of a request and of a read-back, in virtual time: delays, expiries, torn answers.
#include "server/app/receive/receiving.h"

#include <chrono>

#include "protocol/tape_code/parity.h"
#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app::test {
namespace {

using namespace std::chrono_literals;

// The plain ones, with the section `receive` of a profile.
class TunedDocuments final : public Documents {
 public:
  machine::ReceiveSettings receive;

  [[nodiscard]] Result<machine::Profile> read_profile(std::string_view document) const override {
    auto profile = plain_.read_profile(document);
    if (profile) profile->line.receive = receive;
    return profile;
  }
  [[nodiscard]] Result<Values> read_values(std::string_view document) const override {
    return plain_.read_values(document);
  }
  [[nodiscard]] std::string write_values(const Values& values) const override { return plain_.write_values(values); }
  [[nodiscard]] std::string write_report(const CheckReport& report) const override {
    return plain_.write_report(report);
  }
  [[nodiscard]] std::optional<double> cycle_s(std::string_view report) const override { return plain_.cycle_s(report); }
  [[nodiscard]] std::string write_drawing(const std::vector<family::DrawnView>& drawing) const override {
    return plain_.write_drawing(drawing);
  }

 private:
  PlainDocuments plain_;
};

std::string on_wire(std::string_view text) {
  std::string wire;
  for (const char c : text) {
    wire += static_cast<char>(tape_code::with_parity(static_cast<std::uint8_t>(c), tape_code::EighthBit::even));
  }
  return wire;
}

class ReceivingTest : public ShopTest {
 protected:
  void open(const std::string& options = "") {
    url_ = url_of(kLathe) + options;
    shop_.emplace(database());
    shop_->add_machine(kLathe, url_);
    begin();
  }
  // As after a restart of the server: the same store, nothing in memory.
  void begin() {
    receiving_.reset();
    programs_.emplace(shop_->store, shop_->links.clock(), documents_);
    receiving_.emplace(Receiving::Parts{shop_->store, shop_->lines, shop_->jobs, *programs_, shop_->events,
                                        shop_->alarms, shop_->links.clock(), documents_});
    receiving_->stop();  // rounds are made here
  }
  void run(feed::Time span) {
    for (feed::Time passed{}; passed < span; passed += 250ms) {
      shop_->run(std::min<feed::Time>(250ms, span - passed));
      receiving_->round();
    }
  }
  void punch(const std::string& text, std::string_view end = "\x14") {
    shop_->links.receive(url_, "\x12" + on_wire(text) + std::string(end));
    receiving_->round();
  }
  void ask(const std::string& words) { punch("%\nO9999(" + words + ")\n%\n"); }
  void send_text(std::string_view sign) { shop_->links.receive(url_, sign); }
  // What the control got since the last call.
  std::string got() {
    const std::string all = text_of(shop_->links.cable(url_).written);
    const std::string news = all.substr(seen_);
    seen_ = all.size();
    return news;
  }
  store::Job load(const std::string& text) {
    const store::Release release = release_text(shop_->store, kLathe, text, store::Delivery::memory);
    return load_again(release.id);
  }
  store::Job load_again(store::Id release) {
    const store::Job job = must(shop_->jobs.add(release, "anna"));
    must(shop_->jobs.arm(job.id, std::nullopt, "olga"));
    send_text(kDc1);
    run(5s);
    EXPECT_EQ(shop_->state(job.id), store::JobState::done);
    return shop_->job(job.id);
  }
  [[nodiscard]] bool published(std::string_view words) {
    shop_->alarms.wait_for_round(10s);
    const auto all = shop_->published();
    return std::ranges::any_of(all, [&](const std::string& one) { return one.find(words) != std::string::npos; });
  }
  std::vector<store::Receipt> receipts() {
    return must(shop_->store.receipts().list({.limit = 50, .after = {}}, {})).items;
  }
  store::Request request() { return must(shop_->store.receipts().requests({.limit = 1, .after = {}})).items.at(0); }

  std::string url_;
  std::size_t seen_ = 0;
  const std::string text_ = program(5);  // O0042
  TunedDocuments documents_;
  std::optional<Shop> shop_;
  std::optional<Programs> programs_;
  std::optional<Receiving> receiving_;
};

TEST_F(ReceivingTest, AControlThatDoesNotAskGetsItsAnswerAfterTheDelay) {
  documents_.receive.request_delay_s = 7.0;
  open("?start=at-once");
  ask("LOAD 4711");
  run(6900ms);
  EXPECT_EQ(got(), "");
  run(5s);
  EXPECT_EQ(got(), "%\nO9999(NOT FOUND 4711)\nM30\n%\n");
}

TEST_F(ReceivingTest, AControlThatDoesNotAskGetsItsProgramAfterTheDelay) {
  documents_.receive.request_delay_s = 7.0;
  open("?start=at-once");
  release_text(shop_->store, kLathe, text_, store::Delivery::memory);
  ask("LOAD 42");
  const store::Id job = request().of.job;
  run(6900ms);
  EXPECT_EQ(got(), "");
  EXPECT_EQ(shop_->state(job), store::JobState::queued);
  run(10s);
  EXPECT_EQ(got(), text_);
  EXPECT_EQ(shop_->state(job), store::JobState::done);
  EXPECT_EQ(shop_->job(job).armed_by, "operator at lathe");
}

TEST_F(ReceivingTest, AControlThatAsksGetsItsAnswerThenAndNotLater) {
  documents_.receive.request_delay_s = 7.0;
  open();
  ask("LOAD 4711");
  run(1s);
  EXPECT_EQ(got(), "") << "nothing goes out before DC1";
  send_text(kDc1);
  run(2s);
  EXPECT_EQ(got(), "%\nO9999(NOT FOUND 4711)\nM30\n%\n");
  send_text(kDc3);
  run(5s);
  ask("LOAD 4712");
  run(601s);
  send_text(kDc1);
  run(2s);
  EXPECT_EQ(got(), "") << "it expired";
}

TEST_F(ReceivingTest, ALoadThatIsNotFetchedExpires) {
  open();
  release_text(shop_->store, kLathe, text_, store::Delivery::memory);
  ask("LOAD 42");
  const store::Id job = request().of.job;
  EXPECT_EQ(shop_->state(job), store::JobState::armed);
  run(599s);
  EXPECT_EQ(shop_->state(job), store::JobState::armed);
  run(3s);
  EXPECT_EQ(shop_->state(job), store::JobState::cancelled);
  EXPECT_TRUE(published("alarm lathe a request expired: its program was not fetched"));
  send_text(kDc1);
  run(2s);
  EXPECT_EQ(got(), "");
}

TEST_F(ReceivingTest, AnAnswerHasTheNumberOfTheProfile) {
  documents_.receive.answer_number = 8500;
  open();
  ask("DIR");
  send_text(kDc1);
  run(2s);
  EXPECT_EQ(got(), "%\nO8500(0 PROGRAMS)\nM30\n%\n");
}

TEST_F(ReceivingTest, NoAnswerTakesThePlaceOfAProgramOfTheShop) {
  documents_.receive.answer_number = 42;
  open();
  release_text(shop_->store, kLathe, text_, store::Delivery::memory);
  ask("DIR");
  send_text(kDc1);
  run(2s);
  EXPECT_EQ(got(), "");
  EXPECT_TRUE(published("O0042 is a released program; set receive.answer_number"));
}

TEST_F(ReceivingTest, AfterATornAnswerNothingGoesOutUntilAPersonConfirms) {
  open();
  ask("LOAD 4711");
  send_text(kDc1);
  shop_->round();
  while (text_of(shop_->links.cable(url_).written).size() < 10) shop_->links.advance(1ms);
  shop_->links.lose(url_);
  run(2s);
  EXPECT_EQ(shop_->report(kLathe).state, LineState::torn);
  const std::string before = got();
  EXPECT_LT(before.size(), 20U);
  ask("DIR");
  send_text(kDc1);
  run(30s);
  EXPECT_EQ(got(), "") << "on a torn line";
  EXPECT_EQ(refusal(shop_->jobs.confirm_reset(kLathe, "", "olga")).code, ErrorCode::invalid);
  must(shop_->jobs.confirm_reset(kLathe, "the control was reset", "olga"));
  run(1s);
  EXPECT_EQ(shop_->report(kLathe).state, LineState::idle);
  const auto audit = must(shop_->store.audit().list({.limit = 5, .after = {}}, {.subject = "machine/lathe"})).items;
  EXPECT_TRUE(std::ranges::any_of(audit, [](const store::AuditRow& row) {
    return row.entry.action == "machine.confirm-reset" && row.entry.detail == "the control was reset";
  }));
  ask("DIR");
  send_text(kDc1);
  run(2s);
  EXPECT_EQ(got(), "%\nO9999(0 PROGRAMS)\nM30\n%\n");
}

// The same, but the server is killed while the answer goes out, and another one starts on what is on the disk.
TEST_F(ReceivingTest, AnAnswerThatAKillToreIsKnownAfterTheRestart) {
  open();
  ask("LOAD 4711");
  send_text(kDc1);
  shop_->round();
  while (text_of(shop_->links.cable(url_).written).size() < 10) shop_->links.advance(1ms);
  const std::string killed = killed_copy(database());
  shop_.emplace(killed);
  const auto torn = must(shop_->store.answers().tear_unfinished(by("server")));
  ASSERT_EQ(torn.size(), 1U);
  EXPECT_EQ(torn.front().machine, kLathe);
  ASSERT_TRUE(shop_->catalog.open_lines());
  begin();
  seen_ = 0;
  EXPECT_EQ(shop_->report(kLathe).state, LineState::torn);
  ask("DIR");
  ask("STATUS");
  send_text(kDc1);
  run(30s);
  EXPECT_EQ(got(), "") << "on a torn line";
  const store::Release release = release_text(shop_->store, kLathe, text_, store::Delivery::drip);
  const store::Job job = must(shop_->jobs.add(release.id, "anna"));
  EXPECT_NE(refusal(shop_->jobs.arm(job.id, std::nullopt, "olga")).text.find("answer 1"), std::string::npos);
  must(shop_->jobs.confirm_reset(kLathe, "the control was reset", "olga"));
  EXPECT_EQ(shop_->report(kLathe).state, LineState::idle);
  must(shop_->jobs.arm(job.id, std::nullopt, "olga"));
}

TEST_F(ReceivingTest, ALoadIsReadBack) {
  documents_.receive.read_back = true;
  open();
  const store::Job job = load(text_);
  EXPECT_EQ(job.read_back, "waiting for read-back");
  EXPECT_TRUE(published("job lathe read-back waiting for read-back"));
  punch(text_);
  EXPECT_EQ(shop_->job(job.id).read_back, "equal");
  EXPECT_TRUE(receipts().empty());
  EXPECT_EQ(shop_->ledger_of(job.id).back().note, "read-back equal");
}

TEST_F(ReceivingTest, AReadBackThatDiffersIsAnAlarmWithItsPlace) {
  documents_.receive.read_back = true;
  open();
  const store::Job job = load(text_);
  std::string other = text_;
  other.replace(other.find("X102."), 5, "X192.");
  punch(other);
  EXPECT_TRUE(shop_->job(job.id).read_back.starts_with("differs: line 5, column 6")) << shop_->job(job.id).read_back;
  EXPECT_TRUE(published("alarm lathe job 1: read-back differs: line 5"));
  EXPECT_EQ(receipts().size(), 1U) << "what came is kept";
}

TEST_F(ReceivingTest, AReadBackThatNeverComesExpiresAlsoAfterARestart) {
  documents_.receive.read_back = true;
  documents_.receive.read_back_minutes = 2.0;
  open();
  const store::Job job = load(text_);
  run(60s);
  EXPECT_EQ(shop_->job(job.id).read_back, "waiting for read-back");
  begin();
  run(50s);
  EXPECT_EQ(shop_->job(job.id).read_back, "waiting for read-back");
  run(20s);
  EXPECT_EQ(shop_->job(job.id).read_back, "expired: the control did not punch the program back");
  EXPECT_TRUE(published("alarm lathe job 1: read-back expired"));
  punch(text_);
  EXPECT_EQ(receipts().size(), 1U) << "too late: it is a punch as others";
}

TEST_F(ReceivingTest, ALoadOfTheSameProgramSupersedesTheOlderOne) {
  documents_.receive.read_back = true;
  open();
  const store::Job one = load(text_);
  const store::Job two = load_again(one.release);
  EXPECT_EQ(shop_->job(one.id).read_back, "superseded: job 2 loaded the program again");
  EXPECT_EQ(two.read_back, "waiting for read-back");
  punch(text_);
  EXPECT_EQ(shop_->job(two.id).read_back, "equal");
}

TEST_F(ReceivingTest, OneInQuarantineIsAcceptedByWhatCanBeRead) {
  open();
  punch("%\nO7\nG0X1.\n");
  const store::Receipt torn = receipts().at(0);
  ASSERT_EQ(torn.state, store::ReceiptState::quarantined);
  EXPECT_EQ(must(receiving_->readable(torn)), "%\nO7\nG0X1.\n");
  EXPECT_EQ(refusal(receiving_->accept(torn.id, {}, "anna")).code, ErrorCode::invalid);
  AcceptOrder order;
  order.reason = "only its % is missing";
  const store::Receipt accepted = must(receiving_->accept(torn.id, order, "anna"));
  EXPECT_EQ(accepted.state, store::ReceiptState::accepted);
  const store::Program program = must(shop_->store.programs().get(accepted.program));
  EXPECT_EQ(must(store::read_whole(shop_->store.contents(), program.newest.sha256, 1000)), "%\nO7\nG0X1.\n");
}

TEST_F(ReceivingTest, AControlsNameFindsTheProgramThatIsStoredUnderAPersonsName) {
  open();
  const store::Program stored = must(programs_->upload("ROLL_1", "fanuc", "G0X2.\nM30\n", "anna"));
  punch("%_N_ROLL_1_MPF\n;$PATH=/_N_MPF_DIR\nG0X1.\nM30\n%\n");
  const store::Receipt receipt = receipts().at(0);
  EXPECT_EQ(receipt.of.name, "ROLL_1_MPF");
  const auto likeness = must(receiving_->likeness(receipt));
  ASSERT_TRUE(likeness);
  EXPECT_EQ(likeness->program, stored.id);
  EXPECT_FALSE(likeness->same);
}

TEST_F(ReceivingTest, WhatADeviceServerSaysIsKeptOutOnce) {
  open();
  for (int i = 0; i < 5; ++i) {
    shop_->links.receive(url_, "Port already in use\r\n");
    run(6s);
  }
  ASSERT_EQ(receipts().size(), 1U);
  EXPECT_EQ(receipts()[0].state, store::ReceiptState::quarantined);
  EXPECT_NE(receipts()[0].of.reason.find("\"Port already in use\""), std::string::npos) << receipts()[0].of.reason;
}

}  // namespace
}  // namespace dripfeed::app::test

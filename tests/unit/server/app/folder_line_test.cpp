// A folder as a line: the whole file or none, under the control's name, never over another program; and what a text
// becomes in it.
#include "server/app/lines/folder_line.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>

#include "server/machine/file_drop.h"
#include "tests/support/temp_folder.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

void write(const fs::path& path, std::string_view text) { std::ofstream(path, std::ios::binary) << text; }

machine::Profile profile_of(const std::string& dialect, const std::string& url) {
  machine::Profile profile;
  profile.control.dialect = dialect;
  profile.line.link = machine::parse_link_url(url).value();
  return profile;
}

class FolderLineTest : public ::testing::Test {
 protected:
  static constexpr std::string_view kText = "%\nO0042\nG1X1.\nM30\n%\n";

  void open(const std::string& options = "") {
    machine::LineSettings settings;
    settings.link = machine::parse_link_url("dir:" + folder().string() + options).value();
    settings.eob = tape_code::Eob::cr_lf;
    line_ = make_folder_line(settings, [] {}).value();
    ASSERT_TRUE(until([](const LineReport& r) { return !r.link_error.ends_with("not looked at yet"); }));
  }
  [[nodiscard]] fs::path folder() const { return fs::path(temp_.path()) / "drop"; }
  std::expected<void, std::string> arm(std::string_view text, std::uint64_t reserve = 1 << 20) {
    feed::ProgramCheck check(feed::kParenthesesSyntax);
    check.append(text);
    return line_->arm({.job = ++job_,
                       .facts = check.finish().value(),
                       .source = std::make_shared<tape_code::SpanSource>(text),
                       .expires_after = 1min,
                       .reserve = reserve,
                       .session = job_,
                       .file_name = "O0042"});
  }
  template <class Condition>
  bool until(const Condition& condition) {
    for (int i = 0; i < 30'000; ++i) {
      if (condition(line_->report())) return true;
      std::this_thread::sleep_for(1ms);
    }
    return false;
  }
  bool ended(JobEnd how) {
    return until([&](const LineReport& r) { return r.end == how && r.job == job_; });
  }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder()), fs::directory_iterator()));
  }

  test::TempFolder temp_;
  std::unique_ptr<Line> line_;
  std::uint64_t job_ = 0;
};

TEST_F(FolderLineTest, AFolderThatWasLeftTornTakesNoJobBeforeAPersonConfirms) {
  fs::create_directory(folder());
  machine::LineSettings settings;
  settings.link = machine::parse_link_url("dir:" + folder().string()).value();
  line_ = make_folder_line(settings, [] {}, feed::LeftAs::torn).value();
  EXPECT_EQ(line_->report().state, LineState::torn);
  ASSERT_TRUE(until([](const LineReport& r) { return r.link_error.empty(); }));
  EXPECT_EQ(line_->report().state, LineState::torn) << "after a look, too";
  EXPECT_FALSE(arm(kText));
  ASSERT_TRUE(line_->command(feed::Command::confirm_reset));
  ASSERT_TRUE(until([](const LineReport& r) { return r.state == LineState::idle; }));
  EXPECT_TRUE(arm(kText));
}

TEST_F(FolderLineTest, TheFileLiesThereWhole) {
  fs::create_directory(folder());
  open();
  ASSERT_TRUE(arm(kText));
  ASSERT_TRUE(ended(JobEnd::done));
  EXPECT_EQ(contents(folder() / "O0042"), "%\r\nO0042\r\nG1X1.\r\nM30\r\n%\r\n");
  EXPECT_EQ(files(), 1U) << "nothing else stays";
  const LineReport report = line_->report();
  EXPECT_EQ(report.confirmed, 25U);
  EXPECT_EQ(report.total, 25U);
  EXPECT_TRUE(report.confirms);
  EXPECT_EQ(report.known.to_text, kText.size());
  ASSERT_TRUE(arm(kText));
  EXPECT_TRUE(ended(JobEnd::done)) << "the same text may be put there again";
}

TEST_F(FolderLineTest, AnotherProgramIsNotReplaced) {
  fs::create_directory(folder());
  write(folder() / "O0042", "the shop's own");
  open();
  ASSERT_TRUE(arm(kText));
  ASSERT_TRUE(ended(JobEnd::failed));
  EXPECT_EQ(line_->report().cause, "another program lies there under this name");
  EXPECT_EQ(contents(folder() / "O0042"), "the shop's own");
  EXPECT_EQ(files(), 1U);
}

TEST_F(FolderLineTest, UnlessTheLinkSaysSo) {
  fs::create_directory(folder());
  write(folder() / "O0042", "old");
  open("?overwrite=yes&eob=lf");
  ASSERT_TRUE(arm(kText));
  ASSERT_TRUE(ended(JobEnd::done));
  EXPECT_EQ(contents(folder() / "O0042"), kText);
}

TEST_F(FolderLineTest, NoOneSeesAFileBeforeItIsWhole) {
  fs::create_directory(folder());
  open();
  ASSERT_TRUE(arm(kText, 10));
  ASSERT_TRUE(until([](const LineReport& r) { return r.stall == "waiting for ledger"; }));
  EXPECT_EQ(line_->report().handed, 10U) << "no more than the ledger reserved";
  EXPECT_EQ(line_->report().known.to, 0U) << "a file without its name is nothing to the control";
  EXPECT_FALSE(fs::exists(folder() / "O0042"));
  ASSERT_TRUE(line_->command(feed::Command::cancel));
  ASSERT_TRUE(ended(JobEnd::cancelled));
  EXPECT_EQ(files(), 0U);
  ASSERT_TRUE(arm(kText, 10));
  line_->extend_reserve(job_, 25);
  EXPECT_TRUE(ended(JobEnd::done));
}

TEST_F(FolderLineTest, AFolderThatIsNotThereIsNamed) {
  open();
  EXPECT_EQ(line_->report().state, LineState::disconnected);
  EXPECT_EQ(line_->report().link_error, folder().string() + ": No such file or directory");
  EXPECT_FALSE(arm(kText));
  fs::create_directory(folder());
  EXPECT_TRUE(until([](const LineReport& r) { return r.state == LineState::idle && r.link_error.empty(); }));
  EXPECT_FALSE(line_->command(feed::Command::stop));
}

TEST_F(FolderLineTest, AJobThatFindsNoPlaceForItsFileGoesBack) {
  fs::create_directory(folder());
  open();
  fs::remove(folder());
  const auto armed = arm(kText);
  ASSERT_TRUE(armed) << armed.error();
  ASSERT_TRUE(ended(JobEnd::disarmed));
  EXPECT_EQ(line_->report().cause, "the folder does not take a file");
  EXPECT_EQ(line_->report().handed, 0U);
}

TEST_F(FolderLineTest, OnlyWhatWasLongAbandonedIsRemoved) {
  fs::create_directory(folder());
  write(folder() / ".dripfeed-7", "of another line that writes now");
  write(folder() / ".dripfeed-3", "of a lost power");
  fs::last_write_time(folder() / ".dripfeed-3", fs::file_time_type::clock::now() - 11min);
  open();
  EXPECT_TRUE(fs::exists(folder() / ".dripfeed-7"));
  EXPECT_FALSE(fs::exists(folder() / ".dripfeed-3"));
}

TEST(FileDrop, NamesFollowTheControl) {
  using machine::file_name_for;
  EXPECT_EQ(file_name_for(profile_of("fanuc", "dir:/x"), "O0042"), "O0042");
  EXPECT_EQ(file_name_for(profile_of("fanuc", "dir:/x?ext=NC"), "o0042"), "O0042.NC");
  EXPECT_EQ(file_name_for(profile_of("mazak", "dir:/x"), "O0042"), "O0042.EIA");
  EXPECT_EQ(file_name_for(profile_of("mazak", "dir:/x?ext=none"), "100"), "100");
  EXPECT_EQ(file_name_for(profile_of("sinumerik-840d", "dir:/x"), "shaft_1"), "SHAFT_1.MPF");
  EXPECT_EQ(file_name_for(profile_of("sinumerik-840d", "dir:/x"), "_N_SHAFT_SPF"), "SHAFT.SPF");
  EXPECT_EQ(file_name_for(profile_of("sinumerik-840d", "dir:/x"), "shaft.spf"), "SHAFT.SPF");
  EXPECT_FALSE(file_name_for(profile_of("sinumerik-840d", "dir:/x"), "1SHAFT"));
  EXPECT_FALSE(file_name_for(profile_of("sinumerik-840d", "dir:/x"), "A23456789012345678901234X"));
  EXPECT_FALSE(file_name_for(profile_of("fanuc", "dir:/x"), "../O1"));
  EXPECT_FALSE(file_name_for(profile_of("fanuc", "dir:/x"), ""));
  EXPECT_FALSE(file_name_for(profile_of("fanuc", "dir:/x"), "a b"));
}

TEST(FileDrop, AFileOfSinumerikHasNoHeadOfAnArchive) {
  using machine::file_part;
  EXPECT_EQ(file_part("%_N_ROLL_MPF\n;$PATH=/_N_MPF_DIR\nG0 X1\nM30\n%\n"), "G0 X1\nM30\n");
  EXPECT_EQ(file_part("%_N_ROLL_MPF\r\nG0 X1\r\nM30\r\n"), "G0 X1\r\nM30\r\n");
  EXPECT_EQ(file_part("%\nG0 X1\nM30\n%"), "G0 X1\nM30\n");
  EXPECT_EQ(file_part("G0 X1 ;$PATH=/x\n;$PATH=/y\nM30\n"), "G0 X1 ;$PATH=/x\n;$PATH=/y\nM30\n")
      << "it is bare already";
  EXPECT_EQ(file_part("%_N_ROLL_MPF\nMSG(\"5%\nM30\n"), "MSG(\"5%\nM30\n");
  EXPECT_EQ(file_part("%_N_ROLL_MPF"), "");
  EXPECT_EQ(file_part(""), "");
  EXPECT_TRUE(machine::drops_bare_files(profile_of("sinumerik-840d", "dir:/x")));
  EXPECT_FALSE(machine::drops_bare_files(profile_of("fanuc", "dir:/x")));
  EXPECT_FALSE(machine::drops_bare_files(profile_of("sinumerik-840d", "serial:/dev/ttyS0")));
}

}  // namespace
}  // namespace dripfeed::app

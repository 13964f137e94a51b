// Lines of stored texts against all of the text read at once; places are found wherever they lie.
#include "server/app/library/program_lines.h"

#include <random>

#include <fmt/format.h>

#include "dialects/text/source.h"
#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app::test {
namespace {

class ProgramLinesTest : public ShopTest {
 protected:
  store::ProgramRevision stored(const std::string& text, const std::string& places = {}) {
    store::ProgramRevision revision;
    revision.sha256 = must(shop_.store.contents().put(text)).sha256;
    if (!places.empty()) revision.places_sha256 = must(shop_.store.contents().put(places)).sha256;
    return revision;
  }
  // All windows of a few lines, against the text as one.
  void expect_same(const std::string& text) {
    const store::ProgramRevision revision = stored(text);
    const text::Source source("", text);
    const std::uint64_t count = text.empty() ? 0 : source.line_count();
    for (std::uint64_t from = 1; from <= count + 2; from += std::max<std::uint64_t>(1, count / 50)) {
      const ProgramLines found = must(reading_.lines(revision, from, 3));
      ASSERT_EQ(found.count_all, count);
      ASSERT_EQ(found.lines.size(), from > count ? 0 : std::min<std::uint64_t>(3, count - from + 1)) << from;
      for (std::size_t i = 0; i < found.lines.size(); ++i) {
        EXPECT_EQ(found.lines[i].line, from + i);
        EXPECT_EQ(found.lines[i].text, source.line(static_cast<std::uint32_t>(from + i))) << from + i;
        EXPECT_FALSE(found.lines[i].values || found.lines[i].family_line || found.lines[i].family_text);
      }
    }
  }

  Shop shop_{database()};
  LineReading reading_{shop_.store};
};

TEST_F(ProgramLinesTest, AreThoseOfTheWholeText) {
  for (const char* text :
       {"", "M30", "%\nM30\n%\n", "a\r\nb\r\n", "a\rb\r", "a\n\r\rb\n\r\r", "\n\n\n", "a\n\rb", "x\n\r"})
    expect_same(text);
  std::mt19937 random(7);
  for (const std::string_view eob : {"\n", "\r\n", "\r", "\n\r\r"}) {
    std::string text;
    while (text.size() < 300'000) text += fmt::format("N{}X{}{}", text.size(), std::string(random() % 30, '1'), eob);
    expect_same(text);  // EOBs lie across the borders of chunks
  }
}

TEST_F(ProgramLinesTest, ALongOneIsCut) {
  const ProgramLines found = must(reading_.lines(stored(std::string(200'000, 'X') + "\nM30\n"), 1, 9));
  ASSERT_EQ(found.lines.size(), 2U);
  EXPECT_EQ(found.lines[0].text, std::string(4096, 'X') + " …");
  EXPECT_EQ(found.lines[1].text, "M30");
}

TEST_F(ProgramLinesTest, StandNextToTheFamilyTheyWereRenderedFrom) {
  must(shop_.store.families().add("roll", "family roll\n  cut x\n  cut z\nend\n", by("anna")));
  must(shop_.store.families().change("roll", 1, "another\n", by("anna")));
  std::string text = "%\n";
  std::string places;
  for (int i = 0; i < 20'000; ++i) {
    places +=
        fmt::format("{}\t{}\t{}\tt={}{}\n", text.size(), i + 2, i % 2 + 2, i * 0.25, i % 3 == 0 ? "\tside=-1" : "");
    text += fmt::format("G01X{}.\n", i);
  }
  text += "%\n";
  store::ProgramRevision revision = stored(text, places);
  revision.origin.family = "roll";
  revision.origin.family_revision = 1;
  for (const int i : {0, 1, 2, 3, 500, 9'999, 10'000, 19'000, 19'995}) {
    const ProgramLines found = must(reading_.lines(revision, static_cast<std::uint64_t>(i) + 2, 4));
    ASSERT_EQ(found.lines.size(), 4U);
    for (int k = 0; k < 4; ++k) {
      const int n = i + k;
      const ProgramLine& line = found.lines[static_cast<std::size_t>(k)];
      EXPECT_EQ(line.text, fmt::format("G01X{}.", n));
      EXPECT_EQ(line.family_line, static_cast<std::uint64_t>(n % 2 + 2));
      EXPECT_EQ(line.family_text, n % 2 == 0 ? "  cut x" : "  cut z") << "of the revision that was rendered";
      std::map<std::string, double> values = {{"t", n * 0.25}};
      if (n % 3 == 0) values["side"] = -1;
      EXPECT_EQ(line.values, values) << n;
    }
  }
  const ProgramLines ends = must(reading_.lines(revision, 20'001, 5));
  ASSERT_EQ(ends.lines.size(), 2U);
  EXPECT_EQ(ends.lines[1].text, "%");
  EXPECT_FALSE(ends.lines[1].values || ends.lines[1].family_line) << "of the frame nothing is stored";
  const ProgramLines first = must(reading_.lines(revision, 1, 2));
  EXPECT_FALSE(first.lines[0].values);
  EXPECT_TRUE(first.lines[1].values);
}

TEST_F(ProgramLinesTest, AnUnknownTextIsAnError) {
  store::ProgramRevision revision;
  revision.sha256 = std::string(64, '0');
  EXPECT_EQ(refusal(reading_.lines(revision, 1, 1)).code, ErrorCode::not_found);
}

}  // namespace
}  // namespace dripfeed::app::test

// A stored text as a feed takes it: whole, with one LF an EOB, whatever its length; a piece stays as it is until the
// next one is asked for; one thread fills while another takes.
#include "server/app/lines/content_source.h"

#include <atomic>
#include <thread>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

using namespace test;
using tape_code::SourceStatus;

std::string numbered(std::size_t bytes, std::string_view eob) {
  std::string text;
  for (int i = 0; text.size() < bytes; ++i) text += "N" + std::to_string(i) + std::string(eob);
  text.resize(bytes);
  return text;
}

std::string with_lf(const std::string& text) {
  tape_code::EobReader reader;
  std::string out;
  for (const char c : text) reader.put(c, out);
  reader.finish(out);
  return out;
}

class ContentSourceTest : public ShopTest {
 protected:
  ContentSourceTest() : store_(must(sqlite::open(database()))) {}
  std::string put(const std::string& text) { return must(store_->contents().put(text)).sha256; }

  std::unique_ptr<store::Store> store_;
};

TEST_F(ContentSourceTest, GivesTheWholeTextAtEveryLength) {
  constexpr std::size_t kChunk = store::kChunkBytes;
  for (const std::string_view eob : {"\n", "\r\n", "\n\r\r", "\r"}) {
    for (const std::size_t bytes : {std::size_t{1}, kChunk - 1, kChunk, kChunk + 1, 5 * kChunk, 6 * kChunk + 17}) {
      const std::string text = numbered(bytes, eob);
      ContentSource source(store::read_in_place(store_->contents(), put(text)));
      std::string taken;
      for (;;) {
        const auto piece = source.next();
        if (piece.status == SourceStatus::end) break;
        ASSERT_NE(piece.status, SourceStatus::failed);
        if (piece.status == SourceStatus::not_ready) {
          source.refill();
          continue;
        }
        ASSERT_FALSE(piece.text.empty());
        const std::string before(piece.text.begin(), piece.text.end());
        source.refill();
        ASSERT_EQ(std::string(piece.text.begin(), piece.text.end()), before) << "a piece that the feed still reads";
        taken += before;
      }
      EXPECT_EQ(taken, with_lf(text)) << bytes;
      EXPECT_EQ(source.next().status, SourceStatus::end) << "and stays at its end";
    }
  }
}

TEST_F(ContentSourceTest, ReadsNoFurtherAheadThanItsChunks) {
  ContentSource source(store::read_in_place(store_->contents(), put(numbered(10 * store::kChunkBytes, "\n"))));
  for (std::size_t i = 0; i < ContentSource::kChunks; ++i) ASSERT_EQ(source.next().status, SourceStatus::text);
  EXPECT_EQ(source.next().status, SourceStatus::not_ready) << "nobody filled it meanwhile";
  EXPECT_EQ(source.next().status, SourceStatus::not_ready);
  source.refill();
  EXPECT_EQ(source.next().status, SourceStatus::text);
}

TEST_F(ContentSourceTest, ATextThatIsNotThereHasFailed) {
  ContentSource source(store::read_in_place(store_->contents(), std::string(64, 'a')));
  EXPECT_EQ(source.next().status, SourceStatus::failed);
  source.refill();
  EXPECT_EQ(source.next().status, SourceStatus::failed);
}

TEST_F(ContentSourceTest, OneThreadFillsWhileAnotherTakes) {
  const std::string text = numbered(40 * store::kChunkBytes, "\n");
  ContentSource source(store::read_in_place(store_->contents(), put(text)));
  std::atomic<bool> over = false;
  std::thread filling([&] {
    while (!over.load()) source.refill();
  });
  std::string taken;
  for (;;) {
    const auto piece = source.next();
    if (piece.status == SourceStatus::end || piece.status == SourceStatus::failed) break;
    taken.append(piece.text.begin(), piece.text.end());
  }
  over.store(true);
  filling.join();
  EXPECT_TRUE(taken == text);
}

machine::Profile fed_machine() {
  machine::Profile profile;
  profile.control.dialect = "fanuc";
  return profile;
}

TEST_F(ContentSourceTest, RefusesACharacterThatTheLineCannotCarry) {
  machine::Profile profile = fed_machine();
  const auto refused = [&](const std::string& text) {
    return refusal(check_program(store_->contents(), put(text), profile, ir::Delivery::drip));
  };
  const std::string text = "%\r\nO1\r\nG1 X#1\r\nM30\r\n%\r\n";
  EXPECT_TRUE(check_program(store_->contents(), put(text), profile, ir::Delivery::drip));
  profile.line.code = tape_code::Code::eia;
  profile.line.framing = {.data_bits = 8, .parity = tape_code::Parity::none, .stop_bits = 2};
  const Error error = refused(text);
  EXPECT_EQ(error.code, ErrorCode::refused);
  EXPECT_EQ(error.text, "line 3, column 5: EIA has no code for the character '#' (1 such)");
  ASSERT_EQ(error.places.size(), 1U);
  EXPECT_EQ(error.places.front().line, 3U);
  EXPECT_EQ(error.places.front().column, 5U);
  profile.line.eia_specials.codes[2] = 0x5E;
  EXPECT_TRUE(check_program(store_->contents(), put(text), profile, ir::Delivery::drip));
  profile.line.character_set = "fanuc-iso";
  EXPECT_EQ(refused("%\n(a)\nM30\n%").text, "line 2, column 2: the control does not take the character 'a' (1 such)");
}

TEST_F(ContentSourceTest, ChecksAStoredTextWholeAndNamesThePlaceOfAFault) {
  const std::string body = numbered(3 * store::kChunkBytes, "\r\n");
  const std::string lines = body.substr(0, body.rfind("\r\n") + 2);
  const std::string good = "%\r\n" + lines + "M30\r\n%\r\n";
  const auto facts = must(check_program(store_->contents(), put(good), fed_machine(), ir::Delivery::drip));
  EXPECT_EQ(facts.text_bytes(), with_lf(good).size());
  const std::string bad = "%\r\n" + lines + "(50%)\r\nM30\r\n%\r\n";
  const Error error = refusal(check_program(store_->contents(), put(bad), fed_machine(), ir::Delivery::drip));
  EXPECT_EQ(error.code, ErrorCode::refused);
  ASSERT_EQ(error.places.size(), 1U);
  const std::string head = with_lf("%\r\n" + lines);
  EXPECT_EQ(error.places.front().line, 1 + std::count(head.begin(), head.end(), '\n'));
  EXPECT_EQ(error.places.front().column, 4U);
  EXPECT_EQ(refusal(check_program(store_->contents(), std::string(64, 'a'), fed_machine(), ir::Delivery::drip)).code,
            ErrorCode::unavailable);
}

// All of its text, as the feed takes it.
std::string all_of(ContentSource& source) {
  std::string taken;
  for (;;) {
    const auto piece = source.next();
    if (piece.status == SourceStatus::end || piece.status == SourceStatus::failed) return taken;
    taken.append(piece.text.begin(), piece.text.end());
    source.refill();
  }
}

TEST_F(ContentSourceTest, AFolderOfSinumerikGetsTheFileAndNotTheArchive) {
  machine::Profile profile;
  profile.control.dialect = "sinumerik-840d";
  profile.line.link = machine::parse_link_url("dir:/srv/dnc").value();
  const std::string body = numbered(3 * store::kChunkBytes, "\n") + "\nM30\n";
  const std::string sha = put("%_N_ROLL_MPF\r\n;$PATH=/_N_MPF_DIR\r\n" + body + "%\r\n");
  const TextPart part = must(part_for(store_->contents(), sha, profile));
  ContentSource source(store::read_in_place(store_->contents(), sha), 2, part);
  EXPECT_EQ(all_of(source), body + body);
  const auto facts = must(check_program(store_->contents(), sha, profile, ir::Delivery::memory));
  EXPECT_EQ(facts.text_bytes(), body.size());

  const auto several = put("%_N_A_MPF\n;$PATH=/_N_MPF_DIR\nM30\n%_N_B_SPF\nM17\n%\n");
  const Error refused = refusal(check_program(store_->contents(), several, profile, ir::Delivery::memory));
  EXPECT_NE(refused.text.find("line 4, column"), std::string::npos) << refused.text;

  // A line gets the archive, and a Fanuc its % wherever it is fetched from.
  profile.line.link = machine::parse_link_url("serial:/dev/ttyS0").value();
  EXPECT_EQ(must(part_for(store_->contents(), sha, profile)).begin, 0U);
  profile.control.dialect = "fanuc";
  profile.line.link = machine::parse_link_url("dir:/srv/dnc").value();
  EXPECT_EQ(must(part_for(store_->contents(), sha, profile)).begin, 0U);
}

}  // namespace
}  // namespace dripfeed::app

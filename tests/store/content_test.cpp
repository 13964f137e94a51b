// Contents: chunks at their edges, equal ones once, what is left over, and a large one in little memory.
#include <algorithm>
#include <random>

#include <fmt/format.h>
#include <sys/resource.h>

#include "store/hash/sha256.h"
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class ContentTest : public StoreTest {
 protected:
  ContentTest() : StoreTest(TempFolder::Where::disk) {}
  // "" when the table has that many rows.
  [[nodiscard]] std::string has_rows(const std::string& table, int rows) const {
    return sql(fmt::format("CREATE TEMP TABLE t (x INTEGER CHECK (x = {})); INSERT INTO t SELECT count(*) FROM {}",
                           rows, table));
  }
};

std::string bytes_of(std::size_t size, unsigned seed = 1) {
  std::string text(size, '\0');
  std::minstd_rand random(seed);
  std::ranges::generate(text, [&] { return static_cast<char>(random() & 0xFFU); });
  return text;
}

// Reads in pieces of one size.
std::string read_in_pieces(Contents& contents, const std::string& sha256, std::size_t piece) {
  std::string all;
  std::string buffer(piece, '\0');
  while (true) {
    const std::size_t got = must(contents.read(sha256, all.size(), buffer));
    if (got == 0) return all;
    all.append(buffer, 0, got);
  }
}

TEST_F(ContentTest, SizesAroundTheEdgesOfChunksAndTransactions) {
  const std::size_t mebi = std::size_t{1} << 20U;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kChunkBytes - 1, kChunkBytes, kChunkBytes + 1,
                                 mebi - 1, mebi, mebi + 1, 2 * mebi, 2 * mebi + kChunkBytes + 17}) {
    const std::string text = bytes_of(size);
    const Content content = must(store_->contents().put(text));
    EXPECT_EQ(content.bytes, size);
    EXPECT_EQ(content.sha256, hash::sha256_hex(text));
    EXPECT_EQ(must(store_->contents().find(content.sha256)).bytes, size);
    EXPECT_TRUE(must(read_whole(store_->contents(), content.sha256, size)) == text) << size;
    EXPECT_TRUE(read_in_pieces(store_->contents(), content.sha256, 100'003) == text) << size;
    must(store_->contents().verify(content.sha256));
  }
}

TEST_F(ContentTest, ReadsFromAnyPlace) {
  const std::string text = bytes_of(3 * kChunkBytes + 5);
  const std::string sha256 = must(store_->contents().put(text)).sha256;
  std::minstd_rand random(7);
  for (int i = 0; i < 200; ++i) {
    const std::size_t from = random() % (text.size() + 10);
    std::string buffer(random() % (2 * kChunkBytes), '\0');
    const std::size_t got = must(store_->contents().read(sha256, from, buffer));
    const std::size_t expected = from >= text.size() ? 0 : std::min(buffer.size(), text.size() - from);
    ASSERT_EQ(got, expected) << from;
    EXPECT_TRUE(std::string_view(text).substr(std::min(from, text.size()), got) == buffer.substr(0, got)) << from;
  }
}

TEST_F(ContentTest, PiecesMakeNoDifference) {
  const std::string text = bytes_of(2'500'000);
  for (const std::size_t piece : {std::size_t{1'000}, std::size_t{65'537}, std::size_t{3'000'000}}) {
    auto writer = must(store_->contents().begin());
    for (std::size_t at = 0; at < text.size(); at += piece)
      must(writer->append(std::string_view(text).substr(at, piece)));
    EXPECT_EQ(must(writer->finish()).sha256, hash::sha256_hex(text));
  }
  EXPECT_EQ(has_rows("content", 1), "") << "kept once";
  EXPECT_EQ(must(store_->contents().total_bytes()), text.size());
  EXPECT_TRUE(must(read_whole(store_->contents(), hash::sha256_hex(text), text.size())) == text);
}

TEST_F(ContentTest, UnknownTooLongAndUnfinished) {
  const std::string unknown(64, '0');
  std::string buffer(10, '\0');
  EXPECT_EQ(refusal(store_->contents().find(unknown)), ErrorCode::not_found);
  EXPECT_EQ(refusal(store_->contents().read(unknown, 0, buffer)), ErrorCode::not_found);
  EXPECT_EQ(refusal(store_->contents().verify(unknown)), ErrorCode::not_found);
  const std::string sha256 = must(store_->contents().put("0123456789")).sha256;
  EXPECT_EQ(refusal(read_whole(store_->contents(), sha256, 9)), ErrorCode::invalid_value);

  const std::string text = bytes_of(3'000'000);
  auto writer = must(store_->contents().begin());
  must(writer->append(text));
  EXPECT_EQ(refusal(store_->contents().find(hash::sha256_hex(text))), ErrorCode::not_found) << "nobody sees it yet";
  writer.reset();
  EXPECT_EQ(has_rows("content", 1), "");
  EXPECT_EQ(has_rows("content_chunk", 1), "");
}

TEST_F(ContentTest, AnOwnerDropsWhatACrashLeftAndWhatNoOneUses) {
  const Program program = add_program(*store_, "used");
  must(store_->contents().put("not used"));
  EXPECT_EQ(sql(fmt::format("INSERT INTO content (id, sha256, bytes) VALUES (77, NULL, 0);"
                            "INSERT INTO content_chunk VALUES (77, 0, {0}), (77, 1, {0})",
                            zero_byte())),
            "");
  reopen();
  EXPECT_EQ(has_rows("content", 3), "") << "a guest drops nothing: it may be the server's upload";
  reopen({.own = true});
  EXPECT_EQ(has_rows("content", 1), "");
  EXPECT_EQ(has_rows("content_chunk", 1), "");
  EXPECT_EQ(must(read_whole(store_->contents(), program.newest.sha256, 10)), "used");
}

TEST_F(ContentTest, DamagedBytesAreFound) {
  const std::string sha256 = must(store_->contents().put(bytes_of(131'072))).sha256;
  drop_trigger("content_chunk_update", "content_chunk");
  EXPECT_EQ(sql("UPDATE content_chunk SET data = (SELECT data FROM content_chunk WHERE n = 1) WHERE n = 0"), "");
  EXPECT_EQ(refusal(store_->contents().verify(sha256)), ErrorCode::corrupt);
  EXPECT_EQ(sql(fmt::format("UPDATE content_chunk SET data = {} WHERE n = 0", zero_byte())), "");
  std::string buffer(131'072, '\0');
  EXPECT_EQ(refusal(store_->contents().read(sha256, 0, buffer)), ErrorCode::corrupt);
}

// A sanitizer keeps what was freed, so the peak says nothing there.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

long peak_rss_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

// 100 MB through in and out; the peak may not grow by more than a part of it.
TEST_F(ContentTest, ALargeOneStreams) {
  const std::string line = "N10 G1 X12.3456 Y-7.8901 Z0.0500 F1200\n";
  std::string piece;
  while (piece.size() < 60'000) piece += line;
  must(store_->contents().put(piece + piece));  // whatever is allocated once
  const long before = peak_rss_kib();
  hash::Sha256 in;
  std::uint64_t total = 0;
  auto writer = must(store_->contents().begin());
  for (; total < 100'000'000; total += piece.size()) {
    in.add(piece);
    must(writer->append(piece));
  }
  const Content content = must(writer->finish());
  EXPECT_EQ(content.bytes, total);
  EXPECT_EQ(content.sha256, in.hex());
  hash::Sha256 out;
  std::string buffer(kChunkBytes, '\0');
  for (std::uint64_t at = 0; at < total;) {
    const std::size_t got = must(store_->contents().read(content.sha256, at, buffer));
    ASSERT_GT(got, 0U);
    out.add(std::string_view(buffer).substr(0, got));
    at += got;
  }
  EXPECT_EQ(out.hex(), content.sha256);
  EXPECT_TRUE(kSanitized || peak_rss_kib() - before < 16 * 1024) << peak_rss_kib() - before << " KiB";
}

}  // namespace
}  // namespace dripfeed::store_test

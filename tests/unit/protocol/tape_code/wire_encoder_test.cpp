// Text to wire in any pieces, against a plain reckoning of every offset.
#include "protocol/tape_code/wire_encoder.h"

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/tape_code/parity.h"

namespace dripfeed::tape_code {
namespace {

// Gives the text in pieces of any size, with "not ready" in between where wanted.
class PieceSource final : public TextSource {
 public:
  PieceSource(std::string text, unsigned seed, bool waits) : text_(std::move(text)), random_(seed), waits_(waits) {}
  TextPiece next() noexcept override {
    if (given_ == text_.size()) return {.status = SourceStatus::end};
    if (waits_ && random_() % 3 == 0) return {.status = SourceStatus::not_ready};
    const std::size_t count = std::min<std::size_t>(1 + random_() % 7, text_.size() - given_);
    given_ += count;
    return {.status = SourceStatus::text, .text = std::span(text_).subspan(given_ - count, count)};
  }

 private:
  std::string text_;
  std::size_t given_ = 0;
  std::mt19937 random_;
  bool waits_;
};

class FailingSource final : public TextSource {
 public:
  TextPiece next() noexcept override { return {.status = SourceStatus::failed}; }
};

// What the wire must be, offset by offset, made plainly.
struct Plain {
  std::string wire;
  std::vector<WirePosition> at;  // one for each offset 0 ..= wire.size()
};

Plain plain(const WireFormat& format, const std::string& text) {
  Plain all;
  const auto mark = [&](std::uint64_t done, std::uint64_t line, WirePart part, bool boundary) {
    all.at.push_back({all.wire.size(), done, line, part, boundary});
  };
  const auto coded = [&](char c) {
    if (!format.eia) return static_cast<char>(with_parity(static_cast<std::uint8_t>(c), format.eighth_bit));
    return c == '\0' || c == '\x7F' ? c : static_cast<char>(eia_code(c, *format.eia));
  };
  const char filler = coded(format.filler == Filler::nul ? '\0' : '\x7F');
  for (std::uint32_t i = 0; i < format.leader_chars; ++i) {
    mark(0, 1, WirePart::leader, true);
    all.wire += filler;
  }
  std::uint64_t line = 1;
  bool boundary = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string eob = format.eia ? std::string("\n") : std::string(characters(format.eob));
    const std::size_t begin = i == 0 ? 0 : text.rfind('\n', i - 1) + 1;  // npos + 1 is 0
    const bool odd = text[i] == '\n' && format.pad_tv && (i - begin + 1) % 2 == 1;
    const std::string out = text[i] == '\n' ? (odd ? " " : "") + eob : std::string(1, text[i]);
    for (const char c : out) {
      mark(i, line, WirePart::text, boundary);
      all.wire += coded(c);
      boundary = false;
    }
    boundary = text[i] == '\n';
    line += boundary ? 1 : 0;
  }
  for (std::uint32_t i = 0; i <= format.trailer_chars; ++i) {
    mark(text.size(), line, i == 0 ? WirePart::text : WirePart::trailer, true);
    if (i < format.trailer_chars) all.wire += filler;
  }
  return all;
}

const std::vector<std::string> kTexts{"",       "\n",        "A",        "%\nO1\nM30\n%\n", "%\n\n\nG1\n\nM30\n%",
                                      "\n\n\n", "G1X1\nM30", "%\nM30\n%"};

std::vector<WireFormat> formats() {
  std::vector<WireFormat> all;
  for (const Eob eob : {Eob::lf, Eob::cr_lf, Eob::lf_cr_cr, Eob::cr, *parse_eob("CR LF LF"), *parse_eob("1E")}) {
    for (const EighthBit eighth : {EighthBit::data, EighthBit::clear, EighthBit::even, EighthBit::odd}) {
      all.push_back({.eighth_bit = eighth, .eob = eob, .leader_chars = 0, .trailer_chars = 0});
      all.push_back({.eighth_bit = eighth, .eob = eob, .leader_chars = 3, .trailer_chars = 2});
      all.push_back({.eighth_bit = eighth, .eob = eob, .trailer_chars = 1, .filler = Filler::del, .pad_tv = true});
    }
  }
  for (const bool pad : {false, true}) {
    all.push_back({.eighth_bit = EighthBit::data, .eia = EiaSpecials{}, .pad_tv = pad});
    all.push_back({.eighth_bit = EighthBit::data,
                   .leader_chars = 2,
                   .trailer_chars = 3,
                   .eia = EiaSpecials{},
                   .filler = pad ? Filler::del : Filler::nul,
                   .pad_tv = pad});
  }
  return all;
}

std::uint64_t odd_blocks(std::string_view text) {
  std::uint64_t odd = 0;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    odd += (end + 1) % 2;
    text.remove_prefix(end + 1);
  }
  return odd;
}

TEST(WireEncoder, MakesTheWireInAnyPieces) {
  for (const WireFormat& format : formats()) {
    for (const std::string& text : kTexts) {
      const Plain expected = plain(format, text);
      EXPECT_EQ(wire_length(format, text.size(), static_cast<std::uint64_t>(std::ranges::count(text, '\n')),
                            odd_blocks(text)),
                expected.wire.size());
      for (unsigned seed = 0; seed < 5; ++seed) {
        std::mt19937 random(seed);
        PieceSource source(text, seed, seed % 2 == 1);
        WireEncoder encoder(format, source, text.size());
        std::string wire;
        for (int guard = 0; guard < 1000; ++guard) {
          std::array<std::byte, 9> out{};
          std::array<std::uint8_t, 9> ends{};
          const auto filled = encoder.fill(std::span(out).first(1 + random() % 9), ends);
          for (std::size_t i = 0; i < filled.count; ++i) {
            wire += static_cast<char>(out[i]);
            EXPECT_EQ(ends[i] != 0, expected.at[wire.size()].block_boundary) << "offset " << wire.size();
          }
          ASSERT_EQ(encoder.produced(), wire.size());
          for (std::size_t at = 0; at <= wire.size(); ++at) EXPECT_EQ(encoder.locate(at), expected.at[at]) << at;
          EXPECT_EQ(encoder.locate(wire.size() + 1), std::nullopt);
          if (filled.status == FillStatus::end) break;
        }
        EXPECT_EQ(wire, expected.wire);
      }
      for (std::size_t at = 0; at <= expected.wire.size(); ++at) {
        SpanSource source(text);
        EXPECT_EQ(locate(format, source, text.size(), at), expected.at[at]);
      }
      SpanSource source(text);
      EXPECT_EQ(locate(format, source, text.size(), expected.wire.size() + 1).error(), FillStatus::end);
    }
  }
}

TEST(WireEncoder, RemembersTheLastBlocksOnly) {
  const std::string text(5000, '\n');
  SpanSource source(text);
  WireEncoder encoder({.eob = Eob::cr_lf}, source, text.size());
  std::array<std::byte, 256> out{};
  std::array<std::uint8_t, 256> ends{};
  while (encoder.fill(out, ends).status == FillStatus::more) {
  }
  EXPECT_EQ(encoder.produced(), 10000U);
  EXPECT_EQ(encoder.locate(100), std::nullopt);
  const std::uint64_t oldest = 10000 - 2 * (WireEncoder::kRememberedBlocks - 1);
  ASSERT_TRUE(encoder.locate(oldest));
  EXPECT_EQ(encoder.locate(oldest)->line, oldest / 2 + 1);
  EXPECT_EQ(encoder.locate(oldest - 1), std::nullopt);
  EXPECT_FALSE(encoder.locate(9999)->block_boundary);
  SpanSource again(text);
  EXPECT_EQ(locate({.eob = Eob::cr_lf}, again, text.size(), 101)->line, 51U);
}

TEST(WireEncoder, NamesWhatIsWrongWithTheText) {
  std::array<std::byte, 16> out{};
  std::array<std::uint8_t, 16> ends{};
  FailingSource failing;
  EXPECT_EQ(WireEncoder({}, failing, 5).fill(out, ends).status, FillStatus::source_failed);
  SpanSource brief(std::string_view("ABC"));
  WireEncoder encoder({}, brief, 5);
  const auto filled = encoder.fill(out, ends);
  EXPECT_EQ(filled.status, FillStatus::text_short);
  EXPECT_EQ(filled.count, 3U);
  SpanSource umlaut(std::string_view("A\xC4"));
  WireEncoder seven({}, umlaut, 2);
  EXPECT_EQ(seven.fill(out, ends).status, FillStatus::no_code);
  EXPECT_EQ(seven.produced(), 1U);
  SpanSource again(std::string_view("A\xC4"));
  EXPECT_EQ(WireEncoder({.eighth_bit = EighthBit::data}, again, 2).fill(out, ends).status, FillStatus::end);
  SpanSource bracket(std::string_view("#1=2"));
  WireEncoder eia({.eia = EiaSpecials{}}, bracket, 4);
  EXPECT_EQ(eia.fill(out, ends).status, FillStatus::no_code);
  EXPECT_EQ(eia.produced(), 0U);
}

TEST(WireEncoder, NeverSendsMoreThanThePromisedText) {
  SpanSource source(std::string_view("%\nM30\n%\nG0Z-100\n"));
  WireEncoder encoder({.eighth_bit = EighthBit::data}, source, 8);
  std::array<std::byte, 64> out{};
  std::array<std::uint8_t, 64> ends{};
  const auto filled = encoder.fill(out, ends);
  EXPECT_EQ(filled.count, 8U);
  EXPECT_EQ(filled.status, FillStatus::end);
}

}  // namespace
}  // namespace dripfeed::tape_code

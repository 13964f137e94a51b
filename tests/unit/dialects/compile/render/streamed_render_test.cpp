// A rendering that is written while the program runs has the bytes of the one that is held whole.
#include "dialects/compile/render/streamed_render.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

class Kept final : public TextSink {
 public:
  void write(std::string_view text) override { text_ += text; }
  [[nodiscard]] std::string joined(const StreamedRendering& made) const {
    std::string out;
    std::size_t at = 0;
    for (const Splice& splice : made.splices) {
      out += made.result.text.substr(at, splice.at - at);
      out += text_.substr(splice.begin, splice.end - splice.begin);
      at = splice.at;
    }
    return out + made.result.text.substr(at);
  }
  [[nodiscard]] std::size_t size() const { return text_.size(); }

 private:
  std::string text_;
};

RenderRequest request_of(const text::Source& family, const ir::Control& target, ir::Delivery delivery) {
  RenderRequest request;
  request.family = family;
  request.target = target;
  request.mode = RenderMode::explicit_blocks;
  request.delivery = delivery;
  request.program_name = target.dialect.starts_with("sinumerik") ? "FAMILY_TEST" : "O0100";
  return request;
}

// How many bytes went to the sink.
std::size_t expect_same_bytes(const RenderRequest& request, const std::string& what) {
  const RenderResult whole = render(request);
  Kept sink;
  const StreamedRendering made = render_streamed(request, sink);
  EXPECT_EQ(messages_of(whole.diagnostics, request.family), messages_of(made.result.diagnostics, request.family));
  EXPECT_EQ(whole.text, sink.joined(made)) << what;
  EXPECT_EQ(whole.blocks, made.result.blocks) << what;
  EXPECT_EQ(whole.bytes, made.result.bytes) << what;
  EXPECT_EQ(whole.because, made.result.because) << what;
  return made.splices.empty() ? 0 : sink.size();
}

// As a machine that states its increment, too.
std::size_t expect_same_bytes_everywhere(const text::Source& family, const std::string& name) {
  std::size_t fewest = ~std::size_t{0};
  for (const std::string& dialect : dialect_names()) {
    for (const ir::Delivery delivery : {ir::Delivery::memory, ir::Delivery::drip}) {
      ir::Control target = control(dialect, kind_of(family));
      fewest = std::min(fewest,
                        expect_same_bytes(request_of(family, target, delivery), fmt::format("{} {}", name, dialect)));
      target.from_profile = true;
      target.semantics.least_increment_mm = 0.01;
      fewest = std::min(
          fewest, expect_same_bytes(request_of(family, target, delivery), fmt::format("{} {}, 0.01", name, dialect)));
    }
  }
  return fewest;
}

TEST(StreamedRender, ShippedFamiliesHaveTheSameBytes) {
  for (const char* name : {"bezier-surface", "engrave-text", "face-mill", "hyperbolic-roll", "island-pocket",
                           "nurbs-profile", "nurbs-surface", "rectangular-pocket", "round-pocket", "seal-ring", "slot",
                           "stepped-shaft", "thread-mill", "worm", "worm-turned"})
    expect_same_bytes_everywhere(shipped(name), name);
}

// Longer than the distance of samples, with axes that change from block to block.
constexpr std::string_view kLong =
    "  for n from 1 to 20000 step 1\n"
    "    cut x 40 mm*sin(n*0.01 deg)  y 3000 mm*cos(n*0.013 deg)\n"
    "    if sin(n*50 deg) > 0.8\n"
    "      cut z -1 mm - 0.0001 mm*n\n"
    "    end\n"
    "  end\n";

TEST(StreamedRender, MostOfALongProgramGoesToTheSink) {
  const text::Source family = with("", "  rapid x 0 mm  y 0 mm\n  rapid z 2 mm\n" + std::string(kLong));
  EXPECT_GT(expect_same_bytes_everywhere(family, "long"), std::size_t{300'000});
}

// Of what is not a position alone, and of positions after it.
TEST(StreamedRender, OtherBlocksEndARun) {
  const text::Source family = with("",
                                   "  tool 1\n  spindle 900 rpm cw\n"
                                   "  for n from 1 to 12 step 1\n"
                                   "    rapid x 1 mm*n  y 2 mm\n    rapid x 1 mm*n  y 4 mm\n    rapid z 2 mm\n"
                                   "    cut z -1 mm\n    cut z -2 mm\n    cut x 3 mm*n\n    cut x 4 mm*n  y 1 mm\n"
                                   "    coolant flood\n    cut x 5 mm*n\n    cut x 6 mm*n\n    feed 10 mm/min * n\n"
                                   "    cut x 7 mm*n\n    cut x 8 mm*n\n    dwell 1 s\n    cut y 7 mm*n\n"
                                   "    cut y 8 mm*n\n    rapid z 5 mm\n"
                                   "  end\n");
  EXPECT_GT(expect_same_bytes_everywhere(family, "mixed"), std::size_t{200});
}

TEST(StreamedRender, RadiiOfALatheAreDiameters) {
  const text::Source family{
      "test.family",
      "family test\nmachine lathe, x is radius\nprogram test\n  feed 0.1 mm/rev\n"
      "  rapid x 50 mm  z 5 mm\n  for n from 1 to 30 step 1\n    cut x 40 mm - 1 mm*n  z -1 mm*n\n"
      "  end\nend\n"};
  EXPECT_GT(expect_same_bytes_everywhere(family, "radius"), std::size_t{200});
}

TEST(StreamedRender, TapsAndFaultsAreThoseOfTheWhole) {
  expect_same_bytes_everywhere(shipped("bolt-circle"), "bolt-circle");
  const text::Source wrong = with("param n count 3 in 1..9\n", "  require n > 5, \"too few\"\n  rapid x 0 mm\n");
  expect_same_bytes_everywhere(wrong, "a requirement");
}

// It is found in the run that writes.
TEST(StreamedRender, AListThatIsReadBeforeItIsSetIsRefused) {
  const text::Source family = with("param n count 3 in 1..3\nlist ws of length 4\n",
                                   "  rapid z 2 mm\n  set ws[0] = 1 mm\n  set ws[1] = 2 mm\n  for nth from 0 to n - 1 "
                                   "step 1\n    if nth < 2 or n > 2\n"
                                   "      cut x ws[nth]\n    end\n  end\n");
  expect_same_bytes_everywhere(family, "an unset number");
  RenderRequest request = request_of(family, control("fanuc", ir::MachineKind::mill), ir::Delivery::memory);
  Kept sink;
  const StreamedRendering refused = render_streamed(request, sink);
  EXPECT_TRUE(messages_of(refused.result.diagnostics, family).contains("that the program has not set"));
  EXPECT_TRUE(refused.result.text.empty());
  request.values = {{"n", "2"}};
  EXPECT_TRUE(render_streamed(request, sink).result.diagnostics.empty());
}

}  // namespace
}  // namespace dripfeed::compile::test

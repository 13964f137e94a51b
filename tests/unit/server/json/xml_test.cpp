// What is written is well-formed whatever bytes it is of.
#include "server/json/xml.h"

#include <gtest/gtest.h>

namespace dripfeed::json {
namespace {

std::string written(std::string_view text) {
  Xml xml;
  xml.open("a");
  xml.leaf("b", {{"c", std::string(text)}}, text);
  return xml.take();
}

std::string expected(const std::string& text) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a>\n  <b c=\"" + text + "\">" + text + "</b>\n</a>\n";
}

TEST(Xml, EscapesWhatHasAMeaning) {
  EXPECT_EQ(written("mill \"3\" <ä> & co\n"), expected("mill &quot;3&quot; &lt;ä&gt; &amp; co&#10;"));
}

TEST(Xml, ReplacesWhatNoDocumentMayHave) {
  const std::string none = "\xEF\xBF\xBD";
  for (const std::string_view bad :
       {"\x01", "\x1F", "\xFF", "\xC0\x80", "\xED\xA0\x80", "\xEF\xBF\xBF", "\xF4\x90\x80\x80"}) {
    std::string replaced;
    for (std::size_t i = 0; i < bad.size(); ++i) replaced += none;
    EXPECT_EQ(written(bad), expected(replaced));
  }
  EXPECT_EQ(written("\xE4\xB8"), expected(none + none)) << "cut inside a character";
  EXPECT_EQ(written("\xF0\x9F\x94\xA9"), expected("\xF0\x9F\x94\xA9"));
}

TEST(Xml, AnEmptyElementIsClosedAndSoIsTheRest) {
  Xml xml;
  xml.open("a", {{"x", "1"}});
  xml.open("b");
  xml.leaf("c");
  EXPECT_EQ(xml.take(), "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a x=\"1\">\n  <b>\n    <c/>\n  </b>\n</a>\n");
}

}  // namespace
}  // namespace dripfeed::json

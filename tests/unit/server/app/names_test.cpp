// What is a name: its length in bytes, and what can be shown.
#include "server/app/base/names.h"

#include <string>

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

TEST(Names, WhatPeopleWriteIsOne) {
  for (const char* name : {"O0042", "mill-3", "hyperbolic-roll", "a b", "Welle 7 \xC3\x98 30", "../../etc", "50%",
                           "\xE6\xAD\xAF\xE8\xBD\xAE", "\xF0\x9F\x94\xA7", "...", "a\"b", "\xC2\xA0x"}) {
    EXPECT_EQ(why_no_name(name), "") << name;
  }
  EXPECT_EQ(why_no_name(std::string(200, 'x')), "");
}

TEST(Names, WhatCannotBeShownIsNone) {
  using namespace std::string_literals;
  for (const std::string& name : {""s,
                                  "."s,
                                  ".."s,
                                  " a"s,
                                  "a "s,
                                  " "s,
                                  "a\nb"s,
                                  "a\tb"s,
                                  "a\x7F"s,
                                  "a\0b"s,
                                  "\x1B[31m"s,
                                  "a\xC2\x85"s,
                                  "a\xE2\x80\xAE"s,
                                  "\xEF\xBB\xBFx"s,
                                  "a\xE2\x80\xA8"s,
                                  "\xEF\xBF\xBF"s,
                                  "\xFF"s,
                                  "a\xC3"s,
                                  "\xC0\xAF"s,
                                  "\xED\xA0\x80"s,
                                  "\xF4\x90\x80\x80"s,
                                  "\xE0\x80\xAF"s,
                                  "\x80"s,
                                  std::string(201, 'x'),
                                  std::string(65'520, 'x')}) {
    EXPECT_NE(why_no_name(name), "") << name.substr(0, 20);
  }
  EXPECT_EQ(why_no_name(std::string(201, 'x')), "must be at most 200 bytes, and has 201");
  EXPECT_EQ(why_no_name("ab\n"), "must be printable: U+000A at byte 3 is a control character or is not shown");
  EXPECT_EQ(why_no_name("ab\xFF"), "must be UTF-8: byte 3 is not");
}

}  // namespace
}  // namespace dripfeed::app

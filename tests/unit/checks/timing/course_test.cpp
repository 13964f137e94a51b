// The course of a program: which line begins when, in few points, and nothing where lines run more than once.
#include "checks/timing/course.h"

#include <gtest/gtest.h>

namespace dripfeed::timing {
namespace {

TEST(Course, HasEachLineOfAShortProgram) {
  Course course;
  for (std::uint32_t line = 1; line <= 5; ++line) {
    course.add(line, 0.5 * line);
    course.add(line, 0.5 * line + 0.1);  // its second motion
  }
  ASSERT_EQ(course.points().size(), 5U);
  EXPECT_EQ(course.points()[2].line, 3U);
  EXPECT_EQ(course.points()[2].start_s, 1.5);
}

TEST(Course, StaysSmallAndEvenlySpreadHoweverLongTheProgram) {
  Course course;
  constexpr std::uint32_t kLines = 1'000'000;
  for (std::uint32_t line = 1; line <= kLines; ++line) course.add(line, line);
  const auto& points = course.points();
  ASSERT_LE(points.size(), Course::kMost);
  ASSERT_GT(points.size(), Course::kMost / 2 - 1);
  EXPECT_EQ(points.front().line, 1U);
  const std::uint32_t step = points[1].line - points[0].line;
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_EQ(points[i].line - points[i - 1].line, step);
    EXPECT_EQ(points[i].start_s, points[i].line);
  }
  EXPECT_LT(kLines - points.back().line, step);
}

TEST(Course, IsEmptyWhereALineRunsAgain) {
  Course course;
  for (const std::uint32_t line : {1U, 2U, 3U, 2U, 3U, 4U}) course.add(line, line);
  EXPECT_TRUE(course.points().empty());
}

TEST(Course, IsEmptyWhereAnotherProgramIsCalled) {
  Course course;
  course.add(1, 0.0);
  course.give_up();
  course.add(2, 1.0);
  EXPECT_TRUE(course.points().empty());
}

}  // namespace
}  // namespace dripfeed::timing

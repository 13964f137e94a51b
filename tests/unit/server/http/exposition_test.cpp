// The text format, line by line: escapes, numbers, and families without a sample.
#include "server/http/exposition.h"

#include <limits>

#include <gtest/gtest.h>

namespace dripfeed::http {
namespace {

TEST(Exposition, WritesAFamilyWithItsSamples) {
  Exposition out;
  out.family("a_total", MetricType::counter, "What \\ it\ncounts \"here\".");
  out.sample({}, std::uint64_t{18'446'744'073'709'551'615U});
  out.sample({{"machine", "a\"b\\c\nd"}, {"state", "idle"}}, 0.25);
  out.family("none", MetricType::gauge, "Has no sample.");
  out.family("b_seconds", MetricType::histogram, "Durations.");
  out.part("bucket", {{"le", exposition_number(std::numeric_limits<double>::infinity())}}, std::uint64_t{3});
  out.part("sum", {}, 1e-7);
  EXPECT_EQ(out.take(),
            "# HELP a_total What \\\\ it\\ncounts \"here\".\n"
            "# TYPE a_total counter\n"
            "a_total 18446744073709551615\n"
            "a_total{machine=\"a\\\"b\\\\c\\nd\",state=\"idle\"} 0.25\n"
            "# HELP b_seconds Durations.\n"
            "# TYPE b_seconds histogram\n"
            "b_seconds_bucket{le=\"+Inf\"} 3\n"
            "b_seconds_sum 1e-07\n");
}

TEST(Exposition, NumbersThatAreNone) {
  EXPECT_EQ(exposition_number(-std::numeric_limits<double>::infinity()), "-Inf");
  EXPECT_EQ(exposition_number(std::numeric_limits<double>::quiet_NaN()), "NaN");
  EXPECT_EQ(exposition_number(0.0025), "0.0025");
}

}  // namespace
}  // namespace dripfeed::http

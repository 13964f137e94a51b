// Numbers of parameters, and the table of error codes.
#include "store/postgresql/placeholders.h"

#include <gtest/gtest.h>

#include "store/postgresql/fault.h"

namespace dripfeed::postgresql {
namespace {

using store::ErrorCode;

TEST(Placeholders, AreNumberedInTheirOrder) {
  EXPECT_EQ(numbered_parameters("SELECT 1"), "SELECT 1");
  EXPECT_EQ(numbered_parameters("a = ? AND b IN (?, ?)"), "a = $1 AND b IN ($2, $3)");
  EXPECT_EQ(numbered_parameters("?"), "$1");
}

TEST(Placeholders, AQuestionMarkInATextStays) {
  EXPECT_EQ(numbered_parameters("a = '?' AND b = ?"), "a = '?' AND b = $1");
  EXPECT_EQ(numbered_parameters("a = 'it''s ?' AND b = ?"), "a = 'it''s ?' AND b = $1");
  EXPECT_EQ(numbered_parameters("\"a?\" = ? -- ?\nAND b = ?"), "\"a?\" = $1 -- ?\nAND b = $2");
  EXPECT_EQ(numbered_parameters("a = '?"), "a = '?");
}

TEST(Placeholders, TheTableOfAnInsert) {
  EXPECT_EQ(table_of_insert("INSERT INTO job (id) VALUES (?)"), "job");
  EXPECT_EQ(table_of_insert("INSERT INTO job(id) VALUES (?)"), "job");
  EXPECT_EQ(table_of_insert("UPDATE job SET id = ?"), "");
}

TEST(Faults, AClassHoldsForItsCodes) {
  EXPECT_EQ(code_of("23505"), ErrorCode::exists);
  EXPECT_EQ(code_of("23503"), ErrorCode::broken_reference);
  EXPECT_EQ(code_of("23514"), ErrorCode::invalid_value);
  EXPECT_EQ(code_of("22021"), ErrorCode::invalid_value);
  EXPECT_EQ(code_of("DF001"), ErrorCode::append_only);
  EXPECT_EQ(code_of("55P03"), ErrorCode::busy);
  EXPECT_EQ(code_of("53100"), ErrorCode::disk_full);
  EXPECT_EQ(code_of("57P01"), ErrorCode::no_answer);
  EXPECT_EQ(code_of(""), ErrorCode::no_answer) << "the connection broke";
  EXPECT_EQ(code_of("42P01"), ErrorCode::internal);
}

}  // namespace
}  // namespace dripfeed::postgresql

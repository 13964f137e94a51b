// The words of a mapping from a provider's groups.
#include "server/app/shop/provider_people.h"

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

TEST(ProviderPeople, AGroupGivesARoleEverywhereOrOnAGroupOfMachines) {
  const auto all = read_group_role("dnc-admins=admin");
  ASSERT_TRUE(all);
  EXPECT_EQ(all->group, "dnc-admins");
  EXPECT_EQ(all->role, store::Role::admin);
  EXPECT_EQ(all->machines, "");
  const auto some = read_group_role("cn=hall 2,ou=shop=operator@mills = new");
  ASSERT_TRUE(some);
  EXPECT_EQ(some->group, "cn=hall 2,ou=shop");
  EXPECT_EQ(some->role, store::Role::operator_);
  EXPECT_EQ(some->machines, "mills = new");
  const auto mail = read_group_role("dnc@shop=viewer");
  ASSERT_TRUE(mail) << "a group with an @ in its name";
  EXPECT_EQ(mail->group, "dnc@shop");
  for (const char* const bad : {"", "dnc", "dnc=", "=admin", "dnc=boss", "dnc=admin@", "dnc=Admin", "=admin@mills"})
    EXPECT_FALSE(read_group_role(bad)) << bad;
}

}  // namespace
}  // namespace dripfeed::app

// Which addresses are open, local and never reached, in all the spellings that a name may resolve to.
#include "server/io/target_address.h"

#include <gtest/gtest.h>

namespace dripfeed::io {
namespace {

Reach reach(const char* text) { return reach_of(boost::asio::ip::make_address(text)); }

TEST(TargetAddress, EverybodysNetworkIsOpen) {
  for (const char* const text : {"8.8.8.8", "172.15.0.1", "172.32.0.1", "192.169.0.1", "2606:4700::1111"})
    EXPECT_EQ(reach(text), Reach::open) << text;
}

TEST(TargetAddress, ThisComputerAndPrivateNetworksAreLocal) {
  for (const char* const text :
       {"127.0.0.1", "127.9.9.9", "10.0.0.1", "172.16.0.1", "172.31.255.255", "192.168.1.1", "100.64.0.1", "::1",
        "fd12::1", "::ffff:127.0.0.1", "::ffff:10.1.2.3", "64:ff9b::a01:203", "2002:c0a8:101::1", "::127.0.0.1"})
    EXPECT_EQ(reach(text), Reach::local) << text;
}

TEST(TargetAddress, MetadataAndWhatIsNoReceiverIsNeverReached) {
  for (const char* const text : {"169.254.169.254", "169.254.0.1", "0.0.0.0", "0.1.2.3", "224.0.0.1", "255.255.255.255",
                                 "240.0.0.1", "100.100.100.200", "fe80::1", "fe80::1%1", "ff02::1", "::",
                                 "fd00:ec2::254", "::ffff:169.254.169.254", "64:ff9b::a9fe:a9fe", "2002:a9fe:a9fe::1"})
    EXPECT_EQ(reach(text), Reach::never) << text;
}

}  // namespace
}  // namespace dripfeed::io

// Which addresses a provider may name, and the address of our own page.
#include "server/oidc/provider_document.h"

#include <gtest/gtest.h>

namespace dripfeed::oidc {
namespace {

TEST(ProviderDocument, AddressesAreHttpsOrThisComputer) {
  for (const char* const good : {"https://login.shop/token", "http://127.0.0.1:8080/token", "http://localhost/x",
                                 "http://[::1]:9", "http://127.0.0.1"})
    EXPECT_EQ(why_no_endpoint(good), "") << good;
  for (const char* const bad :
       {"", "http://login.shop/", "ftp://login.shop", "javascript:alert(1)", "http://127.0.0.1.evil.example/",
        "http://127.0.0.1:80@evil.example/", "http://localhost@evil.example", "HTTP://127.0.0.1", "//login.shop"})
    EXPECT_NE(why_no_endpoint(bad), "") << bad;
}

TEST(ProviderDocument, ThePageIsSchemeAndHost) {
  EXPECT_EQ(why_no_page("https://dnc.shop", false), "");
  EXPECT_EQ(why_no_page("https://dnc.shop:8443", false), "");
  EXPECT_EQ(why_no_page("http://127.0.0.1:8840", false), "");
  EXPECT_EQ(why_no_page("http://dnc.shop", true), "");
  for (const char* const bad : {"http://dnc.shop", "https://dnc.shop/", "https://dnc.shop/x", "https://dnc.shop?x",
                                "https://", "https://a@dnc.shop", "dnc.shop"})
    EXPECT_NE(why_no_page(bad, false), "") << bad;
}

TEST(ProviderDocument, IsAtTheIssuersAddress) {
  EXPECT_EQ(document_url("https://login.shop/realms/a"),
            "https://login.shop/realms/a/.well-known/openid-configuration");
  EXPECT_EQ(document_url("https://login.shop/"), "https://login.shop/.well-known/openid-configuration");
}

}  // namespace
}  // namespace dripfeed::oidc

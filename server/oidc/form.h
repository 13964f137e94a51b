// Names and values as queries and forms of a browser carry them (application/x-www-form-urlencoded).
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace dripfeed::oidc {

std::string encoded(std::string_view text);
std::string form_of(std::initializer_list<std::pair<std::string_view, std::string_view>> fields);

}  // namespace dripfeed::oidc

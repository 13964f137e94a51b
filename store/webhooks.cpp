// Which events a list of types covers.
#include "store/webhooks.h"

#include <algorithm>

namespace dripfeed::store {

bool wants(const std::vector<std::string>& types, std::string_view type) {
  return std::ranges::any_of(types, [&](std::string_view one) {
    if (one == "*" || one == type) return true;
    return one.ends_with(".*") && type.starts_with(one.substr(0, one.size() - 1));
  });
}

}  // namespace dripfeed::store

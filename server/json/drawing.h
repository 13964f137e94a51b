// A family's drawing as its document.
#pragma once

#include <string>
#include <vector>

#include "dialects/compile/render/render.h"

namespace dripfeed::json {

std::string drawing(const std::vector<family::DrawnView>& views);

}  // namespace dripfeed::json

// Writes bytes into the store, in slices that leave others their turn: whoever takes the store again at once
// leaves them no gap, however short a slice is.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>

#include "server/app/base/error.h"
#include "store/contents.h"

namespace dripfeed::app {

// Fills what it is given from the front and says how much, 0 at the end; or why it cannot, as one sentence.
using Pieces = std::function<std::expected<std::size_t, std::string>(std::span<char>)>;

// Errors: unavailable (also where the pieces end in one), and the store's.
Result<store::Content> keep_in_slices(store::Contents& contents, const Pieces& pieces);
Result<store::Content> keep_in_slices(store::Contents& contents, std::string_view bytes);

}  // namespace dripfeed::app

// A shop as each old schema of SQLite held it, as SQL, and what must be read of it once the newest program has it.
#pragma once

#include <cstdint>
#include <string>

#include "store/store.h"

namespace dripfeed::store_test {

// schema/vN.sql below the folder of these tests.
std::string old_shop_file(std::uint32_t version);
std::string old_shop(std::uint32_t version);

// All of it, and that it is worked with on: `store` is changed.
void expect_old_shop(store::Store& store, std::uint32_t version);

}  // namespace dripfeed::store_test

// The folder of a server's store: its name on the disk, and how it is made.
#pragma once

#include <string>

#include "server/app/base/error.h"

namespace dripfeed::cli {

// The file of the store in that folder.
std::string store_path(const std::string& data);

// A folder of ours is for its owner alone; one that was there keeps the rights that it has.
app::Result<void> make_data_folder(const std::string& data);

}  // namespace dripfeed::cli

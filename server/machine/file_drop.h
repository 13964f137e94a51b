// Programs for controls that fetch files (FTP, SMB): under which name a program lies in the folder, by the control's
// own rules for file names.
#pragma once

#include <expected>
#include <string>
#include <string_view>

#include "server/machine/profile.h"

namespace dripfeed::machine {

// "O0042", "SHAFT.MPF", …: the program's name with the extension that the control wants, or the one that the link's
// option ext= gives; or one sentence that says why the control would not take such a name. Characters and lengths that
// no manual at hand states are held narrow: letters, digits, '_', '-', '+', '.'.
std::expected<std::string, std::string> file_name_for(const Profile& profile, std::string_view program);

}  // namespace dripfeed::machine

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

// Whether the machine's folder gets bare files: SINUMERIK's archives for a serial line begin with "%_N_NAME_MPF" and
// ";$PATH=…" and end with '%'. A file that the control fetches has its name and place from the folder, and a '%' in it
// is an alarm.
bool drops_bare_files(const Profile& profile);
inline constexpr std::size_t kArchiveEdge = 512;  // so many bytes of a text show its head or its tail
// Bytes of the head at the beginning of a text, with its EOBs; 0: there is none.
std::size_t archive_head(std::string_view beginning);
// Bytes of the tail: the final '%' and the EOBs after it.
std::size_t archive_tail(std::string_view end);
// The text of such a file.
std::string_view file_part(std::string_view text);

}  // namespace dripfeed::machine

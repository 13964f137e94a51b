// A folder as a line, for controls that fetch their programs as files (FTP, SMB): a job's text is written next to its
// name, read back, and gets its name in one step, so that whoever reads the folder sees the whole program or none.
// A file of that name that says something else is never replaced unless the link says overwrite=yes. What the control
// does with the file is not known here, and not claimed.
#pragma once

#include <expected>
#include <memory>
#include <string>

#include "server/app/lines/line.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

// The line of a dir: link; or which setting is wrong. A folder that is not there (yet) makes a disconnected line;
// one that was left torn takes no job before a person confirms.
std::expected<std::unique_ptr<Line>, std::string> make_folder_line(const machine::LineSettings& settings,
                                                                   LineChanged changed,
                                                                   feed::LeftAs left = feed::LeftAs::whole);

// How a text is written to a file: plain characters, the machine's EOB, no leader and no trailer.
tape_code::WireFormat folder_format(const machine::LineSettings& settings);

}  // namespace dripfeed::app

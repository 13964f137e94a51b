// Lines as files in one well-known folder: NAME.lock says who has a line now, NAME.state whether a block may be torn at
// its control. Every process that sends takes its line here first. The folder survives a reboot.
#pragma once

#include <expected>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "server/app/ports/line_claims.h"
#include "server/io/line_record.h"
#include "server/machine/link_url.h"

namespace dripfeed::io {

// DRIPFEED_LINES where that is set; else /var/lib/dripfeed/lines where it can be made; else
// $XDG_STATE_HOME/dripfeed/lines (~/.local/state). It exists when this returns. A folder of the system that exists and
// may not be written is an error: what it says of a line must not be passed over.
std::expected<std::filesystem::path, std::string> lines_folder();

// The names of a line, the first one for people. Two links are one line where they have a name in common: a serial port
// is named by the device that is there and by its path as written, a socket by host and port, a folder by its path.
// `device` is what identify_serial() says of the port, "" for other links.
struct LineNames {
  std::vector<std::string> names;
  std::string device;
};
LineNames names_of(const machine::LinkUrl& link, const std::string& sysfs = "/sys");

// app::ClaimLine in lines_folder(). The claim is let go with the object, or with the process however it ends. A claim
// that ends between begin() and end() leaves the line torn.
std::expected<std::unique_ptr<app::LineClaim>, std::string> claim_line(const machine::LinkUrl& link);
std::expected<std::unique_ptr<app::LineClaim>, std::string> claim_line_in(const std::filesystem::path& folder,
                                                                          const machine::LinkUrl& link,
                                                                          const std::string& sysfs = "/sys");

// The folder where it would be looked for, made or not; nothing is made. "": there is none.
std::filesystem::path known_lines_folder();
// Who has one of the line's names now, as it signed its lock: "dripfeed serve … (pid 77), since …". "": no process, as
// far as the system shows it. Nothing is taken.
std::string line_holder(const std::filesystem::path& folder, const machine::LinkUrl& link,
                        const std::string& sysfs = "/sys");

// What the records of a line say, without a claim: of the first name under which something is torn, else of the first
// name.
std::expected<LineRecord, std::string> look_at_line(const machine::LinkUrl& link);

}  // namespace dripfeed::io

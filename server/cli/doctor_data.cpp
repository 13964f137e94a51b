// The folder of the data: who may read and write it, how much room it has, whose it is, and what its store says.
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include "server/app/base/disk_reserve.h"
#include "server/cli/data_folder.h"
#include "server/cli/doctor.h"
#include "server/io/lock_holder.h"

namespace dripfeed::cli {

namespace {

constexpr std::uint64_t kFaultBelow_bytes = std::uint64_t{256} << 20U;
constexpr std::uint64_t kWarnBelow_bytes = std::uint64_t{2} << 30U;

// File systems on which SQLite's WAL does not hold what it promises: the memory that its users share is not a file's.
struct NetworkSystem {
  std::uint64_t magic;
  std::string_view name;
};
constexpr std::array kNetworkSystems = {NetworkSystem{0x6969, "NFS"}, NetworkSystem{0xFF534D42, "CIFS"},
                                        NetworkSystem{0xFE534D42, "SMB"}, NetworkSystem{0x01021997, "9p"}};

void look_at_file_system(const std::string& data, Findings& found) {
  struct statfs system{};
  if (::statfs(data.c_str(), &system) != 0) return;
  for (const NetworkSystem& one : kNetworkSystems) {
    if (static_cast<std::uint32_t>(system.f_type) != static_cast<std::uint32_t>(one.magic)) continue;
    found.push_back({Health::fault, "folder", fmt::format("{} lies on {}", data, one.name),
                     "a store must be on a disk of this computer: move the folder (dripfeed backup, restore)"});
  }
}

void look_at_room(const std::string& data, Findings& found) {
  const std::uint64_t room = app::DiskReserve::room_of_disk(data);
  const std::string text = fmt::format("{} MiB are free for {}", room >> 20U, data);
  if (room < kFaultBelow_bytes) {
    found.push_back({Health::fault, "disk", text,
                     fmt::format("make room: below {} MiB uploads are refused, and feeds stop when nothing is left",
                                 kFaultBelow_bytes >> 20U)});
  } else if (room < kWarnBelow_bytes) {
    found.push_back({Health::warning, "disk", text, "make room soon"});
  } else {
    found.push_back({Health::ok, "disk", text, ""});
  }
}

}  // namespace

std::string_view name_of(Health health) {
  static constexpr std::array<std::string_view, 3> kNames = {"ok", "warning", "fault"};
  return kNames[static_cast<std::size_t>(health)];
}

void look_at_folder(const std::string& data, Findings& found) {
  struct stat folder{};
  if (::stat(data.c_str(), &folder) != 0) {
    found.push_back({Health::fault, "folder", fmt::format("{}: {}", data, std::strerror(errno)),
                     "name the folder of the data; a server makes it when it starts first"});
    return;
  }
  if (!S_ISDIR(folder.st_mode)) {
    found.push_back({Health::fault, "folder", fmt::format("{} is no folder", data), "name the folder of the data"});
    return;
  }
  if (::access(data.c_str(), R_OK | W_OK | X_OK) != 0) {
    found.push_back({Health::fault, "folder",
                     fmt::format("{} is not for the user {}: {}", data, ::geteuid(), std::strerror(errno)),
                     "run this as the server's user, or give the folder to it (chown)"});
  } else if ((folder.st_mode & 0077U) != 0) {
    found.push_back({Health::warning, "folder",
                     fmt::format("{} is open to others (mode {:o})", data, folder.st_mode & 0777U),
                     fmt::format("chmod 700 {}", data)});
  } else {
    found.push_back({Health::ok, "folder", fmt::format("{} is for its owner alone", data), ""});
  }
  look_at_file_system(data, found);
  look_at_room(data, found);
}

void look_at_owner(const std::string& data, Findings& found) {
  const auto holder = io::lock_holder(store_path(data) + ".lock");
  if (!holder) {
    found.push_back({Health::ok, "owner", "no server runs on it, as far as the system shows it", ""});
    return;
  }
  found.push_back({Health::ok, "owner", fmt::format("process {} has it: {}", *holder, io::command_of(*holder)), ""});
}

void look_at_contents(const std::string& data, Findings& found, sqlite::StoreState& state) {
  const std::string path = store_path(data);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    found.push_back({Health::warning, "store", fmt::format("{} is not there", path),
                     "nothing is to be done before the first start of a server; else see dripfeed restore"});
    return;
  }
  auto looked = sqlite::look_at_store(path);
  if (!looked) {
    found.push_back({Health::fault, "store", fmt::format("{}: {}", path, store::message_of(looked.error())),
                     "dripfeed ledger verify reports more; dripfeed restore makes a store of a backup"});
    return;
  }
  state = std::move(*looked);
  if (state.schema > state.program_schema) {
    found.push_back({Health::fault, "schema",
                     fmt::format("the store has schema {}, this program knows {}", state.schema, state.program_schema),
                     "install the newer program again, or restore a backup that is older"});
    return;
  }
  const bool is_older = state.schema < state.program_schema;
  found.push_back({is_older ? Health::warning : Health::ok, "schema",
                   fmt::format("the store has schema {}, this program's is {}", state.schema, state.program_schema),
                   is_older ? "the next start of a server brings it up to date: make a backup before" : ""});
  found.push_back({state.hollow_contents > 0 ? Health::fault : Health::ok, "contents",
                   fmt::format("{} contents, {} without their bytes", state.contents, state.hollow_contents),
                   state.hollow_contents > 0 ? "dripfeed ledger verify names them; restore a backup" : ""});
  if (state.torn_machines > 0) {
    found.push_back({Health::warning, "torn", fmt::format("{} machines wait for a confirmation", state.torn_machines),
                     "look at their controls, reset them, and confirm it at their cards"});
  }
}

}  // namespace dripfeed::cli

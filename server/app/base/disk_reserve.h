// Room on the store's disk that is kept for the ledger: a file that is given up when the disk is full, so that what
// runs can be booked to its end. Until it is whole again nothing new begins. What is booked, and when to look for room,
// the ledger's writer decides.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>

#include "server/app/base/error.h"

namespace dripfeed::app {

class DiskReserve {
 public:
  // A ledger of one line grows by about 2 kB a second, of 100 lines by about 100 kB: at least ten minutes.
  static constexpr std::uint64_t kBytes = std::uint64_t{64} << 20U;

  // Bytes that the disk of a folder has left.
  using Room = std::function<std::uint64_t(const std::filesystem::path& folder)>;
  // Makes the file if there is room for it.
  explicit DiskReserve(std::filesystem::path path, std::uint64_t bytes = kBytes, Room room = room_of_disk);
  // From any thread.
  [[nodiscard]] bool is_whole() const { return is_whole_.load(); }
  // Leaves its room to the store. False when there is none left to give. From one thread, as restore().
  bool give_up();
  // Makes the file again where the disk has as much room again next to it.
  void restore();

  // 0 where the disk does not state it: then there is no room that we know of.
  static std::uint64_t room_of_disk(const std::filesystem::path& folder);

 private:
  std::filesystem::path path_;
  std::uint64_t bytes_;
  Room room_;
  std::atomic<bool> is_whole_{false};
};

// `unavailable` while the reserve is given up; nullptr is a store without one.
Result<void> refuse_on_full_disk(const DiskReserve* disk_reserve);

}  // namespace dripfeed::app

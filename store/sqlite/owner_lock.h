// The lock of the one server of a store: a file next to it. The system drops the lock with the process, however it
// ends.
#pragma once

#include <string>

#include "store/error.h"

namespace dripfeed::sqlite {

class OwnerLock {
 public:
  // Errors: in_use, cannot_open.
  static store::Result<OwnerLock> take(const std::string& store_path);
  OwnerLock(OwnerLock&& other) noexcept;
  OwnerLock& operator=(OwnerLock&&) = delete;
  ~OwnerLock();

 private:
  explicit OwnerLock(int file) : file_(file) {}
  int file_;
};

}  // namespace dripfeed::sqlite

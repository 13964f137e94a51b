// The shim: its file holds the real file under it in the same memory.
#include "tests/store/failing_vfs.h"

#include <algorithm>
#include <new>

#include <sqlite3.h>

namespace dripfeed::store_test {
namespace {

struct Plan {
  std::uint64_t left = 0;  // changes until the fault; 0: none comes
  Fault fault = Fault::once;
  bool happened = false;
};
Plan plan;

// The result code of a change that is about to be made; SQLITE_OK lets it through.
int next_change(bool write) {
  if (plan.happened && plan.fault != Fault::once)
    return plan.fault == Fault::full_for_good ? SQLITE_FULL : SQLITE_IOERR;
  if (plan.left == 0 || --plan.left > 0) return SQLITE_OK;
  plan.happened = true;
  if (plan.fault == Fault::full_for_good) return SQLITE_FULL;
  return write ? SQLITE_IOERR_WRITE : SQLITE_IOERR_FSYNC;
}

struct File {
  sqlite3_file base;
  sqlite3_file* real;
};
File& file_of(sqlite3_file* file) { return *reinterpret_cast<File*>(file); }
sqlite3_file* real_of(sqlite3_file* file) { return file_of(file).real; }
const sqlite3_io_methods& methods_of(sqlite3_file* file) { return *real_of(file)->pMethods; }
sqlite3_vfs* real_vfs() { return sqlite3_vfs_find("unix"); }

int close_file(sqlite3_file* file) { return methods_of(file).xClose(real_of(file)); }
int read_file(sqlite3_file* file, void* data, int size, sqlite3_int64 at) {
  return methods_of(file).xRead(real_of(file), data, size, at);
}
int write_file(sqlite3_file* file, const void* data, int size, sqlite3_int64 at) {
  const bool before = plan.happened;
  const int result = next_change(true);
  // The write that meets the fault reaches the disk in half.
  if (result != SQLITE_OK && !before) static_cast<void>(methods_of(file).xWrite(real_of(file), data, size / 2, at));
  return result == SQLITE_OK ? methods_of(file).xWrite(real_of(file), data, size, at) : result;
}
int truncate_file(sqlite3_file* file, sqlite3_int64 size) {
  const int result = next_change(false);
  return result == SQLITE_OK ? methods_of(file).xTruncate(real_of(file), size) : result;
}
int sync_file(sqlite3_file* file, int flags) {
  const int result = next_change(false);
  return result == SQLITE_OK ? methods_of(file).xSync(real_of(file), flags) : result;
}
int size_of_file(sqlite3_file* file, sqlite3_int64* size) { return methods_of(file).xFileSize(real_of(file), size); }
int lock_file(sqlite3_file* file, int level) { return methods_of(file).xLock(real_of(file), level); }
int unlock_file(sqlite3_file* file, int level) { return methods_of(file).xUnlock(real_of(file), level); }
int check_lock(sqlite3_file* file, int* result) { return methods_of(file).xCheckReservedLock(real_of(file), result); }
int control(sqlite3_file* file, int op, void* argument) {
  return methods_of(file).xFileControl(real_of(file), op, argument);
}
int sector_size(sqlite3_file* file) { return methods_of(file).xSectorSize(real_of(file)); }
int device(sqlite3_file* file) { return methods_of(file).xDeviceCharacteristics(real_of(file)); }
int shm_map(sqlite3_file* file, int page, int size, int extend, void volatile** data) {
  return methods_of(file).xShmMap(real_of(file), page, size, extend, data);
}
int shm_lock(sqlite3_file* file, int offset, int n, int flags) {
  return methods_of(file).xShmLock(real_of(file), offset, n, flags);
}
void shm_barrier(sqlite3_file* file) { methods_of(file).xShmBarrier(real_of(file)); }
int shm_unmap(sqlite3_file* file, int remove) { return methods_of(file).xShmUnmap(real_of(file), remove); }

constexpr int kVersionWithSharedMemory = 2;
constexpr sqlite3_io_methods kMethods{kVersionWithSharedMemory,
                                      close_file,
                                      read_file,
                                      write_file,
                                      truncate_file,
                                      sync_file,
                                      size_of_file,
                                      lock_file,
                                      unlock_file,
                                      check_lock,
                                      control,
                                      sector_size,
                                      device,
                                      shm_map,
                                      shm_lock,
                                      shm_barrier,
                                      shm_unmap,
                                      nullptr,
                                      nullptr};

int open_file(sqlite3_vfs* /*vfs*/, sqlite3_filename name, sqlite3_file* file, int flags, int* given) {
  File& made = *new (file) File{{nullptr}, nullptr};
  made.real = reinterpret_cast<sqlite3_file*>(&made + 1);
  const int result = real_vfs()->xOpen(real_vfs(), name, made.real, flags, given);
  made.base.pMethods = made.real->pMethods == nullptr ? nullptr : &kMethods;
  return result;
}

int remove_file(sqlite3_vfs* /*vfs*/, const char* name, int sync) {
  const int result = next_change(false);
  return result == SQLITE_OK ? real_vfs()->xDelete(real_vfs(), name, sync) : result;
}

}  // namespace

void register_failing_vfs() {
  if (sqlite3_vfs_find(kFailingVfs) != nullptr) return;
  static sqlite3_vfs vfs = *real_vfs();
  vfs.zName = kFailingVfs;
  vfs.szOsFile = static_cast<int>(sizeof(File)) + real_vfs()->szOsFile;
  vfs.xOpen = open_file;
  vfs.xDelete = remove_file;
  vfs.pNext = nullptr;
  sqlite3_vfs_register(&vfs, 0);
}

void fail_at(std::uint64_t n, Fault fault) { plan = {n, fault, false}; }

bool failed() { return plan.happened; }

}  // namespace dripfeed::store_test

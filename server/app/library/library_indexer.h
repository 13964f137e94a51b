// Keeps the library: a thread of its own looks which programs have changed and puts what they say into it. The store is
// only read, and the texts are read by workers, so that neither a feed nor whoever changes a program waits for it.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>

#include "server/app/base/round_thread.h"
#include "server/app/checks/workers.h"
#include "store/library.h"

namespace dripfeed::app {

class LibraryIndexer {
 public:
  // Without `workers` texts are read here.
  LibraryIndexer(store::Store& store, store::Library& library, Workers* workers);
  ~LibraryIndexer() { stop(); }
  LibraryIndexer(const LibraryIndexer&) = delete;
  LibraryIndexer& operator=(const LibraryIndexer&) = delete;

  store::Library& library() { return library_; }
  // Programs whose last change is not in it yet.
  Result<std::uint64_t> waiting();
  // Ends the thread; what is not in it yet comes when the server starts again.
  void stop();

 private:
  void round();
  Result<void> drop_another_store_s();
  Result<bool> step();
  Result<std::vector<ProgramDigest>> digests_of(const std::vector<DigestOrder>& orders);

  store::Store& store_;
  store::Library& library_;
  Workers* workers_;
  std::stop_source ends_;
  bool is_ours_ = false;               // it was looked at whether it is of this store
  std::optional<std::uint64_t> seen_;  // version of the store up to which all is in it
  RoundThread thread_;                 // last: it uses all of the above
};

}  // namespace dripfeed::app

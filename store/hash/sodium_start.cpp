// Starting libsodium, once.
#include "store/hash/sodium_start.h"

#include <cstdlib>

#include <sodium.h>

namespace dripfeed::hash {

void start_sodium() {
  // A local static is made once, whatever threads meet here.
  static const bool started = sodium_init() >= 0;
  if (!started) std::abort();
}

}  // namespace dripfeed::hash

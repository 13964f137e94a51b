// Starts libsodium before its first use. It is the only fault of this folder, and the program ends by it: without a
// random source nothing that depends on it is safe.
#pragma once

namespace dripfeed::hash {

void start_sodium();

}  // namespace dripfeed::hash

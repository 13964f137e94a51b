// store/hash: SHA-256 of streams, random tokens and their hashes, by libsodium. It alone names sodium in the store.
#pragma once

#include "store/hash/sha256.h"
#include "store/hash/token.h"

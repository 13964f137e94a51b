// store/hash: SHA-256 of streams, random tokens and their hashes, passwords, by libsodium. It alone names sodium in the
// store.
#pragma once

#include "store/hash/password.h"
#include "store/hash/sha256.h"
#include "store/hash/token.h"

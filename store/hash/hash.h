// store/hash: SHA-256 of streams, random tokens and their hashes, passwords, signatures of webhooks, by libsodium. It
// alone names sodium in the store.
#pragma once

#include "store/hash/password.h"
#include "store/hash/sha256.h"
#include "store/hash/token.h"
#include "store/hash/webhook_secret.h"

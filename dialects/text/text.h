// dialects/text: bytes and what can be known of them without knowing a language: spans, lines and columns, numbers,
// diagnostics, byte readers. It names no other folder, opens no file and reads no clock; encodings and archives live
// here too. What a byte sequence means is left to the dialects.
#pragma once

#include "dialects/text/byte_reader.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/number.h"
#include "dialects/text/source.h"
#include "dialects/text/span.h"

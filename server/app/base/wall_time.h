// Times of the wall's clock as texts.
#pragma once

#include <cstdint>
#include <string>

namespace dripfeed::app {

// "2026-11-26T02:30:09.120Z" (RFC 3339), of milliseconds since 1970.
std::string rfc3339(std::int64_t wall_ms);

}  // namespace dripfeed::app

// Version 11: events for other systems, webhooks and their deliveries.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV11;

}  // namespace dripfeed::sqlite

// Version 11: events for other systems, webhooks and their deliveries; orders, and which order a job belongs to.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV11;

}  // namespace dripfeed::sqlite

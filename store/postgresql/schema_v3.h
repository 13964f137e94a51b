// The SQL of version 3: attachments.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV3;

}  // namespace dripfeed::postgresql

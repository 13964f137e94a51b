// The SQL of version 4: attachments.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV4;

}  // namespace dripfeed::postgresql

// Version 5: answers to operators, booked before they leave.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV5;

}  // namespace dripfeed::sqlite

// Version 13: releases that continue the text of another one.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV13;

}  // namespace dripfeed::sqlite

// From a request to what a worker is asked about a text. Only files of this folder include this.
#pragma once

#include <string>

#include "server/app/checks/diagnose.h"
#include "server/http/api.h"
#include "server/json/requests.h"

namespace dripfeed::http {

// The machine's document; "" where none is named. Errors: not_found.
app::Result<std::string> profile_of(store::Store& store, const std::string& machine);

// Errors: as profile_of.
app::Result<app::DiagnoseOrder> text_order(const Call& call, json::DiagnoseBody body);

}  // namespace dripfeed::http

// All documents of the API: bodies of requests, answers, data of live events. A route (server/http/routes.cpp) says
// which it takes and gives by name. Each kind of thing has a file; a new document is a row in one of them.
#pragma once

#include <string>
#include <vector>

#include "server/json/schema.h"

namespace dripfeed::json {

struct NamedSchema {
  std::string name;  // "Job"
  Schema schema;
};
using Schemas = std::vector<NamedSchema>;

// Those below, one after the other.
Schemas all_schemas();

Schemas site_schemas();     // health, session, problems, alarms
Schemas machine_schemas();  // machines and their lines
Schemas catalog_schemas();  // families and parts
Schemas program_schemas();  // programs, rendering
Schemas check_schemas();    // verdicts and what they report
Schemas compare_schemas();  // two revisions, compared
Schemas library_schemas();  // searches, where a program is used, attached files
Schemas path_schemas();     // toolpaths
Schemas editing_schemas();  // faults of a text while it is written, words of a dialect
Schemas measure_schemas();  // figures that are not kept, sweeps
Schemas job_schemas();      // releases, jobs, ledgers
Schemas history_schemas();  // sums of the past
Schemas stop_reason_schemas();
Schemas receipt_schemas();  // receipts and requests of operators
Schemas store_schemas();    // the whole store, its backups
Schemas webhook_schemas();  // events for other systems, webhooks

}  // namespace dripfeed::json

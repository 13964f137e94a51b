// GET /metrics, part by part. What lines do is taken from what the follower published, so that no line, and nothing
// that a line waits for, is asked.
#pragma once

#include <string_view>

#include "server/app/application.h"
#include "server/http/exposition.h"
#include "server/http/live.h"
#include "server/http/traffic.h"

namespace dripfeed::http {

void write_line_metrics(Exposition& out, app::Application& application);   // metrics_lines.cpp
void write_alarm_metrics(Exposition& out, app::Application& application);  // metrics_lines.cpp
void write_server_metrics(Exposition& out, std::string_view version);      // metrics_server.cpp
void write_http_metrics(Exposition& out, Traffic& traffic);                // metrics_server.cpp
void write_store_metrics(Exposition& out, const store::StoreUse& use);     // metrics_server.cpp
// Places for live events and heavy work.
void write_work_metrics(Exposition& out, LiveHub& live, app::Workplace& workplace);  // metrics_server.cpp

}  // namespace dripfeed::http

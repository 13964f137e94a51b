// Each member is one function of this folder.
#include "server/json/documents.h"

#include "server/json/drawing.h"
#include "server/json/profile_document.h"
#include "server/json/reports.h"
#include "server/json/requests.h"
#include "server/json/verdict_records.h"

namespace dripfeed::json {

app::Result<machine::Profile> JsonDocuments::read_profile(std::string_view document) const {
  return json::read_profile(document);
}
app::Result<app::Values> JsonDocuments::read_values(std::string_view document) const {
  return json::read_values(document);
}
std::string JsonDocuments::write_values(const app::Values& values) const { return json::write_values(values); }
std::string JsonDocuments::write_report(const app::CheckReport& report) const { return json::check_report(report); }
std::optional<double> JsonDocuments::cycle_s(std::string_view report) const { return json::cycle_s_of(report); }
std::string JsonDocuments::write_drawing(const std::vector<family::DrawnView>& drawing) const {
  return json::drawing(drawing);
}

}  // namespace dripfeed::json

// The application's documents, as JSON.
#pragma once

#include "server/app/base/documents.h"

namespace dripfeed::json {

class JsonDocuments final : public app::Documents {
 public:
  [[nodiscard]] app::Result<machine::Profile> read_profile(std::string_view document) const override;
  [[nodiscard]] app::Result<app::Values> read_values(std::string_view document) const override;
  [[nodiscard]] std::string write_values(const app::Values& values) const override;
  [[nodiscard]] std::string write_report(const app::CheckReport& report) const override;
  [[nodiscard]] std::optional<double> cycle_s(std::string_view report) const override;
  [[nodiscard]] std::string write_drawing(const std::vector<family::DrawnView>& drawing) const override;
};

}  // namespace dripfeed::json

// Reading and writing the documents that the store keeps for us. The application knows what they say, not how they are
// written; server/json implements this.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"
#include "server/app/base/report.h"
#include "server/machine/profile.h"

namespace dripfeed::family {
struct DrawnView;
}  // namespace dripfeed::family

namespace dripfeed::app {

// Parameter values of a part, as people write them: "roll_length" → "200 mm".
using Values = std::map<std::string, std::string, std::less<>>;

class Documents {
 public:
  Documents() = default;
  Documents(const Documents&) = delete;
  Documents& operator=(const Documents&) = delete;
  virtual ~Documents() = default;
  // Errors: invalid, with a place for each fault.
  [[nodiscard]] virtual Result<machine::Profile> read_profile(std::string_view document) const = 0;
  [[nodiscard]] virtual Result<Values> read_values(std::string_view document) const = 0;
  [[nodiscard]] virtual std::string write_values(const Values& values) const = 0;
  // The whole report of a check, as GET /checks/{id} gives it.
  [[nodiscard]] virtual std::string write_report(const CheckReport& report) const = 0;
  // How long the whole program takes by such a report, in seconds; nothing where it does not say.
  [[nodiscard]] virtual std::optional<double> cycle_s(std::string_view report) const = 0;
  // A family's drawing, as POST /preview gives it.
  [[nodiscard]] virtual std::string write_drawing(const std::vector<family::DrawnView>& drawing) const = 0;
};

}  // namespace dripfeed::app

// One line a member.
#include "server/json/profile_receive.h"

#include <array>

namespace dripfeed::json {

void read_receive(ObjectReader& object, machine::ReceiveSettings& receive) {
  static constexpr std::array<std::string_view, 3> kHolds = {"none", "dc3", "rts"};
  static constexpr std::array<std::string_view, 2> kReceiveCodes = {"line", "auto"};
  object.flag("enabled", receive.enabled);
  object.number("quiet_s", receive.quiet_s, 0.2, 60.0);
  object.number("quiet_after_end_s", receive.quiet_after_end_s, 0.05, 10.0);
  object.integer("end_character", receive.end_character, 1, 31);
  if (const auto code = object.choice("code", kReceiveCodes)) receive.find_code = *code == 1;
  if (const auto hold = object.choice("hold", kHolds)) receive.hold = static_cast<receive::Hold>(*hold);
  object.flag("read_back", receive.read_back);
  object.number("read_back_minutes", receive.read_back_minutes, 0.01, 1440.0);
  object.flag("requests", receive.requests);
  object.integer("request_number", receive.request_number, 1, 99'999'999);
  object.integer("answer_number", receive.answer_number, 1, 99'999'999);
  object.text("request_marker", receive.request_marker);
  object.integer("scan_lines", receive.scan_lines, 1, 100);
  object.number("request_delay_s", receive.request_delay_s, 0.0, 60.0);
  object.flag("remote_drip", receive.remote_drip);
  object.flag("remote_arm", receive.remote_arm);
  if (receive.remote_arm && !receive.remote_drip) object.fault("remote_arm", "needs remote_drip");
}

}  // namespace dripfeed::json

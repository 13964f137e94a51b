// Which rules belong to which protocol.
#include "protocol/packet/receive_rules.h"
#include "protocol/packet/send_rules.h"
#include "protocol/packet/xmodem.h"

namespace dripfeed::packet {

std::unique_ptr<SendRules> make_send_rules(const Settings& settings) {
  return std::make_unique<XmodemSendRules>(settings);
}

std::unique_ptr<ReceiveRules> make_receive_rules(const Settings& settings) {
  return std::make_unique<XmodemReceiveRules>(settings);
}

}  // namespace dripfeed::packet

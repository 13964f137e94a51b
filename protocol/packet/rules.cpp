// Which rules belong to which protocol.
#include "protocol/packet/receive_rules.h"
#include "protocol/packet/remote_buffer.h"
#include "protocol/packet/s3964.h"
#include "protocol/packet/send_rules.h"
#include "protocol/packet/xmodem.h"

namespace dripfeed::packet {

std::unique_ptr<SendRules> make_send_rules(const Settings& settings) {
  if (is_3964(settings.protocol)) return std::make_unique<S3964SendRules>(settings);
  if (settings.protocol == Protocol::remote_buffer_a) return std::make_unique<RemoteBufferSendRules>(settings);
  return std::make_unique<XmodemSendRules>(settings);
}

std::unique_ptr<ReceiveRules> make_receive_rules(const Settings& settings) {
  if (is_3964(settings.protocol)) return std::make_unique<S3964ReceiveRules>(settings);
  if (settings.protocol == Protocol::remote_buffer_a) return std::make_unique<RemoteBufferReceiveRules>(settings);
  return std::make_unique<XmodemReceiveRules>(settings);
}

}  // namespace dripfeed::packet

// How a machine's line takes what its control punches, and what its operator may ask for from there. Plain data of the
// profile, and what the receiver makes of it.
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <string>

#include "protocol/receive/receiver.h"
#include "protocol/receive/request.h"

namespace dripfeed::machine {

struct LineSettings;

struct ReceiveSettings {
  bool enabled = true;
  double quiet_s = 5.0;                       // 3..10 is usual
  double quiet_after_end_s = 0.5;             // after the final '%'
  std::optional<std::uint8_t> end_character;  // EOT, ETX, SUB …
  bool find_code = false;                     // ISO, ASCII or EIA is found out from what comes
  receive::Hold hold = receive::Hold::none;   // how the control's output is held while the server cannot keep up
  bool read_back = false;                     // the control can punch: a memory load is compared with what it punches
  double read_back_minutes = 30.0;            // ... for so long; then it is named as never read back
  bool requests = true;                       // an operator may ask by a program
  std::uint32_t request_number = 9999;        // O number of a request
  std::uint32_t answer_number = 0;            // O number of an answer; 0: the request's
  std::string request_marker;                 // or a word in its name, where the control has names
  std::uint32_t scan_lines = 5;               // lines that are looked at for the verb
  double request_delay_s = 5.0;               // before an answer starts, where the control does not ask with DC1
  bool remote_drip = false;                   // (DNC name) may queue a drip-feed
  bool remote_arm = false;                    // ... and arm it: the operator at the control is the person

  friend bool operator==(const ReceiveSettings&, const ReceiveSettings&) = default;
};

// The receiver's settings for this line; its URL's options are laid over already (effective_line).
receive::Settings receive_settings_of(const LineSettings& line);
// Whether what comes over this line can be received as the settings ask; or one sentence that says why not. The URL's
// options are laid over already.
std::expected<void, std::string> can_receive(const LineSettings& line);
receive::RequestGrammar request_grammar_of(const ReceiveSettings& settings);

}  // namespace dripfeed::machine

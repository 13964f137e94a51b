// Listens for peers that read lines of text: each gets its greeting and then what is new, four times a second. They
// change nothing here.
#pragma once

#include <expected>
#include <memory>
#include <string>

#include "server/app/ports/text_feed.h"
#include "server/io/peer_listener.h"

namespace dripfeed::io {

// `protocol`: as PeerListener::listen() has it. Errors: as there.
std::expected<std::unique_ptr<PeerListener>, std::string> listen_for_readers(const PeerSettings& settings,
                                                                             std::string protocol,
                                                                             app::MakeTextFeed make);

}  // namespace dripfeed::io

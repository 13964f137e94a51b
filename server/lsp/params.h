// What a message of the client says, as plain data. A message that lacks what the protocol asks of it is refused with a
// sentence; members that are not known here are the protocol's, and are left alone.
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "server/lsp/features.h"

namespace dripfeed::lsp {

using Document = nlohmann::ordered_json;

template <class T>
using Read = std::expected<T, std::string>;

struct Client {
  PositionUnit unit = PositionUnit::utf16;
  bool takes_symbol_trees = false;
};
// Of the parameters of `initialize`. UTF-8 where the client has it.
Client read_client(const Document& params);

// The settings over `base`; of a document that is not an object, `base` itself. Every fault in one sentence.
Read<Settings> read_settings(const Document& document, Settings base);

struct OpenedText {
  std::string uri;
  std::int64_t version = 0;
  std::string text;
};
Read<OpenedText> read_opened(const Document& params);

struct ChangedText {
  std::string uri;
  std::int64_t version = 0;
  std::vector<Change> changes;
};
Read<ChangedText> read_changed(const Document& params);

Read<std::string> read_uri(const Document& params);
Read<Position> read_position(const Document& params);
Read<Range> read_range(const Document& params);

// nullptr where the document is not an object or has no such member.
const Document* member(const Document& document, std::string_view name);

}  // namespace dripfeed::lsp

// file: URIs (RFC 8089) and paths.
#pragma once

#include <string>
#include <string_view>

namespace dripfeed::lsp {

// "" for a URI of another kind: a text that is not saved.
std::string path_of(std::string_view uri);
std::string file_uri(std::string_view path);

}  // namespace dripfeed::lsp

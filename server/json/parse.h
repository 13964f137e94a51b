// A text as a JSON document, and back. Stricter than the parser: a member that is given twice and nesting that no
// document has are refused, too, and every fault has its place. Only files of this folder, of server/lsp and of
// server/oidc include this.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "server/app/base/error.h"

namespace dripfeed::json {

using Document = nlohmann::ordered_json;

inline constexpr std::size_t kDeepest =
    64;  // objects and arrays inside each other; each level costs many times the memory of its one character

// A member is looked for among all before it, so an object with many takes the square of their number; no document of
// ours has more.
inline constexpr std::size_t kMostMembers = 1024;
// In all of a document that comes from outside: each takes many times the memory of its one character.
inline constexpr std::size_t kMostValues = 200'000;

// The text as a document; or `malformed`: one fault with line, column and the JSON pointer (RFC 6901) of what was being
// read. The first reading keeps nothing, and stops at the first fault.
app::Result<Document> parse(std::string_view text, std::size_t most_values = kMostValues);
// Compact; text that is not UTF-8 is shown with replacement characters.
std::string dump(const Document& document);
// The raw text of a JSON document that is kept or was written here, as a member: its values were counted when it came.
Document embedded(std::string_view text);
// The document Said of a sentence, with those in its values; null where it is not in the table.
Document sentence_or_null(std::string_view sentence);
inline Document text_or_null(std::string_view text) { return text.empty() ? Document(nullptr) : Document(text); }
// 0 is none.
inline Document time_or_null(std::int64_t at_ms) { return at_ms == 0 ? Document(nullptr) : Document(at_ms); }
inline Document id_or_null(std::uint64_t id) { return id == 0 ? Document(nullptr) : Document(id); }
// A member's name as a part of a pointer.
std::string escape_pointer(std::string_view name);

}  // namespace dripfeed::json

// The shape of a document as a table of its members: what openapi.json says of a body, an answer or a live event. It is
// data without a parser's types, so that the tables (schemas_*.cpp) are quick to compile; openapi.cpp writes them.
//
//   {"Job", object("one transfer", {{"id", integer("of this job")},
//                                   {"armed_by", or_null(text("who armed it"))},
//                                   {"note", text("for people"), kOptional}})}
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::json {

struct Member;
using Words = std::vector<std::string_view>;

struct Schema {
  enum class Kind : std::uint8_t { any, text, integer, number, flag, object, list, map, reference, text_or_number };
  Kind kind = Kind::any;
  std::string about;                  // unit and meaning, for people
  Words words;                        // of a text: one of these
  std::vector<std::string> meanings;  // of the words, in their order; empty: they speak for themselves
  bool is_filled = false;             // of a text: not ""
  std::optional<double> least;        // of a number
  std::optional<double> most;
  bool may_be_null = false;
  bool is_closed = false;             // of an object: other members are refused
  std::vector<Member> members;        // of an object
  std::vector<Schema> of;             // of a list or a map: one, of its elements
  std::optional<std::size_t> length;  // of a list that always has as many elements
  std::string name;                   // of a reference
};

enum class Presence : std::uint8_t { required, optional };
inline constexpr Presence kOptional = Presence::optional;

struct Member {
  std::string name;
  Schema schema;
  Presence presence = Presence::required;
};
using Members = std::vector<Member>;

Schema any(std::string about);
Schema text(std::string about);
Schema filled_text(std::string about);  // not ""
Schema one_of(std::span<const std::string_view> words, std::string about);
// Whole numbers; counts, ids and revisions are not below 0.
Schema integer(std::string about);
Schema integer(double least, double most, std::string about);
Schema number(std::string about);
Schema number(double least, double most, std::string about);
Schema flag(std::string about);
// Milliseconds since 1970, UTC.
Schema time_ms(std::string about);
Schema object(std::string about, Members members);
Schema list_of(Schema element, std::string about);
Schema list_of(std::size_t length, Schema element, std::string about);
Schema text_or_number(std::string about);
// An object whose members' names are data.
Schema map_of(Schema element, std::string about);
// A schema of this name in openapi.json.
Schema reference(std::string name);
Schema or_null(Schema schema);

// The document of a request: its readers (requests.cpp, profile_document.cpp) refuse members that they do not know, and
// take null for a member that is not there.
Schema closed_object(std::string about, Members members);

// For the start of another table: what two documents share.
Members operator+(Members first, Members more);

}  // namespace dripfeed::json

// Which handler answers which path, as a table: method, pattern, role, handler. Rights are a column of the table, so
// that no handler can forget them; /api/openapi.json is written from the same rows.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/request.h"

namespace dripfeed::http {

// What a caller must be at least. `anybody` needs no token.
enum class Right : std::uint8_t { anybody, viewer, operator_, programmer, approver, admin };
std::string_view name_of(Right right);

// Where a route is answered (see lanes.h), and what an answer under an idempotency key is.
//
//   stored   lane `read`: reads that say what the store says and no more, to everybody alike: the answer is kept
//            while the store is the same (see kept_answers.h)
//   light    other small reads in the lane `read`, and on the HTTP thread those that need no right; changes in the
//            lane `write`, each in one transaction with its kept answer
//   staged   lane `write`: its rows are committed at the end, together with those of other callers who wait; see
//            Call::commit
//   command  lane `command`: acts on lines, which no transaction can undo
//   arming   lane `arm`: as a command, and it may wait for another system
//   bulk     lane `bulk`: much text. A change puts its text first and then commits its rows, as a staged one, so that
//            no transaction lasts as long as a text
//   setup    lane `bulk`: opens lines, or has transactions of its own
//   heavy    lane `heavy`: rendering, checks
//   secret   lane `secret`: passwords, PINs, tokens; no answer is kept under an idempotency key, as it may hold a
//   secret
//   provider lane `provider`: a sign-in that asks another system; as `secret` otherwise
enum class Weight : std::uint8_t { stored, light, staged, command, arming, bulk, setup, heavy, secret, provider };
constexpr bool opens_session(Weight weight) { return weight == Weight::secret || weight == Weight::provider; }

// What a body may carry: a document, a text in one, or the bytes of a file, which the handler reads in pieces.
enum class Carries : std::uint8_t { document, text, file };

// What a route takes besides its path and body: a page of a list, or the revision that is changed.
enum class Takes : std::uint8_t { no_more, page, if_match };

// What a request's body carries: a schema of server/json. No default, here and in Gives: a row without is no row.
struct Body {
  constexpr Body(std::string_view of, bool is_needed) : schema(of), needed(is_needed) {}
  std::string_view schema;  // "" takes none
  bool needed;              // an empty one is none
};
inline constexpr Body kNoBody{"", false};
inline constexpr Body kFile{"", true};      // of a route that carries one
inline constexpr Body kAnyFile{"", false};  // also one without a byte
constexpr Body body(std::string_view schema) { return {schema, true}; }
constexpr Body optional_body(std::string_view schema) { return {schema, false}; }

// What an answer carries that is no problem.
struct Gives {
  constexpr Gives(unsigned code, std::string_view of, bool is_page, std::string_view others)
      : status(code), schema(of), page(is_page), types(others) {}
  unsigned status;
  std::string_view schema;        // "" no JSON
  bool page;                      // the schema's things on a page
  std::string_view types;         // other content types, with blanks between
  std::string_view headers = "";  // what it always has besides Location with 201, with blanks between
  [[nodiscard]] constexpr Gives with(std::string_view names) const {
    Gives more = *this;
    more.headers = names;
    return more;
  }
};
constexpr Gives gives(std::string_view schema, std::string_view types = "") { return {200, schema, false, types}; }
constexpr Gives lists(std::string_view schema) { return {200, schema, true, ""}; }
constexpr Gives creates(std::string_view schema) { return {201, schema, false, ""}; }
inline constexpr Gives kGivesNothing{204, "", false, ""};

class Api;  // what handlers work with: the application and who calls

// Values of the pattern's {names}, in their order.
using Parameters = std::span<const std::string>;

// Runs the last step of a change as one transaction with its kept answer.
using Commit = std::function<Response(const std::function<Response()>&)>;

struct Caller;

struct Call {
  Api& api;
  const Request& request;
  Parameters parameters;
  std::string_view user;
  Right right;
  const Caller* caller = nullptr;                       // nullptr where no token is needed
  const Commit* once = nullptr;                         // for commit(); nullptr: it is no step of its own
  std::optional<std::uint64_t> version = std::nullopt;  // of the store when the request came; nothing: not known

  // For a `staged` or `bulk` route: its last step. A `light` one stands in it as a whole.
  [[nodiscard]] Response commit(const std::function<Response()>& step) const { return once ? (*once)(step) : step(); }
};
using Handler = Response (*)(const Call&);

struct Route {
  Method method;
  std::string_view pattern;  // "/api/v1/jobs/{id}/arm"
  Right right;
  Weight weight;
  Handler handler;
  std::string_view summary;  // one line for openapi.json
  Body body;
  Gives answer;
  Takes takes = Takes::no_more;
  std::string_view query = {};  // names of its query parameters, with blanks between; a page's own are not among them
  Carries carries = Carries::document;
};

struct Match {
  const Route* route = nullptr;  // nullptr: no such path (404) or, with `path_known`, no such method (405)
  bool path_known = false;
  std::vector<std::string> parameters;
  std::string allowed;  // without a route: the methods of this path, "GET, POST"
};

// A name as one segment of a path, for Location.
std::string escape_segment(std::string_view name);

// Words with blanks between.
std::vector<std::string_view> words_in(std::string_view list);
// The names in Route::query, the types in Gives::types.
std::vector<std::string_view> own_query(const Route& route);
std::vector<std::string_view> other_types(const Route& route);
// The first query parameter of the request that the route does not take; "" when there is none.
std::string_view unknown_query(const Route& route, const Request& request);
// What it takes, for people: "limit, after, machine" or "none".
std::string query_names(const Route& route);

Match find_route(std::span<const Route> routes, const Request& request);

}  // namespace dripfeed::http

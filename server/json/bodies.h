// How a request's body is read and described by one function (see object_reader.h). Only files of this folder include
// this.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "server/json/object_reader.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

inline constexpr std::int64_t kMaxId = std::int64_t{1} << 53U;  // what JavaScript keeps exactly

template <class Body>
app::Result<Body> read_by(void (*read)(ObjectReader&, Body&), std::string_view body) {
  Body into;
  const auto done = read_object(body, "request", [&](ObjectReader& o) { read(o, into); });
  if (!done) return std::unexpected(done.error());
  return into;
}

// The member `end_check` of a job or a profile: what a person confirms after a job (orders.cpp).
void read_end_check(ObjectReader& o, std::string& into);

// An empty body is one without members.
inline std::string_view or_empty(std::string_view body) { return body.empty() ? "{}" : body; }

template <class Body>
NamedSchema described(std::string name, void (*read)(ObjectReader&, Body&), std::string about) {
  return {std::move(name), describe(std::move(about), [&](ObjectReader& o) {
            Body unused;
            read(o, unused);
          })};
}

}  // namespace dripfeed::json

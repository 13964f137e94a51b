// Builders of one line each.
#include "server/json/schema.h"

#include <iterator>
#include <utility>

namespace dripfeed::json {

namespace {

Schema of_kind(Schema::Kind kind, std::string about) {
  Schema schema;
  schema.kind = kind;
  schema.about = std::move(about);
  return schema;
}

Schema between(Schema schema, double least, double most) {
  schema.least = least;
  schema.most = most;
  return schema;
}

}  // namespace

Schema any(std::string about) { return of_kind(Schema::Kind::any, std::move(about)); }
Schema text(std::string about) { return of_kind(Schema::Kind::text, std::move(about)); }

Schema filled_text(std::string about) {
  Schema schema = text(std::move(about));
  schema.is_filled = true;
  return schema;
}
Schema text_or_number(std::string about) { return of_kind(Schema::Kind::text_or_number, std::move(about)); }

Schema one_of(std::span<const std::string_view> words, std::string about) {
  Schema schema = text(std::move(about));
  schema.words.assign(words.begin(), words.end());
  return schema;
}

Schema integer(std::string about) {
  Schema schema = of_kind(Schema::Kind::integer, std::move(about));
  schema.least = 0.0;
  return schema;
}
Schema integer(double least, double most, std::string about) { return between(integer(std::move(about)), least, most); }

Schema number(std::string about) { return of_kind(Schema::Kind::number, std::move(about)); }
Schema number(double least, double most, std::string about) { return between(number(std::move(about)), least, most); }

Schema flag(std::string about) { return of_kind(Schema::Kind::flag, std::move(about)); }
Schema time_ms(std::string about) { return integer(std::move(about) + "; milliseconds since 1970, UTC"); }

Schema object(std::string about, Members members) {
  Schema schema = of_kind(Schema::Kind::object, std::move(about));
  schema.members = std::move(members);
  return schema;
}

Schema list_of(Schema element, std::string about) {
  Schema schema = of_kind(Schema::Kind::list, std::move(about));
  schema.of.push_back(std::move(element));
  return schema;
}
Schema list_of(std::size_t length, Schema element, std::string about) {
  Schema schema = list_of(std::move(element), std::move(about));
  schema.length = length;
  return schema;
}

Schema map_of(Schema element, std::string about) {
  Schema schema = list_of(std::move(element), std::move(about));
  schema.kind = Schema::Kind::map;
  return schema;
}

Schema reference(std::string name) {
  Schema schema;
  schema.kind = Schema::Kind::reference;
  schema.name = std::move(name);
  return schema;
}

Schema or_null(Schema schema) {
  schema.may_be_null = true;
  return schema;
}

Schema closed_object(std::string about, Members members) {
  for (Member& member : members) {
    if (member.presence == Presence::optional) member.schema.may_be_null = true;
  }
  Schema schema = object(std::move(about), std::move(members));
  schema.is_closed = true;
  return schema;
}

Members operator+(Members first, Members more) {
  first.insert(first.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  return first;
}

}  // namespace dripfeed::json

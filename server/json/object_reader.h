// Reads the members of one JSON object with everything that can be wrong about them: missing, of the wrong type, out of
// range, unknown. Faults are collected with their pointers, so that one reading finds all. The same functions describe
// what they read: a reader that is made to describe notes each member that it is asked for, and gives none, so that a
// schema cannot differ from its reading. Only files of this folder and of server/lsp include this.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"
#include "server/json/parse.h"
#include "server/json/schema.h"

namespace dripfeed::json {

class ObjectReader {
 public:
  ObjectReader(const Document& object, std::string pointer, std::vector<app::ErrorPlace>& faults);
  // Describes: notes the members that it is asked for in `into`, and no faults.
  ObjectReader(Members& into, std::vector<app::ErrorPlace>& unused);

  // Each names a member once. The value stays as it was when the member is not there or wrong.
  void text(std::string_view name, std::string& into, bool required = false);
  // A text in which a person states something: blanks alone state nothing.
  void words(std::string_view name, std::string& into, bool required = false);
  // A text that names a thing: the rule of app::why_no_name. An empty one stands for none where it is not required.
  void proper_name(std::string_view name, std::string& into, bool required = true);
  void flag(std::string_view name, bool& into);
  void number(std::string_view name, double& into, double low, double high, bool required = false);
  void number(std::string_view name, std::optional<double>& into, double low, double high);
  template <class Integer>
  void integer(std::string_view name, Integer& into, std::int64_t low, std::int64_t high, bool required = false) {
    if (const auto value = integer_at(name, low, high, required)) into = static_cast<Integer>(*value);
  }
  template <class Integer>
  void integer(std::string_view name, std::optional<Integer>& into, std::int64_t low, std::int64_t high) {
    if (const auto value = integer_at(name, low, high, false)) into = static_cast<Integer>(*value);
  }
  // A word out of a list; its index.
  std::optional<std::size_t> choice(std::string_view name, std::span<const std::string_view> words,
                                    bool required = false);
  // `read` gets a reader of the member's object / of each object of the member's array.
  void object(std::string_view name, const std::function<void(ObjectReader&)>& read, bool required = false);
  void objects(std::string_view name, const std::function<void(ObjectReader&)>& read, bool required = false);
  // The raw member, for what has a form of its own, with the shape that the caller will ask of it; nullptr when it is
  // not there.
  const Document* member(std::string_view name, const Schema& shape, bool required = false);

  void fault(std::string_view name, std::string text);
  // Every member that was not asked for is a fault. Call it last.
  void finish();
  // A null counts as not there. Who describes has nothing.
  [[nodiscard]] bool has(std::string_view name) const;

 private:
  // Notes it where this describes; nothing is there then.
  bool describes(std::string_view name, const Schema& shape, bool required);
  const Document* find(std::string_view name, bool required);
  std::optional<std::int64_t> integer_at(std::string_view name, std::int64_t low, std::int64_t high, bool required);
  std::optional<double> number_at(std::string_view name, double low, double high, bool required);

  const Document& object_;
  std::string pointer_;
  std::vector<app::ErrorPlace>& faults_;
  std::set<std::string, std::less<>> asked_;
  Members* described_ = nullptr;
};

// Reads a whole document as an object by `read`; all faults in one error.
app::Result<void> read_object(std::string_view text, std::string_view what,
                              const std::function<void(ObjectReader&)>& read);
// What `read` would take, as a request's schema.
Schema describe(std::string about, const std::function<void(ObjectReader&)>& read);

}  // namespace dripfeed::json

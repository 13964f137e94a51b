// Writes XML: elements, attributes and text, with what has a meaning escaped and what no document may have replaced.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dripfeed::json {

class Xml {
 public:
  struct Attribute {
    std::string_view name;
    std::string value;
  };
  using Attributes = std::initializer_list<Attribute>;

  void open(std::string_view element, Attributes attributes = {});
  void close();
  // An element with a text, or without anything in it.
  void leaf(std::string_view element, Attributes attributes = {}, std::string_view text = {});
  // The document; all that is open is closed.
  std::string take();

 private:
  void begin(std::string_view element, Attributes attributes);

  std::string out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  std::vector<std::string> open_;
};

}  // namespace dripfeed::json

// Names of machines and texts of links come from people and devices: any bytes may be in them.
#include "server/json/xml.h"

namespace dripfeed::json {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// How many bytes the character at the front has; 0: they are no UTF-8, or no character of XML 1.0.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  char32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_none = code < kLeast[length] || (code >= 0xD800 && code <= 0xDFFF) || code > 0x10FFFF ||
                       code == 0xFFFE || code == 0xFFFF;
  return is_none ? 0 : length;
}

void escape(std::string_view text, std::string& out) {
  constexpr std::pair<char, std::string_view> kMeant[] = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\t', "&#9;"}, {'\n', "&#10;"}, {'\r', "&#13;"}};
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const auto* meant = std::begin(kMeant);
    while (meant != std::end(kMeant) && meant->first != text.front()) ++meant;
    if (length == 0) {
      out += kReplacement;
    } else if (meant != std::end(kMeant)) {
      out += meant->second;
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
}

}  // namespace

void Xml::begin(std::string_view element, Attributes attributes) {
  out_.append(2 * open_.size(), ' ');
  out_ += '<';
  out_ += element;
  for (const Attribute& attribute : attributes) {
    out_ += ' ';
    out_ += attribute.name;
    out_ += "=\"";
    escape(attribute.value, out_);
    out_ += '"';
  }
}

void Xml::open(std::string_view element, Attributes attributes) {
  begin(element, attributes);
  out_ += ">\n";
  open_.emplace_back(element);
}

void Xml::close() {
  const std::string element = std::move(open_.back());
  open_.pop_back();
  out_.append(2 * open_.size(), ' ');
  out_ += "</" + element + ">\n";
}

void Xml::leaf(std::string_view element, Attributes attributes, std::string_view text) {
  begin(element, attributes);
  if (text.empty()) {
    out_ += "/>\n";
    return;
  }
  out_ += '>';
  escape(text, out_);
  out_ += "</";
  out_ += element;
  out_ += ">\n";
}

std::string Xml::take() {
  while (!open_.empty()) close();
  return std::move(out_);
}

}  // namespace dripfeed::json

// Names and texts of a proposed family, made from what a program calls things.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace dripfeed::compile {

// A text in quotes of the family language: one line, no quotes in it, and '?' for what is not UTF-8.
std::string quoted_text(std::string_view text);
// "roll-2" of "/parts/Roll 2.nc": a family's name.
std::string proposed_family_name(std::string_view path);

class ProposedNames {
 public:
  // A name of the family language that was not given before: of the first words of `text`, else of `fallback`.
  std::string name_for(std::string_view text, std::string_view fallback);

 private:
  std::set<std::string> taken_;
};

}  // namespace dripfeed::compile

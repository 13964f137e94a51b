// A folder's files by the names of the programs in them: whatever the case, with the usual endings, and as the
// SINUMERIK itself names its files (_N_SHAFT_SPF).
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace dripfeed::cli {

class ProgramFolder {
 public:
  // Reads the names of its files, once. Empty where the folder cannot be read.
  explicit ProgramFolder(const std::string& path);
  // The path of the program's file; "" where the folder has none.
  [[nodiscard]] std::string find(std::string_view name) const;

 private:
  std::map<std::string, std::string> files_;  // by name in small letters; of two that differ in the case the first
};

}  // namespace dripfeed::cli

// Some lines of a stored program, each next to the line of the family that it was rendered from and the values of the
// variables there. The cost is that of the lines that are given: where they begin is known from an index that is made
// once for a text, and places are found by halving. What was not stored is not there; nothing is guessed.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "server/app/base/error.h"
#include "store/store.h"

namespace dripfeed::app {

struct ProgramLine {
  std::uint64_t line = 0;  // 1-based count of EOBs
  std::string text;        // without its EOB; one of more than 4096 bytes is cut and ends with " …"
  std::optional<std::uint64_t> family_line;
  std::optional<std::string> family_text;
  std::optional<std::map<std::string, double>> values;  // by the family's names, in stored units
};

struct ProgramLines {
  std::uint64_t count_all = 0;
  std::vector<ProgramLine> lines;
};

class LineReading {
 public:
  static constexpr std::uint32_t kMost = 200;

  explicit LineReading(store::Store& store) : store_(store) {}
  // `from` is 1-based; fewer than `count`, or none, where the text ends. Errors: those of the store.
  Result<ProgramLines> lines(const store::ProgramRevision& revision, std::uint64_t from, std::uint32_t count);

 private:
  // Where every so-many bytes a line begins.
  struct Index {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> marks;  // line, offset of its first byte
    std::uint64_t lines = 0;
  };
  using IndexPtr = std::shared_ptr<const Index>;
  Result<IndexPtr> index_of(const std::string& sha256);
  Result<void> add_texts(const std::string& sha256, const Index& index, std::uint64_t from, std::uint32_t count,
                         std::vector<ProgramLine>& lines);
  Result<void> add_places(const store::ProgramRevision& revision, std::vector<ProgramLine>& lines);
  void add_family(const store::Origin& origin, std::vector<ProgramLine>& lines);

  static constexpr std::size_t kKept = 8;  // indexes: of a text of 60 MB some 16 KB
  store::Store& store_;
  std::mutex mutex_;
  std::vector<std::pair<std::string, IndexPtr>> kept_;  // newest last
};

}  // namespace dripfeed::app

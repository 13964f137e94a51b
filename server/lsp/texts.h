// The texts that the client has open, each with what was read of it. A text is read when an answer needs it, once a
// version.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/outline.h"
#include "dialects/compile/dialect/word_index.h"
#include "server/app/checks/examine.h"
#include "server/lsp/positions.h"
#include "server/lsp/surroundings.h"

namespace dripfeed::lsp {

struct Reading {
  Language language;
  app::CheckReport report;  // of reading and validating; of the whole check where the text was run
  ir::ReadResult read;
  compile::WordIndex words;
  bool is_family = false;  // `report` has its diagnostics alone
};

// A piece of a text that the client replaced; without a range the whole of it.
struct Change {
  std::optional<Range> range;
  std::string text;
};

class OpenText {
 public:
  OpenText(std::string uri, std::int64_t version, std::string text);

  [[nodiscard]] const std::string& uri() const { return uri_; }
  [[nodiscard]] const std::string& path() const { return path_; }  // "" where it is not a file
  [[nodiscard]] std::int64_t version() const { return version_; }
  [[nodiscard]] const text::Source& source() const { return source_; }
  [[nodiscard]] const Lines& lines() const { return lines_; }

  void change(std::int64_t version, const std::vector<Change>& changes, PositionUnit unit);
  // Another control may be meant now.
  void forget_reading() { reading_.reset(); }

  // Errors: as Surroundings::choose_language.
  app::Result<const Reading*> reading(const Settings& settings, const Surroundings& around);
  // The report of reading it and running it. Errors: as above.
  app::Result<app::CheckReport> examined(const Settings& settings, const Surroundings& around,
                                         const std::function<std::string()>& used_up);

  // What the client has not been sent yet.
  bool wants_diagnostics = true;
  bool wants_run = true;  // it was opened or saved as it stands

 private:
  void set_text(std::string text);

  std::string uri_;
  std::string path_;
  std::int64_t version_;
  text::Source source_;
  Lines lines_;
  std::unique_ptr<Reading> reading_;
};

}  // namespace dripfeed::lsp

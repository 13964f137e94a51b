// Whether the text can be cut before a line: what follows must find its labels and the ends of its loops without what
// is left out, and the head of the text must be one that can be kept.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/ir/program.h"

namespace dripfeed::compile {

class RestartPlaces {
 public:
  explicit RestartPlaces(const ir::Program& program);

  // Why the text cannot be cut before that line, "" when it can; "the text has no block in this line".
  [[nodiscard]] std::string why_not(std::uint32_t line) const;
  // First statement of the main program in that line; ir::kNoIndex: none that does anything.
  [[nodiscard]] std::uint32_t statement_at(std::uint32_t line) const;
  // Lines that stand before the preamble: the frame and title, and before `line` what declares names.
  [[nodiscard]] std::vector<std::uint32_t> head_lines(std::uint32_t line) const;
  // The statements of the main program.
  [[nodiscard]] const ir::Section& main() const { return main_; }

 private:
  [[nodiscard]] std::string why_no_restart_at_all() const;
  [[nodiscard]] std::string why_inside(std::uint32_t statement) const;
  [[nodiscard]] std::string why_leads_back(std::uint32_t statement) const;
  [[nodiscard]] bool has_label(std::uint32_t from, ir::StringId name, std::uint32_t number) const;
  [[nodiscard]] bool block_leads_back(const ir::Block& block, std::uint32_t from) const;

  const ir::Program& program_;
  ir::Section main_;
  std::uint32_t title_end_ = 0;  // first statement that does something
  std::string never_;            // why no line of it can be restarted at
};

}  // namespace dripfeed::compile

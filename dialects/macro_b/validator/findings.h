// What the checks of a program share: where their findings go, the programs that one text holds, and questions that
// several checks ask of a block.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// Collects diagnostics with the control's alarms. A fault that stands in every block is reported kMostOfOneId times.
class Findings {
 public:
  static constexpr std::uint32_t kMostOfOneId = 100;
  explicit Findings(const ir::Control& control) : control_(control) {}

  // nullptr when there are enough of that id; valid until the next call.
  text::Diagnostic* add(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments = {},
                        ir::AlarmDetail detail = ir::AlarmDetail::none);
  // An error where the control has an alarm for that detail, otherwise a warning without one.
  text::Diagnostic* add_own(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments,
                            ir::AlarmDetail detail);
  // For what the machine decides: an error on a named machine that leaves it open, nothing where the machine
  // has confirmed it.
  text::Diagnostic* add_open(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments,
                             bool confirmed);
  // A variable that the usual ranges do not have: an error where no such control has it, otherwise a warning that names
  // what would settle it, once a number.
  void add_variable(std::uint32_t number, text::Span span);
  // In the order of the text.
  std::vector<text::Diagnostic> take();

 private:
  const ir::Control& control_;
  std::vector<text::Diagnostic> diagnostics_;
  std::unordered_set<std::uint32_t> options_reported_;
  std::array<std::uint16_t, static_cast<std::size_t>(text::DiagnosticId::count_)> counts_{};
};

// One program of the text: statements [first, last).
struct Section {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  text::Span number;  // of its O number or name; empty when it has none
  // It ends by M99 and not by M30 or M02: what is active at its start is its caller's.
  bool is_subprogram = false;
};
std::vector<Section> sections_of(const ir::Program& program);

bool is_end_of_program(ir::StatementKind kind);
// &F=/USER/ of a memory dump: no part of a program.
bool is_folder_line(const ir::Program& program, const ir::Statement& statement);
// The name of a Native statement, "" for others.
std::string_view native_name(const ir::Program& program, const ir::Statement& statement);
bool is_axis(const ir::Control& control, ir::Address address);
std::string_view text_of(const ir::Program& program, text::Span span);

// Which labels of a section are entries: those that a jump goes to. After a computed jump, or where other blocks name
// block numbers (G71 P Q, M99 P of a called program), every label is.
class Entries {
 public:
  Entries(const ir::Program& program, const Section& section);
  [[nodiscard]] bool at(std::uint32_t statement) const;
  // Whether blocks other than jumps name block numbers.
  [[nodiscard]] bool blocks_are_named() const { return names_blocks_; }

 private:
  const ir::Program& program_;
  std::unordered_set<std::uint32_t> targets_;
  bool computed_ = false;
  bool names_blocks_ = false;
};

// Labels of a section by number; the first of a number is the one that is found from the top.
class LabelIndex {
 public:
  LabelIndex(const ir::Program& program, const Section& section);
  // From the statement to the section's end, then from its top; nullptr when there is none.
  [[nodiscard]] const ir::Label* find(std::uint32_t number, std::uint32_t from_statement) const;
  // Another label of the same number in the section; nullptr when it is the only one.
  [[nodiscard]] const ir::Label* other(const ir::Label& label) const;

 private:
  std::vector<ir::Label> labels_;  // by number, then statement
};

}  // namespace dripfeed::macro_b

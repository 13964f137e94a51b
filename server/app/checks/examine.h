// Examining a text: read, validate, run, and give what it does to every check that has what it needs. The same for the
// command, for the REST API and for releases.
#pragma once

#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/library.h"
#include "dialects/compile/render/render.h"
#include "dialects/compile/translate/thin_program.h"
#include "server/app/base/report.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

// The timing of a whole program, for advice and a curve: see timing::Settings.
struct TimingWishes {
  bool keep_whole = false;
  bool wants_curve = false;
  unsigned threads = 1;
};

struct Examination {
  text::Source source;
  const compile::Dialect* dialect = nullptr;
  ir::Control control;
  bool inferred = false;
  const machine::Profile* profile =
      nullptr;  // without one, what needs the machine is not checked, and the report states that
  ir::Delivery delivery = ir::Delivery::memory;
  compile::FindText find_called;                 // may be empty
  std::optional<family::Geometry> geometry;      // stock and nominal, of a rendered program
  std::vector<family::LineRange> profile_lines;  // the moves that make the nominal; empty: every cut
  TimingWishes timing = {};
  std::function<std::string()> used_up = {};  // a budget of the caller's: see interpreter::RunOptions
  std::vector<std::string> assumed = {};      // what was taken on a person's word: it stands among what was not checked
};

CheckReport examine(const Examination& examination);

// A check goes on with what was not given (common variables, arguments of a macro that is checked by itself, inputs, a
// called program) as not known, and never takes it for vacant.
ir::Control for_check(const ir::Control& given);

// Reads, validates and runs a text as a check does, and hands its motions to `sink` alone: what the machine would make
// of them is not checked, so that there is no verdict.
struct Followed {
  struct Run {
    std::vector<bool> is_elsewhere;    // by ir::Place::program: its lines are of another text
    std::vector<std::string> strings;  // by ir::Motion::text
    [[nodiscard]] bool is_of_other(std::uint32_t program) const {
      return program < is_elsewhere.size() && is_elsewhere[program];
    }
  };
  CheckReport report;
  Run run;
};
Followed follow(const Examination& examination, ir::MotionSink& sink);

// What reading and validating alone say; nothing is run, so that there is no verdict.
struct TextReading {
  CheckReport report;
  ir::ReadResult read;
  bool readable = false;  // without an error that keeps it from being run
};
// `thin`: of the same text, which is then not read again: `read` stays empty.
TextReading read_text(const Examination& examination, const compile::ThinProgram* thin = nullptr);

// How `text` is timed on the machine of e.profile, which must be named. Errors: the link's URL.
std::expected<timing::Settings, std::string> timing_settings(const Examination& e, std::string_view text);

// Of a timing: about 150 bytes each, within what a text of that size may take.
constexpr std::size_t most_kept_motions(std::size_t text_bytes) { return 1'000'000 + text_bytes / 8; }

// Bytes on the wire of each line, its EOB as the machine has it and the blank that a TV check may ask for; line 1
// first.
std::vector<std::uint32_t> bytes_of_lines(std::string_view text, const tape_code::WireFormat& format);

}  // namespace dripfeed::app

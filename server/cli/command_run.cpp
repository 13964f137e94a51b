// dripfeed run: interprets a program; prints its canonical motions, or the plain blocks that it comes to in its own
// dialect.
#include <charconv>
#include <memory>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/dialect/readers.h"
#include "dialects/compile/dialect/stream.h"
#include "dialects/compile/translate/convert.h"
#include "dialects/text/excerpt.h"
#include "dialects/text/fold.h"
#include "server/app/base/check_budget.h"
#include "server/cli/called_programs.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/inputs.h"
#include "server/cli/output.h"
#include "server/cli/program_file.h"
#include "server/cli/state_file.h"

namespace dripfeed::cli {

namespace {

struct RunOptions {
  TextOptions text;
  std::string file;
  std::string trace = "motions";
  std::string state;
  std::vector<std::string> limits;
  std::vector<std::uint32_t> skips;
  std::uint32_t seconds = 0;
};

// --limit blocks=n, loops=n, calls=n, motions=n
app::Result<interpreter::Limits> read_limits(const std::vector<std::string>& given) {
  interpreter::Limits limits;
  for (const std::string& limit : given) {
    const std::size_t equals = limit.find('=');
    const std::string name = limit.substr(0, equals);
    const std::string_view value =
        equals == std::string::npos ? std::string_view() : std::string_view(limit).substr(equals + 1);
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    const bool fine = error == std::errc{} && end == value.data() + value.size() && number > 0;
    if (fine && name == "blocks") {
      limits.blocks = number;
    } else if (fine && name == "loops") {
      limits.loop_passes = number;
    } else if (fine && name == "motions") {
      limits.motions = number;
    } else if (fine && name == "calls" && number <= UINT32_MAX) {
      limits.call_depth = static_cast<std::uint32_t>(number);
    } else {
      return app::fail(app::ErrorCode::invalid,
                       fmt::format("--limit \"{}\": use blocks=N, loops=N, calls=N or motions=N", limit));
    }
  }
  return limits;
}

// One of a called program: its text is not at hand here.
void print_elsewhere(const interpreter::RunDiagnostic& one, const std::vector<std::string>& programs) {
  const std::string& name = programs[one.program];
  fmt::print(stderr, "{}:{}: {}[{}]: {}{}\n", name, one.line, text::name_of(one.diagnostic.severity),
             text::row_of(one.diagnostic.id).name, text::message_of(one.diagnostic),
             one.diagnostic.alarm.empty() ? "" : fmt::format(" (alarm {})", one.diagnostic.alarm));
  for (const text::DiagnosticNote& note : one.diagnostic.notes)
    fmt::print(stderr, "{}:{}: note: {}\n", name, one.line, note.text);
}

// `print_main` prints a diagnostic of the main program.
template <class PrintMain>
int report_run(const interpreter::RunResult& result, std::string_view name, PrintMain print_main) {
  text::DiagnosticFold fold;
  for (const interpreter::RunDiagnostic& one : result.diagnostics) {
    if (!fold.shows(one.diagnostic)) continue;
    if (one.program == 0)
      print_main(one);
    else
      print_elsewhere(one, result.programs);
  }
  print_folded(fold, name);
  for (const interpreter::NotInterpreted& one : result.not_interpreted)
    if (!one.effects_known)
      fmt::print(stderr, "{}:{}: {}: {}\n", one.program == 0 ? name : result.programs[one.program], one.first_line,
                 one.is_input ? "input not known" : "not interpreted", text::shortened(one.name));
  return result.ended == interpreter::Ended::end ? kDone : kFailed;
}

int print_blocks(const RunOptions& options, const text::Source& source, const ChosenControl& chosen) {
  compile::ProgramLibrary library(chosen.control, find_in(folders_for(options.text, options.file)));
  const compile::ConvertResult converted = compile::convert({.source = source,
                                                             .from = chosen.control,
                                                             .to = chosen.control,
                                                             .mode = compile::ConvertMode::explicit_blocks,
                                                             .library = &library});
  print_diagnostics(converted.diagnostics, source, chosen.control.title);
  if (text::has_error(converted.diagnostics)) return kFailed;
  return write_output(options.text.output, converted.text) ? kDone : kWrongUse;
}

// Where the motions of a run go, and what is printed of them.
class Output {
 public:
  Output(const RunOptions& options, const ir::Control& control, interpreter::RunNames& names)
      : options_(options),
        traces_(options.trace == "motions" && !options.text.json),
        writer_(control, names, [this](std::string_view text) { take(text); }) {}

  ir::MotionSink& sink() { return traces_ ? static_cast<ir::MotionSink&>(writer_) : no_motions_; }
  // False, with a message, when it could not be written.
  bool finish(const interpreter::RunResult& result) {
    if (traces_ && !options_.text.output.empty()) written_ = write_output(options_.text.output, kept_);
    if (options_.text.json) written_ = write_output(options_.text.output, run_document(result));
    return written_;
  }

 private:
  void take(std::string_view text) {
    if (options_.text.output.empty())
      written_ = written_ && std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    else
      kept_ += text;
  }

  const RunOptions& options_;
  bool traces_;
  bool written_ = true;
  std::string kept_;
  compile::NoMotions no_motions_;
  interpreter::TraceWriter writer_;
};

int interpret(const RunOptions& options, interpreter::RunOptions run, const text::Source& source,
              const ChosenControl& chosen) {
  const ir::ReadResult read = chosen.dialect->read(source, chosen.control);
  print_diagnostics(read.diagnostics, source, chosen.control.title);
  if (text::has_error(read.diagnostics)) return kFailed;

  compile::ProgramLibrary library(chosen.control, find_in(folders_for(options.text, options.file)));
  interpreter::RunNames names;
  run.names = &names;
  Output output(options, chosen.control, names);
  const interpreter::RunResult result = compile::execute(read.program, chosen.control, &library, output.sink(), run);
  const bool written = output.finish(result);
  const int code = report_run(result, source.name(), [&](const interpreter::RunDiagnostic& one) {
    print_diagnostics({one.diagnostic}, source, chosen.control.title);
  });
  return written ? code : kWrongUse;
}

// A diagnostic of a text that was not kept: its line is read once more.
void print_from_file(const interpreter::RunDiagnostic& one, ProgramFile& file, const std::string& name,
                     std::string_view control) {
  const auto line = file.line_at(one.diagnostic.span.begin);
  if (!line) return print_error(line.error());
  const text::Position position{.line = one.line, .column = static_cast<std::uint32_t>(line->before + 1)};
  fmt::print(stderr, "{}", text::format_diagnostic_at(one.diagnostic, name, position, line->text, control));
  print_help(one.diagnostic.id);
}

// The program while it is read.
int interpret_stream(const RunOptions& options, interpreter::RunOptions run, ProgramFile& file,
                     const ChosenControl& chosen) {
  compile::ProgramLibrary library(chosen.control, find_in(folders_for(options.text, options.file)));
  interpreter::RunNames names;
  run.names = &names;
  Output output(options, chosen.control, names);
  const compile::StreamRun ran =
      compile::execute_stream(file, options.file, *chosen.dialect, chosen.control, &library, output.sink(), run);
  if (!ran.read_error.empty()) {
    print_error(ran.read_error);
    return kWrongUse;
  }
  if (ran.source) print_diagnostics(ran.diagnostics, *ran.source, chosen.control.title);
  if (text::has_error(ran.diagnostics)) return kFailed;
  const bool written = output.finish(ran.result);
  const int code = report_run(ran.result, options.file, [&](const interpreter::RunDiagnostic& one) {
    print_from_file(one, file, options.file, chosen.control.title);
  });
  return written ? code : kWrongUse;
}

// A language that is only read needs no machine's profile, and has no use for one.
app::Result<ChosenControl> control_to_run(const TextOptions& options, const text::Source& source) {
  const compile::Dialect* const reader = options.machine.empty() ? compile::find_reader(options.dialect) : nullptr;
  if (reader == nullptr || reader->print != nullptr) return choose_control(options, source);
  return ChosenControl{.dialect = reader, .control = reader->infer_control(source), .profile = {}, .inferred = false};
}

int run_source(const RunOptions& options, interpreter::RunOptions run) {
  const auto source = read_source(options.file);
  if (!source) {
    print_error(source.error());
    return kWrongUse;
  }
  const auto chosen = control_to_run(options.text, *source);
  if (!chosen) {
    print_error(chosen.error());
    return kWrongUse;
  }
  if (options.trace == "blocks" && chosen->dialect->print == nullptr) {
    print_error(fmt::format("--trace blocks: there is no writer for {}", chosen->dialect->title));
    return kWrongUse;
  }
  if (options.trace == "blocks") return print_blocks(options, *source, *chosen);
  return interpret(options, std::move(run), *source, *chosen);
}

int run_stream(const RunOptions& options, interpreter::RunOptions run, ProgramFile& file) {
  const auto head = file.head();
  const auto chosen =
      head ? control_to_run(options.text, *head) : app::Result<ChosenControl>(std::unexpected(head.error()));
  if (!chosen) {
    print_error(chosen.error());
    return kWrongUse;
  }
  return interpret_stream(options, std::move(run), file, *chosen);
}

int run_command(const RunOptions& options) {
  const auto limits = read_limits(options.limits);
  const auto state = read_state(options.state);
  for (const app::Error* error : {limits ? nullptr : &limits.error(), state ? nullptr : &state.error()}) {
    if (error == nullptr) continue;
    print_error(*error);
    return kWrongUse;
  }
  interpreter::RunOptions run;
  run.limits = *limits;
  for (const std::uint32_t level : options.skips) run.skip_switches |= 1U << level;
  run.initial_values = *state;
  run.want_variables = options.text.json;
  run.used_up = app::time_budget(options.seconds);
  if (options.file == "-" || options.trace == "blocks") return run_source(options, std::move(run));
  const auto file = ProgramFile::open(options.file);
  if (!file) {
    print_error(file.error());
    return kWrongUse;
  }
  if ((*file)->size_bytes().value_or(0) <= kWholeBytes) return run_source(options, std::move(run));
  return run_stream(options, std::move(run), **file);
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("run", "interprets a program");
  const auto options = std::make_shared<RunOptions>();
  command->add_option("FILE", options->file, "program, - for standard input")->required();
  add_text_options(*command, options->text);
  command->add_option("--trace", options->trace, "what to print")
      ->check(CLI::IsMember({"motions", "blocks", "none"}))
      ->capture_default_str();
  command->add_option("--state", options->state,
                      "values before the start, a line each: #500=12.5, R5=1, INI[53]=2, $A_IN[1]=1");
  command->add_option("--skip", options->skips, "block skip switch N is on, 1 for \"/\" (may be repeated)")
      ->check(CLI::Range(1, 10));
  command->add_option("--limit", options->limits, "blocks=N, loops=N, calls=N or motions=N (may be repeated)");
  add_seconds(*command, options->seconds);
  command->callback([options, &exit_code] { exit_code = run_command(*options); });
}

}  // namespace dripfeed::cli

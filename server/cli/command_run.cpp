// dripfeed run: interprets a program; prints its canonical motions, or the plain blocks that it comes to in its own
// dialect.
#include <charconv>
#include <memory>

#include <fmt/format.h>

#include "dialects/compile/convert.h"
#include "dialects/compile/execute.h"
#include "server/cli/cli.h"
#include "server/cli/documents.h"
#include "server/cli/inputs.h"
#include "server/cli/output.h"
#include "server/cli/state_file.h"

namespace dripfeed::cli {

namespace {

struct Options {
  TextOptions text;
  std::string file;
  std::string trace = "motions";
  std::string state;
  std::vector<std::string> limits;
};

// --limit blocks=n, loops=n, calls=n
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
    } else if (fine && name == "calls" && number <= UINT32_MAX) {
      limits.call_depth = static_cast<std::uint32_t>(number);
    } else {
      return app::fail(app::ErrorCode::invalid, fmt::format("--limit \"{}\": use blocks=N, loops=N or calls=N", limit));
    }
  }
  return limits;
}

int report_run(const interpreter::RunResult& result, const ir::Program& program, const ir::Control& control) {
  for (const interpreter::RunDiagnostic& one : result.diagnostics) {
    if (one.program == 0) {
      print_diagnostics({one.diagnostic}, program.source, control.title);
    } else {
      fmt::print(stderr, "{}:{}: {}[{}]: {}{}\n", result.programs[one.program], one.line,
                 text::name_of(one.diagnostic.severity), text::row_of(one.diagnostic.id).name,
                 text::message_of(one.diagnostic),
                 one.diagnostic.alarm.empty() ? "" : fmt::format(" (alarm {})", one.diagnostic.alarm));
    }
  }
  for (const interpreter::NotInterpreted& one : result.not_interpreted) {
    if (!one.effects_known)
      fmt::print(stderr, "{}:{}: not interpreted: {}\n", program.source.name(), one.first_line, one.name);
  }
  return result.ended == interpreter::Ended::end ? kDone : kFailed;
}

int print_blocks(const Options& options, const text::Source& source, const ChosenControl& chosen) {
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

int interpret(const Options& options, const interpreter::RunOptions& run_options, const text::Source& source,
              const ChosenControl& chosen) {
  const ir::ReadResult read = chosen.dialect->read(source, chosen.control);
  print_diagnostics(read.diagnostics, source, chosen.control.title);
  if (text::has_error(read.diagnostics)) return kFailed;

  compile::ProgramLibrary library(chosen.control, find_in(folders_for(options.text, options.file)));
  interpreter::RunNames names;
  interpreter::RunOptions run = run_options;
  run.want_variables = options.text.json;
  run.names = &names;
  const bool traces = options.trace == "motions" && !options.text.json;
  std::string kept;
  bool written = true;
  interpreter::TraceWriter writer(chosen.control, names, [&](std::string_view text) {
    if (options.text.output.empty()) {
      written = written && std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    } else {
      kept += text;
    }
  });
  compile::NoMotions nobody;
  ir::MotionSink& sink = traces ? static_cast<ir::MotionSink&>(writer) : nobody;
  const interpreter::RunResult result = compile::execute(read.program, chosen.control, &library, sink, run);
  if (traces && !options.text.output.empty()) written = write_output(options.text.output, kept);
  if (options.text.json) written = write_output(options.text.output, run_document(result));
  const int code = report_run(result, read.program, chosen.control);
  return written ? code : kWrongUse;
}

int run_command(const Options& options) {
  const auto source = read_source(options.file);
  if (!source) {
    print_error(source.error());
    return kWrongUse;
  }
  const auto chosen = choose_control(options.text, *source);
  const auto limits = read_limits(options.limits);
  const auto state = read_state(options.state);
  for (const app::Error* error :
       {chosen ? nullptr : &chosen.error(), limits ? nullptr : &limits.error(), state ? nullptr : &state.error()}) {
    if (error == nullptr) continue;
    print_error(*error);
    return kWrongUse;
  }
  if (options.trace == "blocks") return print_blocks(options, *source, *chosen);
  interpreter::RunOptions run;
  run.limits = *limits;
  run.initial_values = *state;
  return interpret(options, run, *source, *chosen);
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("run", "interprets a program");
  const auto options = std::make_shared<Options>();
  command->add_option("FILE", options->file, "program, - for standard input")->required();
  add_text_options(*command, options->text);
  command->add_option("--trace", options->trace, "what to print")
      ->check(CLI::IsMember({"motions", "blocks", "none"}))
      ->capture_default_str();
  command->add_option("--state", options->state, "values of variables before the start, a line each: #500=12.5");
  command->add_option("--limit", options->limits, "blocks=N, loops=N or calls=N (may be repeated)");
  command->callback([options, &exit_code] { exit_code = run_command(*options); });
}

}  // namespace dripfeed::cli

// dripfeed lsp: the language server on standard input and output. It reads what has come, answers, and works on the
// texts while nothing comes.
#include <csignal>
#include <filesystem>
#include <memory>
#include <utility>

#include <CLI/CLI.hpp>
#include <poll.h>
#include <unistd.h>

#include "server/app/base/check_budget.h"
#include "server/cli/called_programs.h"
#include "server/cli/cli.h"
#include "server/cli/family_options.h"
#include "server/cli/inputs.h"
#include "server/cli/memory_budget.h"
#include "server/cli/output.h"
#include "server/lsp/file_uri.h"
#include "server/lsp/lsp.h"

namespace dripfeed::cli {

namespace {

constexpr int kAtOnce_ms = 0;
constexpr int kUntilInput_ms = -1;

// With paths that hold whatever folder a program is in.
TextOptions text_options(const lsp::Settings& settings) {
  TextOptions options{.machine = settings.machine,
                      .dialect = settings.dialect,
                      .control = settings.control,
                      .modes = settings.modes,
                      .paths = {},
                      .output = {}};
  for (const std::string& path : settings.paths) {
    std::error_code failed;
    options.paths.push_back(std::filesystem::absolute(path, failed).string());
  }
  return options;
}

app::Result<lsp::Language> choose_language(const lsp::Settings& settings, const text::Source& source) {
  auto chosen = choose_control(text_options(settings), source);
  if (!chosen) return std::unexpected(chosen.error());
  lsp::Language language{.dialect = chosen->dialect,
                         .control = std::move(chosen->control),
                         .profile = nullptr,
                         .inferred = chosen->inferred};
  if (chosen->profile) language.profile = std::make_shared<machine::Profile>(std::move(*chosen->profile));
  return language;
}

lsp::Surroundings surroundings() {
  return {.choose_language = choose_language,
          .find_called =
              [](const lsp::Settings& settings, const std::string& file) {
                return find_in(folders_for(text_options(settings), file.empty() ? "-" : file));
              },
          .is_family = is_family,
          .version = kVersion};
}

// The page of diagnostics in a tree of sources or next to the presets; "" where it is not there.
std::string docs_address() {
  for (const char* place : {"../docs/diagnostics.md", "docs/diagnostics.md"})
    if (const auto found = find_shared(place)) return lsp::file_uri(std::filesystem::absolute(*found).string());
  return {};
}

bool has_input(int wait_ms) {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  return ::poll(&input, 1, wait_ms) > 0;
}

bool write_all(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool write_output_of(lsp::Session& session) {
  for (const std::string& one : session.output())
    if (!write_all(lsp::framed(one))) return false;
  return true;
}

// False at the end of the input.
bool read_input(lsp::FrameReader& frames) {
  static constexpr std::size_t kPiece_bytes = std::size_t{64} << 10U;
  std::string piece(kPiece_bytes, '\0');
  const ssize_t count = ::read(STDIN_FILENO, piece.data(), piece.size());
  if (count < 0) return errno == EINTR;
  frames.add(std::string_view(piece).substr(0, static_cast<std::size_t>(count)));
  return count > 0;
}

int serve_editor(const lsp::Settings& settings) {
  std::signal(SIGPIPE, SIG_IGN);  // an editor that is gone is seen by what writing returns
  limit_memory(app::CheckBudget{}.memory_bytes, "dripfeed: the open programs need more memory than they may take\n",
               kWrongUse);
  lsp::Session session(surroundings(), settings);
  lsp::FrameReader frames;
  while (true) {
    while (const auto frame = frames.next()) {
      session.take(*frame);
      if (!write_output_of(session) || session.is_over()) return session.exit_code();
    }
    while (!has_input(kAtOnce_ms) && session.work([] { return has_input(kAtOnce_ms); }))
      if (!write_output_of(session)) return session.exit_code();
    if (has_input(kUntilInput_ms) && !read_input(frames)) return session.exit_code();
  }
}

}  // namespace

void add_lsp(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("lsp", "language server for editors, on standard input and output");
  const auto settings = std::make_shared<lsp::Settings>();
  command->add_option("--machine", settings->machine, "machine profile: a file or the name of a preset");
  command->add_option("--dialect", settings->dialect, "control language, when no machine is named");
  command->add_option("--control", settings->control, "what the machine decides: kind=lathe,g_system=A");
  command->add_option("--path", settings->paths, "folder with called programs (may be repeated)");
  command->add_option("--seconds", settings->seconds, "for running a program that was saved; 0: programs are only read")
      ->capture_default_str();
  command->footer(
      "An editor starts it; its own settings outrank these options (docs/editor.md).\n"
      "Exit: 0 the editor asked to shut down, 1 the input ended without that, 2 wrong use or no memory");
  command->callback([settings, &exit_code] {
    settings->docs = docs_address();
    const auto known = choose_language(*settings, text::Source());
    if (!known) {
      print_error(known.error());
      exit_code = kWrongUse;
      return;
    }
    exit_code = serve_editor(*settings);
  });
}

}  // namespace dripfeed::cli

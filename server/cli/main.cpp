// dripfeed: one binary, one table of commands.

#include <new>

#include <CLI/CLI.hpp>

#include "server/cli/cli.h"
#include "server/cli/output.h"

namespace {

using AddCommand = void (*)(CLI::App&, int&);
constexpr AddCommand kCommands[] = {
    dripfeed::cli::add_serve,       dripfeed::cli::add_check,      dripfeed::cli::add_run,
    dripfeed::cli::add_convert,     dripfeed::cli::add_render,     dripfeed::cli::add_time,
    dripfeed::cli::add_accuracy,    dripfeed::cli::add_calibrate,  dripfeed::cli::add_gouge,
    dripfeed::cli::add_send,        dripfeed::cli::add_simulate,   dripfeed::cli::add_token,
    dripfeed::cli::add_sweep,       dripfeed::cli::add_receive,    dripfeed::cli::add_link,
    dripfeed::cli::add_ledger,      dripfeed::cli::add_wrap,       dripfeed::cli::add_worker,
    dripfeed::cli::add_maintenance, dripfeed::cli::add_optimize,   dripfeed::cli::add_backup,
    dripfeed::cli::add_restore,     dripfeed::cli::add_doctor,     dripfeed::cli::add_compare,
    dripfeed::cli::add_openapi,     dripfeed::cli::add_completion, dripfeed::cli::add_man,
    dripfeed::cli::add_user,        dripfeed::cli::add_audit,      dripfeed::cli::add_explain,
    dripfeed::cli::add_words,       dripfeed::cli::add_restart,    dripfeed::cli::add_renumber,
    dripfeed::cli::add_lsp,         dripfeed::cli::add_import,     dripfeed::cli::add_export,
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Program distribution and DNC server for CNC machine tools", "dripfeed");
  app.set_version_flag("--version", dripfeed::cli::kVersion);
  app.require_subcommand(1);
  int exit_code = dripfeed::cli::kDone;
  for (const AddCommand add : kCommands) add(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const std::bad_alloc&) {
    dripfeed::cli::print_error("there is not enough memory for it");
    return dripfeed::cli::kWrongUse;
  } catch (const CLI::ParseError& error) {
    // Help and version end well; everything else is wrong use.
    return app.exit(error) == 0 ? dripfeed::cli::kDone : dripfeed::cli::kWrongUse;
  }
  return exit_code;
}

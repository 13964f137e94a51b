// server/cli: the dripfeed command. Each command has a file: it parses its arguments, makes the same call of the
// application as the REST handler, and prints. Texts go to standard output or --output, messages to standard error.
// Exit: 0 done (warnings allowed), 1 the verdict is fail, the program ended by an alarm or limit, or the transfer
// failed, 2 wrong use or I/O error, 3 a block is torn at the control, or may be: nothing may be sent on that line until
// a person confirms that the control was reset.
#pragma once

namespace CLI {
class App;  // included only where options are added: it takes seconds to compile
}

namespace dripfeed::cli {

inline constexpr const char* kVersion = "0.1.0";

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongUse = 2;
inline constexpr int kTorn = 3;
// For the help of commands that use a line.
inline constexpr const char* kExitCodes =
    "Exit: 0 done, 1 the transfer failed, 2 wrong use or I/O error, 3 a block is or may be torn at the control: "
    "nothing\n"
    "leaves on the line until --confirm-reset";
inline constexpr int kOverMemory = 77;  // of a worker alone

// Each adds its command to `app`; `exit_code` gets what the command ended with.
void add_serve(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_run(CLI::App& app, int& exit_code);
void add_convert(CLI::App& app, int& exit_code);
void add_restart(CLI::App& app, int& exit_code);
void add_renumber(CLI::App& app, int& exit_code);
void add_render(CLI::App& app, int& exit_code);
void add_time(CLI::App& app, int& exit_code);
void add_accuracy(CLI::App& app, int& exit_code);
void add_calibrate(CLI::App& app, int& exit_code);
void add_gouge(CLI::App& app, int& exit_code);
void add_sweep(CLI::App& app, int& exit_code);
void add_send(CLI::App& app, int& exit_code);
void add_receive(CLI::App& app, int& exit_code);
void add_simulate(CLI::App& app, int& exit_code);
void add_link(CLI::App& app, int& exit_code);
void add_backup(CLI::App& app, int& exit_code);
void add_restore(CLI::App& app, int& exit_code);
void add_import(CLI::App& app, int& exit_code);
void add_export(CLI::App& app, int& exit_code);
void add_doctor(CLI::App& app, int& exit_code);
void add_ledger(CLI::App& app, int& exit_code);
void add_token(CLI::App& app, int& exit_code);
void add_user(CLI::App& app, int& exit_code);
void add_audit(CLI::App& app, int& exit_code);
void add_openapi(CLI::App& app, int& exit_code);
void add_wrap(CLI::App& app, int& exit_code);
void add_optimize(CLI::App& app, int& exit_code);
void add_completion(CLI::App& app, int& exit_code);
void add_man(CLI::App& app, int& exit_code);
void add_explain(CLI::App& app, int& exit_code);
void add_words(CLI::App& app, int& exit_code);
void add_lsp(CLI::App& app, int& exit_code);
void add_maintenance(CLI::App& app, int& exit_code);
void add_worker(CLI::App& app, int& exit_code);

}  // namespace dripfeed::cli

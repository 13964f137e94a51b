// One row a sentence. A name in braces stands for what the code puts there: the shortest text up to what follows. The
// first row that fits counts, so the longer of two comes first. A test reads the code, and asks that each row is used
// there and that each sentence of an alarm has a row.
#include "server/json/sentences.h"

#include <array>

namespace dripfeed::json {

namespace {

struct Row {
  std::string_view id;
  std::string_view pattern;
};
constexpr std::array kRows = {
    // alarms
    Row{"control_asked_again",
        "the control asked for a program (DC1) while the feed was stopped: it may have been reset. The job cannot be "
        "resumed: cancel it"},
    Row{"nothing_leaves", "nothing leaves on its line: {why}"},
    Row{"link_down", "the link is down: {why}"},
    Row{"link_down_plain", "the link is down"},
    Row{"ledger_not_written", "the ledger cannot be written: {why}"},
    Row{"machine_alarm_at", "machine alarm {alarm} (program {program}, line {line})"},
    Row{"machine_alarm", "machine alarm {alarm}"},
    Row{"device_text", "the device server reports \"{text}\": that is not a program"},
    Row{"reception_lost", "a broken reception is lost: {why}"},
    Row{"program_lost", "a received program is lost: {why}"},
    Row{"in_quarantine", "what the control sent is in quarantine: {why}"},
    Row{"request_not_answered", "a request is not answered: {why}"},
    Row{"answer_hides", "no answer is sent: {name} is a released program; set receive.answer_number to a free number"},
    Row{"ring_not_recorded", "a ring is not recorded: {why}"},
    Row{"request_expired", "a request expired: its program was not fetched at the control"},
    Row{"answer_cannot", "the answer cannot be sent: {why}"},
    Row{"answer_not_sent", "the answer is not sent: {why}"},
    Row{"read_back_of", "read-back: {why}"},
    Row{"flooded",
        "the other side floods the line: more than {limit} bytes a second came. It is read in pieces, and nothing is "
        "sent until it was heard"},
    Row{"more_alarms", "more alarms of this kind came within a second than are listed one by one"},
    // the store
    Row{"no_maintenance", "this server does not look after its store"},
    Row{"maintenance_runs", "a backup or a verification runs: ask again when it has ended"},
    Row{"no_backup_of_database", "the store is in a PostgreSQL database: back it up with that server's own tools"},
    Row{"backup_no_room",
        "the disk of {folder} has {free} MB free; a backup needs {needed} MB and leaves {rest} MB free"},
    Row{"no_such_backup", "there is no backup {name}"},
    Row{"store_has_faults", "the store has {count} faults and no backup was made; the first: {subject}: {why}"},
    Row{"store_cannot_be_read", "the store cannot be read: {why}"},
    // receipts
    Row{"quarantine_not_compared", "a receipt in quarantine is not compared"},
    Row{"no_program_of_name", "no stored program has the name {name}"},
    Row{"not_rendered", "program {name} was not rendered from a family"},
    Row{"too_long_for_values", "the program is too long for its values to be looked for"},
    // lines
    Row{"block_torn_here", "a block broke off on this line"},
    Row{"line_tested", "the line is being tested by {name}"},
    Row{"line_no_characters", "the line of {machine} carries no characters"},
    Row{"line_confirm_first", "a person must first confirm that the control of {machine} was reset"},
    Row{"line_control_there", "the control of {machine} asks for a program: take its plug off the line first"},
    Row{"line_busy_settings",
        "the line of {machine} has a job or a torn block; its settings can be changed when that is over"},
    Row{"line_still_used", "the line of {machine} is still in use"},
    Row{"restart_is_sent_once", "a restart is sent once"},
    Row{"line_in_use", "the line of {machine} is in use"},
    Row{"no_line_because", "{machine} has no line: {why}"},
    Row{"line_elsewhere", "the line of {machine} is with node {node}: change it there"},
    Row{"only_server", "this server is the only one of its store"},
    Row{"no_line", "machine {machine} has no line"},
    Row{"too_fast", "the other side sends faster than it can be heard: nothing is armed until that ends"},
    Row{"control_sends", "the control sends a program"},
    Row{"torn_reset_first", "a transfer broke off here: confirm that the control was reset"},
    Row{"maybe_torn", "a block may be torn: reset the control and confirm that"},
    Row{"other_session", "the receiver has a session of another job: reset it and confirm that"},
    Row{"only_receives", "this line only receives"},
    Row{"job_on_line", "a job is on the line"},
    Row{"no_torn", "no torn block waits for a confirmation on this machine"},
    Row{"server_ends", "the server ends"},
    // how a job ended, and torn blocks
    Row{"reached_torn_because_lines",
        "{cause}: between wire byte {from} and {to} of {total} may have reached the control (line {first} to {last}); "
        "a block is torn: reset the control and confirm it; {why}"},
    Row{"reached_torn_lines",
        "{cause}: between wire byte {from} and {to} of {total} may have reached the control (line {first} to {last}); "
        "a block is torn: reset the control and confirm it"},
    Row{"reached_because_lines",
        "{cause}: between wire byte {from} and {to} of {total} may have reached the control (line {first} to {last}); "
        "{why}"},
    Row{"reached_lines",
        "{cause}: between wire byte {from} and {to} of {total} may have reached the control (line {first} to {last})"},
    Row{"reached_torn_because",
        "{cause}: between wire byte {from} and {to} of {total} may have reached the control; a block is torn: reset "
        "the control and confirm it; {why}"},
    Row{"reached_torn",
        "{cause}: between wire byte {from} and {to} of {total} may have reached the control; a block is torn: reset "
        "the control and confirm it"},
    Row{"reached_because", "{cause}: between wire byte {from} and {to} of {total} may have reached the control; {why}"},
    Row{"reached", "{cause}: between wire byte {from} and {to} of {total} may have reached the control"},
    Row{"nothing_sent_because", "{cause}: nothing was sent; {why}"},
    Row{"nothing_sent", "{cause}: nothing was sent"},
    Row{"disarmed", "disarmed, nothing was sent: {cause}"},
    Row{"answer_torn",
        "an answer to its operator broke off inside a block ({cause}): reset the control and confirm it"},
    Row{"answer_torn_plain", "an answer to its operator broke off inside a block ({cause})"},
    Row{"block_torn_confirm", "a block broke off on this line: reset the control and confirm it"},
    Row{"read_back_result", "job {job}: read-back {result}"},
    // refusals of a line, and its state
    Row{"no_effect", "the command has no effect in this state"},
    Row{"no_text", "the job has no text"},
    Row{"asked_again_restart",
        "the control asked for a program (DC1) while the feed was stopped: it may have been reset. Cancel the job; a "
        "restart is a new job"},
    // jobs
    Row{"cannot_arm", "{machine} cannot be armed: {why}"},
    Row{"stops_without_store", "{machine} stops at a block end, but the store does not answer: {why}"},
    Row{"folder_needs_memory", "machine {machine} fetches whole files from a folder: release the program for memory"},
    Row{"changed_after_verdict", "machine {machine} was changed after verdict {verdict}: check the text for it again"},
    Row{"job_not_on_line", "job {job} is not on the line of {machine}"},
    Row{"arming_time", "an arming lasts more than 0 and at most 60 minutes"},
    Row{"resume_reason", "a reason is needed to go on as if DC1 had come"},
    Row{"job_waits", "job {job} waits on the line: cancel it first"},
    Row{"nothing_waits", "nothing of {machine} waits for a confirmation"},
    Row{"job_holds_profile", "job {job} is on the line of {machine}"},
    Row{"withdrawn", "withdrawn: job {job} of the same choice was armed on {machine}"},
    Row{"early_by_approver", "a job is armed before its time by an approver"},
    Row{"none_of_group", "no machine of group {group} can take this program"},
    Row{"hook_refuses", "the system that is asked before an arming refuses: {why}"},
    Row{"hook_silent", "the system that is asked before an arming gives no answer: {why}"},
    Row{"admin_loads", "O8000 to O9999 are loaded by an admin"},
    Row{"disk_full_ends", "the disk is full: running work is finished, nothing new begins"},
    Row{"alarm_critical",
        "alarm {alarm} ({kind}) is critical: it may not be shelved; acknowledge it and end its cause"},
    Row{"reason_needed", "a reason is needed"},
    Row{"quarantine_reason", "a receipt in quarantine is taken for a program with a reason only"},
    Row{"receipt_unreadable", "nothing of it can be read: punch it again, or discard it"},
    Row{"approver_accepts", "a receipt in quarantine is accepted by an approver"},
    Row{"approver_needed", "this needs the role approver: a programmer hands a draft in for review"},
    Row{"text_empty", "the text is empty"},
    Row{"text_unreadable", "the stored text cannot be read"},
    Row{"keeps_name", "a machine keeps its name"},
    Row{"other_dialect", "program {program} is {dialect}, machine {machine} is {other}"},
    // requests and people
    Row{"needs_role", "this needs the role {role}; {name} has the role {has}"},
    Row{"sign_in", "sign in, or send a token"},
    Row{"token_scope", "this token may change: {scope}; this belongs to {group}"},
    Row{"page_shows_other", "you are signed in as {name}, the page shows {shown}: reload"},
    Row{"wrong_secret", "the name or the {kind} is wrong"},
    Row{"token_not_valid", "this token is not valid"},
    Row{"sign_in_other", "this browser did not begin this sign-in: begin it again"},
    Row{"sign_in_late", "this sign-in took too long: begin it again"},
    Row{"sign_in_used", "this sign-in was used before: begin it again"},
    Row{"no_provider", "no provider is configured here"},
    Row{"provider_silent", "the sign-in's provider gives no answer: {why}"},
    Row{"provider_unusable", "the sign-in's provider cannot be used: {why}"},
    Row{"provider_refuses", "the provider refuses the sign-in: {why}"},
    Row{"id_token_refused", "the provider's ID token is refused: {why}"},
    Row{"provider_no_name", "the provider gives no name that can be used here: it {why}"},
    Row{"provider_name_taken", "the name {name} belongs to another account here: an administrator decides"},
    Row{"provider_no_group", "no group of {name} at the provider gives a role here"},
    Row{"account_not_enabled", "the account {name} is not enabled: an administrator enables it"},
    Row{"account_locked", "the account {name} is locked: try again in {seconds} s"},
    Row{"too_many_wrong", "too many wrong ones: try again in {seconds} s"},
    Row{"present_password", "the present password is wrong"},
    Row{"secret_empty", "a secret must not be empty; DELETE takes it away"},
    Row{"own_admin", "an admin cannot remove their own role of admin: ask another admin"},
    Row{"being_answered", "a request with this key is being answered"},
    Row{"request_failed_inside", "the request failed inside the server"},
    Row{"body_too_long", "the body is too long for this path"},
    Row{"too_many_large", "too many large requests are being read: send this one again"},
    Row{"too_many_waiting", "too many requests of this kind are waiting: send this one again"},
    Row{"too_many_sign_ins",
        "too many sign-ins and changes of tokens or passwords from this address are waiting: send this one again"},
    Row{"watch_already", "{count} watch already: close a page that is not needed"},
    Row{"search_not_there", "programs cannot be searched: the log states why"},
    Row{"sweep_runs", "another sweep is running: ask again when it is done"},
    Row{"cancel_other", "{name} asked for this: only they, or an admin, cancel it"},
    // what becomes of a file that is imported
    Row{"import_hidden", "is hidden"},
    Row{"import_empty", "is empty"},
    Row{"import_no_program", "is not a text of a program"},
    Row{"import_too_long", "has {count} bytes, more than the {most} of a program"},
    Row{"import_archived", "archived by {name}: {why}"},
    Row{"import_in_use", "the name is in use with another text"},
    Row{"import_brought", "this import has brought another text of this name into this folder"},
    Row{"import_several", "{count} programs have this name in this folder"},
    // the store's own
    Row{"store_not_found", "it does not exist"},
    Row{"store_exists", "it exists already"},
    Row{"store_stale", "another change came first"},
    Row{"store_reference", "it refers to something that is not there"},
    Row{"store_value", "a value is missing or out of range"},
    Row{"store_transition", "this state cannot follow the present one"},
    Row{"store_no_verdict", "the text was never checked for this machine and delivery"},
    Row{"store_not_passed", "the newest verdict of the text does not clear it"},
    Row{"store_verdict_stale", "what it rests on changed after the verdict"},
    Row{"store_not_released", "no release lets this text go to this machine"},
    Row{"store_used_up", "the transfers of the proving are used up"},
    Row{"store_sign_off", "an approval needs a note of who signs it off"},
    Row{"store_not_proved", "no transfer has ended well since the proving began"},
    Row{"store_not_signed_off", "no operator has signed the proving off"},
    Row{"store_four_eyes", "whoever wrote or released a text may not approve it on this machine"},
    Row{"store_machine_busy", "another job has the machine's line"},
    Row{"store_not_leased", "the machine's line is with another server of this store"},
    Row{"store_machine_torn", "a block was torn on this machine: a person must confirm that the control was reset"},
    Row{"store_too_early", "the job may not be armed before its time"},
    Row{"store_on_hold", "a person put the job on hold"},
    Row{"store_end_not_confirmed", "a person must first confirm the end of another job of this machine"},
    Row{"store_key_reused", "the idempotency key was used for another request"},
    Row{"store_append_only", "what is written there never changes"},
    Row{"store_busy", "another program holds the database for too long"},
    Row{"store_in_use", "another server runs on this database"},
    Row{"store_disk_full", "the disk is full"},
    Row{"store_unreachable", "the database cannot be opened"},
    Row{"store_no_answer", "the database does not answer"},
    Row{"store_io", "the disk could not be read or written"},
    Row{"store_corrupt", "the database is damaged"},
    Row{"store_internal", "the database refused for a reason that should not exist"},
    // last: anything in front
    Row{"line_is", "{what} (the line is {state})"},
};

// Whether `sentence` is as `pattern` has it, to its end.
bool fits(std::string_view pattern, std::string_view sentence, KnownSentence& found) {
  found.values.clear();
  while (true) {
    const std::size_t open = pattern.find('{');
    const std::string_view fixed = pattern.substr(0, open);
    if (!sentence.starts_with(fixed)) return false;
    sentence.remove_prefix(fixed.size());
    if (open == std::string_view::npos) return sentence.empty();
    const std::size_t close = pattern.find('}', open);
    const std::string_view name = pattern.substr(open + 1, close - open - 1);
    pattern.remove_prefix(close + 1);
    const std::string_view next = pattern.substr(0, pattern.find('{'));
    const std::size_t end = next.empty() ? sentence.size() : sentence.find(next);
    if (end == std::string_view::npos || end == 0) return false;
    found.values.emplace_back(name, sentence.substr(0, end));
    sentence.remove_prefix(end);
  }
}

// What the store adds: "the disk is full (ledger)".
bool fits_with_detail(std::string_view pattern, std::string_view sentence, KnownSentence& found) {
  if (pattern.find('{') != std::string_view::npos || !sentence.starts_with(pattern)) return false;
  sentence.remove_prefix(pattern.size());
  if (!sentence.starts_with(" (") || !sentence.ends_with(')')) return false;
  found.values = {{"detail", sentence.substr(2, sentence.size() - 3)}};
  return true;
}

}  // namespace

std::optional<KnownSentence> sentence_of(std::string_view sentence) {
  for (const Row& row : kRows) {
    KnownSentence found{.id = row.id, .values = {}};
    if (fits(row.pattern, sentence, found) || fits_with_detail(row.pattern, sentence, found)) return found;
  }
  return std::nullopt;
}

std::vector<std::string_view> sentence_ids() {
  std::vector<std::string_view> ids;
  for (const Row& row : kRows) ids.push_back(row.id);
  return ids;
}

}  // namespace dripfeed::json

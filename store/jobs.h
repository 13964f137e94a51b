// Jobs: one transfer of a released text to a machine. They move by one table of states; the store refuses all else. A
// job that broke off inside a block leaves its machine torn until a person confirms that the control was reset.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "store/basics.h"
#include "store/error.h"
#include "store/releases.h"

namespace dripfeed::store {

enum class JobState : std::uint8_t {
  queued,
  armed,  // a person armed it; nothing goes out before the control asks
  feeding,
  held,
  draining,  // all is handed, the end is not seen
  done,
  failed,
  cancelled,
  interrupted,  // the server died meanwhile
};
inline constexpr std::size_t kJobStates = 9;
template <>
inline constexpr std::array<std::string_view, 9> kNames<JobState>{
    "queued", "armed", "feeding", "held", "draining", "done", "failed", "cancelled", "interrupted"};

struct JobTransition {
  JobState from = JobState::queued;
  JobState to = JobState::queued;
  bool audited = false;  // holds of the line come too often for the audit; the ledger has them
};
// All that are allowed.
std::span<const JobTransition> job_transitions();
bool allowed(JobState from, JobState to);
// armed, feeding, held, draining: the job has its machine for itself.
bool has_line(JobState state);
// done, failed, cancelled, interrupted.
bool ended(JobState state);

struct Job {
  Id id = 0;
  Id release = 0;
  Id program = 0;
  Revision revision = 0;
  std::string text_sha256;
  std::string machine;
  Delivery delivery = Delivery::drip;
  std::string link;
  std::uint64_t bytes_total = 0;  // wire bytes
  JobState state = JobState::queued;
  std::string reason;      // of the last move
  std::string reason_id;   // the same as one word or name that a page may translate; "" where there is none
  std::uint64_t rank = 0;  // queued jobs of one machine go by it, then by their ids
  std::string created_by;
  std::string armed_by;
  std::int64_t created_at_ms = 0;
  std::int64_t armed_at_ms = 0;    // 0: never
  std::int64_t expires_at_ms = 0;  // while armed, where the line lets an arming expire; 0 otherwise
  std::int64_t started_at_ms = 0;  // when it first fed; 0: never
  std::int64_t ended_at_ms = 0;    // 0: not yet
  bool torn = false;               // the control may hold a part of a block
  std::string confirmed_by;        // who said that the control was reset
  std::string confirm_reason;
  std::int64_t confirmed_at_ms = 0;     // 0: never
  std::optional<std::int64_t> held_ms;  // how long its control held, once it ended; nothing where no one counted
  std::string read_back;                // of a memory load: "waiting for read-back", "equal", or how it differs
  Id order = 0;                         // that it belongs to; 0: none
  RestartOf restart;                    // of its release

  // What its line did, once it ended; nothing where no one counted.
  std::optional<std::uint64_t> holds;       // how often its control held
  std::optional<std::int64_t> line_ms;      // that its characters took on the line
  std::optional<std::int64_t> forecast_ms;  // of its program by its check, as it was when the job was armed

  std::int64_t not_before_ms = 0;  // it may not be armed before; 0: at any time
  std::string hold_by;             // who put it on hold: it is not armed meanwhile; "": it is not on hold
  std::string hold_reason;
  Id retry_of = 0;  // job that ended, of which it is another transfer; 0: none
  Id choice = 0;    // first job of the choice that it belongs to, of which one is armed; 0: none

  std::string end_check;  // what a person confirms after its end, before the next job of its machine; "": nothing
  std::string end_confirmed_by;
  std::string end_note;
  std::int64_t end_confirmed_at_ms = 0;  // 0: never

  // Nothing may be armed on the machine until a person confirms.
  [[nodiscard]] bool needs_confirmation() const { return torn && confirmed_at_ms == 0; }
  // The same of its end, where a part of it may have been made.
  [[nodiscard]] bool needs_end_confirmation() const {
    return !end_check.empty() && started_at_ms != 0 && ended_at_ms != 0 && end_confirmed_at_ms == 0;
  }
};

struct NewJob {
  Id release = 0;
  std::string link{};
  std::uint64_t bytes_total = 0;
  Id order = 0;  // that it belongs to; 0: none
  std::int64_t not_before_ms = 0;
  std::string end_check{};
  Id retry_of = 0;             // job that ended; 0: none
  Id choice = 0;               // that it joins; 0: none
  bool begins_choice = false;  // it is the first of one
};

struct JobMove {
  JobState to = JobState::queued;
  std::string reason{};
  bool torn = false;               // only with failed, cancelled and interrupted
  std::int64_t expires_at_ms = 0;  // only with armed
  std::string reason_id{};
  std::optional<std::int64_t> held_ms{};      // only with what ends it
  std::optional<std::uint64_t> holds{};       // the same
  std::optional<std::int64_t> line_ms{};      // the same
  std::optional<std::int64_t> forecast_ms{};  // only with armed
  std::string early_reason{};                 // only with armed: why it is armed before its time; "": it is not
};

// What a job did within a time, for a summary.
struct JobUse {
  Job job;
  std::uint64_t clocked = 0;      // wire bytes that passed the line for certain
  std::int64_t ledger_at_ms = 0;  // of its last row; 0: it has none
};

struct JobFilter {
  std::string machine{};  // empty: all
  std::optional<JobState> state{};
  Id program = 0;  // 0: all
  Id order = 0;    // 0: all
  Id choice = 0;   // 0: all
};

// Jobs that ended in this time: from_ms <= end < to_ms.
struct EndedFilter {
  std::int64_t from_ms = 0;
  std::int64_t to_ms = 0;
  std::string machine{};            // empty: all
  std::optional<JobState> state{};  // one that ends a job; nothing: all
};

// What a sum of the past needs of a job.
struct EndedJob {
  std::string machine;
  std::string part;  // of its order, or that its program was rendered from; "": not known
  JobState state = JobState::done;
  std::uint64_t bytes_total = 0;
  std::int64_t started_at_ms = 0;  // 0: it never fed
  std::int64_t ended_at_ms = 0;
  std::optional<std::int64_t> held_ms;
  std::optional<std::uint64_t> holds;
  std::optional<std::int64_t> line_ms;
  std::optional<std::int64_t> forecast_ms;
};

class Jobs : public Repository {
 public:
  // Queued, after all queued jobs of its machine whose orders are as urgent. Errors: broken_reference (no such release
  // or order), refused_transition (`retry_of` has not ended or is of another release, the order is not open, is for
  // another machine, or of another part than the one that the program was rendered from), and those of
  // Releases::released_for.
  virtual Result<Job> add(const NewJob& job, const Stamp& by) = 0;
  // Errors: not_found, refused_transition; to armed also machine_busy, machine_torn, too_early (without a reason),
  // on_hold, end_not_confirmed (of another job of the machine), its order does not fit any more, and those of
  // Releases::released_for. The first feeding of a job counts as a transfer of a release in proving. With a job that is
  // armed, the others of its choice that are queued are cancelled.
  virtual Result<Job> move(Id job, const JobMove& move, const Stamp& by) = 0;
  // A person says that the control of this machine was reset. Errors: not_found (nothing waits), invalid_value (no
  // reason).
  virtual Result<Job> confirm_reset(std::string_view machine, std::string_view reason, const Stamp& by) = 0;
  // Moves a queued job before another one of its machine, or to the end for 0. Those whose rank changed, in their
  // order. Errors: not_found; refused_transition (it is not queued); invalid_value (`before` is not queued there).
  virtual Result<std::vector<Job>> move_before(Id job, Id before, const Stamp& by) = 0;
  // When a queued job may be armed; 0: at any time. Nothing is armed by it. Errors: not_found, refused_transition (it
  // is not queued).
  virtual Result<Job> schedule(Id job, std::int64_t not_before_ms, const Stamp& by) = 0;
  // A queued job on hold is not armed until it is taken off hold; it keeps its place. Errors: not_found,
  // refused_transition (it is not queued; it is on hold already, or not on hold), invalid_value (no reason).
  virtual Result<Job> hold(Id job, std::string_view reason, const Stamp& by) = 0;
  virtual Result<Job> end_hold(Id job, const Stamp& by) = 0;
  // A person confirms what the job's end asks for. Errors: not_found, refused_transition (nothing of it is asked for).
  virtual Result<Job> confirm_end(Id job, std::string_view note, const Stamp& by) = 0;
  // The job of the machine whose end waits for a confirmation; the oldest one.
  virtual Result<std::optional<Job>> end_waits_on(std::string_view machine) = 0;
  // Each job that ended in a time, in the order of their ends. `visit` must not use the store.
  virtual Result<void> each_ended(const EndedFilter& filter, const std::function<void(const EndedJob&)>& visit) = 0;
  // The jobs of a machine that were on its line, or ended, in this time; oldest first.
  virtual Result<std::vector<JobUse>> used(std::string_view machine, std::int64_t from_ms, std::int64_t to_ms) = 0;
  // What came of punching a memory load back. Errors: not_found.
  virtual Result<Job> set_read_back(Id job, std::string_view result, const Stamp& by) = 0;
  // Errors: not_found.
  virtual Result<Job> get(Id job) = 0;
  // Newest first.
  virtual Result<Page<Job>> list(const PageRequest& page, const JobFilter& filter = {}) = 0;
  // The job that has the machine's line.
  virtual Result<std::optional<Job>> on_line(std::string_view machine) = 0;
  // The job whose torn block waits for a confirmation.
  virtual Result<std::optional<Job>> torn_on(std::string_view machine) = 0;
  // For the start of a server: every job that had a line, of these machines, becomes interrupted, torn wherever bytes
  // may have gone out.
  virtual Result<std::vector<Job>> interrupt_unfinished(const Stamp& by, const OfMachines& of = {}) = 0;
};

}  // namespace dripfeed::store

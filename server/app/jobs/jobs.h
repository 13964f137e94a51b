// The use cases of a transfer: queue a released text, arm it (a person, for one line), stop, cancel, resume, and
// confirm that a control was reset. Nothing here ever starts or resumes motion by itself.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "server/app/base/documents.h"
#include "server/app/base/error.h"
#include "server/app/checks/checked_texts.h"
#include "server/app/jobs/books.h"
#include "server/app/lines/lines.h"
#include "server/app/out/arming_hook.h"
#include "server/app/out/events.h"
#include "server/app/shop/called_programs.h"
#include "store/store.h"

namespace dripfeed::app {

// What a job is besides its release.
struct JobPlan {
  store::Id order = 0;             // 0: none
  std::int64_t not_before_ms = 0;  // 0: at any time
  std::string end_check{};         // "": what its machine's profile asks for
  store::Id retry_of = 0;          // job that ended; 0: none
  store::Id choice = 0;            // that it joins; 0: none
  bool begins_choice = false;
};

class Jobs {
 public:
  // Where the text was read for a machine that had changed again by then.
  static constexpr std::string_view kMachineChanges = "the machine is being changed: try again";

  Jobs(store::Store& store, Lines& lines, Books& books, Events& events, const Clock& clock, const Documents& documents,
       CalledPrograms called, HookSettings hook = {});

  // Queued. Errors: not_found, refused (not released, the machine changed after the verdict, or its text cannot be
  // fed: with the place), unavailable (the disk is full).
  Result<store::Job> add(store::Id release, std::string_view actor);
  // The same in steps, for one transaction with what belongs to it. The row alone: nothing where the text has to be
  // read first, which takes too long for a transaction.
  Result<std::optional<store::Job>> add_known(store::Id release, std::string_view actor, const JobPlan& plan = {});
  Result<void> read_text(store::Id release);
  // Whether a job of it could be queued now, with its text read. Errors: as those of add().
  Result<void> make_ready(store::Id release);
  // Whether the verdict of a release is of the programs that are called now; the store knows all else that a step of
  // it needs. Errors: not_found, refused.
  Result<void> refuse_changed_calls(const store::Release& release);
  // Once the transaction is durable.
  void announce(const store::Job& job);
  // The named person arms it for its machine's line, for so long or as the profile says; to be sent `rounds` times,
  // each with the control's own start; before its time only with a reason. Errors: not_found, invalid, refused with the
  // reason (torn, busy, link down, machine changed, too early, an end that is not confirmed, …).
  Result<store::Job> arm(store::Id job, std::optional<double> minutes, std::string_view actor, std::uint32_t rounds = 1,
                         std::string_view early_reason = {});
  // At a block end: the feed stops and waits / is over. A queued job is cancelled at once.
  Result<store::Job> stop(store::Id job, std::string_view actor);
  Result<store::Job> cancel(store::Id job, std::string_view actor);
  // Queued jobs have an order that people make; nothing is armed by it. Before another one of its machine, or to the
  // end for 0. Errors: not_found, refused (not queued), invalid.
  Result<store::Job> move_before(store::Id job, store::Id before, std::string_view actor);
  // Before when a queued job may not be armed; 0: at any time. Nothing is armed by it. Errors: not_found, refused.
  Result<store::Job> schedule(store::Id job, std::int64_t not_before_ms, std::string_view actor);
  // A queued job on hold is not armed; it keeps its place. Errors: not_found, refused, invalid.
  Result<store::Job> hold(store::Id job, std::string_view reason, std::string_view actor);
  Result<store::Job> end_hold(store::Id job, std::string_view actor);
  // A person confirms what a job's end asks for. Errors: not_found, refused (nothing is asked for).
  Result<store::Job> confirm_end(store::Id job, std::string_view note, std::string_view actor);
  // A stopped job goes on; a held one goes on "as if DC1" had come, with the reason in the ledger and the audit.
  Result<store::Job> resume(store::Id job, std::string_view reason, std::string_view actor);
  // The books follow the lines now: a job that its line ended is not armed in the store any more.
  void wait_until_booked() { static_cast<void>(books_.wait_until_booked()); }
  // Whether the text's own number is from O8000 to O9999: the machine builder's in many controls, so that a memory load
  // of it needs a right of its own.
  [[nodiscard]] bool protects_number(std::string_view text_sha256);
  // A person says that the control was reset: a torn line may be used again.
  Result<store::Job> confirm_reset(std::string_view machine, std::string_view reason, std::string_view actor);

 private:
  // A text and the profile of its machine, read and checked. Errors: `invalid`, `refused`.
  Result<CheckedTexts::Fit> read_fit(const CheckedTexts::Key& text, std::string_view document);
  // A release that may become a job as far as the disk goes, and its machine as it is now.
  struct Wanted;
  Result<Wanted> find_wanted(store::Id release);
  Result<void> refuse_outdated(std::string_view text_sha256, const store::Machine& machine, store::Delivery delivery);
  [[nodiscard]] Error no_line(const std::string& machine) const;
  Result<std::shared_ptr<Line>> line_with(const store::Job& job);
  Result<store::Job> end_without_store(store::Id job, feed::Command command, std::string_view actor,
                                       const store::Error& why);
  Result<std::string> file_name(const machine::Profile& profile, store::Id program);
  // `note`: what stands in the ledger, where something does.
  Result<store::Job> command(store::Id job, feed::Command command, std::string_view action, std::string_view reason,
                             std::string_view actor, std::string_view note = {});
  Result<store::Job> confirm_without_job(const std::string& machine, std::string_view reason, std::string_view actor);
  Result<void> clear_line(const std::string& machine, std::string_view reason);
  Result<store::Job> cancel_queued(const store::Job& job, std::string_view actor);
  struct Arming;
  Result<Arming> prepare_arming(store::Id job, std::uint32_t rounds);
  std::optional<std::int64_t> forecast_ms(const store::Job& job, std::uint32_t rounds);
  Result<void> put_on_line(const Arming& arming, double minutes, std::uint32_t rounds);
  Result<void> ask_hook(const store::Job& job, std::string_view actor);
  Result<void> refuse_idle_no_more(const store::Job& job);
  void publish_withdrawn(const store::Job& armed);
  Result<store::Job> disarm_after(const store::Job& job, const std::string& why, std::string_view actor);
  store::Stamp stamp(std::string_view actor) const;
  void publish(const store::Job& job, std::string_view text);

  store::Store& store_;
  Lines& lines_;
  Books& books_;
  Events& events_;
  const Clock& clock_;
  const Documents& documents_;
  CalledPrograms called_;
  CheckedTexts checked_texts_;
  ArmingHook hook_;
};

}  // namespace dripfeed::app

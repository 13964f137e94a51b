// Work that is given away as a package and carried out from one. Both ends are this program.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/app/checks/diagnose.h"
#include "server/app/checks/workers.h"
#include "server/app/jobs/restarting.h"
#include "server/app/library/compare.h"
#include "server/app/library/optimizing.h"
#include "server/app/library/rewriting.h"
#include "server/app/library/translation.h"
#include "server/app/library/value_changes.h"
#include "server/app/shop/called_programs.h"

namespace dripfeed::json {

struct WorkPackage;

// Figures or a picture of a request of the measuring routes; `kind` is the route's last word.
struct FiguresWork {
  std::string kind;                      // "accuracy", "gouge", "timing", "sweep"
  std::string plot;                      // name of a picture; empty: figures
  std::string body;                      // of the request
  std::optional<app::CaseOrder> of;      // but for a sweep
  std::optional<app::RenderWork> sweep;  // family and machine
};
struct Figures {
  bool is_picture = false;  // SVG; otherwise JSON
  std::string body;
};

class DocumentWorkers final : public app::Workers {
 public:
  // Without `called` the programs that a program calls are not looked for.
  DocumentWorkers(app::Workplace& workplace, std::uint32_t seconds, std::optional<app::CalledPrograms> called = {})
      : workplace_(workplace), seconds_(seconds), called_(std::move(called)) {}

  app::Result<app::CheckDone> check(const app::CaseOrder& order, const app::Waiter& waiter) override;
  app::Result<app::RenderDone> render(const app::RenderWork& work, const app::Waiter& waiter) override;
  app::Result<std::vector<app::ProgramDigest>> digest(const std::vector<app::DigestOrder>& orders,
                                                      const app::Waiter& waiter) override;
  // A sweep makes many checks, and has kSweepChecks times the time of one.
  app::Result<Figures> figures(const FiguresWork& work, const app::Waiter& waiter);
  // The document of json::comparison.
  app::Result<std::string> compare(const app::CompareOrder& order, const app::Waiter& waiter);

  // The document of json::diagnosed. Whoever writes a text waits for it.
  app::Result<std::string> diagnose(const app::DiagnoseOrder& order, const app::Waiter& waiter);
  // The document of json::translation.
  app::Result<std::string> convert(const app::TranslationOrder& order, const app::Waiter& waiter);

  // The document of json::optimized.
  app::Result<std::string> optimize(const app::OptimizeOrder& order, const app::Waiter& waiter);

  // The document of json::rewritten.
  app::Result<std::string> rewrite(const app::RewriteOrder& order, const app::Waiter& waiter);

  // The document of json::tool_path.
  app::Result<std::string> path(const app::DiagnoseOrder& order, const app::Waiter& waiter);

  // The document of json::path_picture.
  app::Result<std::string> picture(const app::DiagnoseOrder& order, const app::Waiter& waiter);

  // The document of json::value_changes.
  app::Result<std::string> explain(const app::ValueOrder& order, const app::Waiter& waiter);

  // The bytes of json::stock_bytes.
  app::Result<std::string> stock(const app::DiagnoseOrder& order, const app::Waiter& waiter);

  // The document of json::statistics.
  app::Result<std::string> statistics(const app::DiagnoseOrder& order, const app::Waiter& waiter);

  struct Restart {
    bool is_possible = false;
    std::string text;      // byte for byte
    std::string document;  // of json::restart_preview
  };
  app::Result<Restart> restart(const app::RestartOrder& order, const app::Waiter& waiter);

  app::Workplace& workplace() { return workplace_; }
  // From any thread: of checks that begin from now on.
  void set_seconds(std::uint32_t seconds) { seconds_ = seconds; }

  static constexpr std::uint32_t kSweepChecks = 10;

 private:
  using MakeRequest = std::function<WorkPackage(const std::vector<app::CalledText>& called)>;
  // Adds to `called` what the text turns out to call.
  app::Result<WorkPackage> ask_with_called(const app::Caller& caller, std::vector<app::CalledText>& called,
                                           const MakeRequest& make, const app::Waiter& waiter);
  app::Result<bool> find_missing(const app::Caller& caller, std::vector<app::CalledText>& called,
                                 const WorkPackage& reply);
  app::Result<std::string> of_text(std::string_view kind, const app::DiagnoseOrder& order, const app::Waiter& waiter);

  app::Workplace& workplace_;
  std::atomic<std::uint32_t> seconds_;  // budget of one check
  std::optional<app::CalledPrograms> called_;
};

// In the worker: does what a package asks for. The reply is a package, too, of an error where it could not be done.
std::string carry_out(std::string_view request);

}  // namespace dripfeed::json

// Each look is one transaction that reads, so what a running server writes meanwhile is not taken for a fault.
#include "store/sql/verifier.h"

#include <array>

#include <fmt/format.h>

#include "store/sql/audit_table.h"
#include "store/sql/content_table.h"
#include "store/sql/ledger_table.h"

namespace dripfeed::sql {
namespace {

using store::Error;
using store::ErrorCode;
using store::Id;
using store::Result;

// Rows of a job's ledger that its list does not reach, or a list that has more.
constexpr std::string_view kLooseRows =
    "SELECT h.job, h.seq, coalesce(c.rows, 0) FROM ledger_head h LEFT JOIN "
    "(SELECT job, count(*) AS rows FROM ledger GROUP BY job) c ON c.job = h.job WHERE coalesce(c.rows, 0) <> h.seq";

// What the rules of jobs exclude, whatever happened: each query names a subject.
struct JobRule {
  std::string_view sql;
  std::string_view what;
};
constexpr std::array kJobRules = {
    JobRule{"SELECT 'job/' || id FROM job WHERE torn = 1 AND state NOT IN ('failed', 'cancelled', 'interrupted')",
            "it is marked torn, but it did not break off"},
    JobRule{"SELECT 'job/' || id FROM job WHERE confirmed_at_ms <> 0 AND torn = 0",
            "a reset was confirmed for it, but it is not torn"},
    JobRule{"SELECT 'job/' || id FROM job WHERE confirmed_at_ms <> 0 AND (confirmed_by = '' OR confirm_reason = '')",
            "a reset was confirmed without a name or a reason"},
    JobRule{"SELECT 'machine/' || machine FROM job WHERE state IN ('armed', 'feeding', 'held', 'draining') "
            "GROUP BY machine HAVING count(*) > 1",
            "more than one job has its line"},
    JobRule{
        "SELECT 'machine/' || machine FROM job j WHERE state IN ('armed', 'feeding', 'held', 'draining') AND EXISTS "
        "(SELECT 1 FROM job t WHERE t.machine = j.machine AND t.torn = 1 AND t.confirmed_at_ms = 0)",
        "a job has its line, although a torn block waits for a confirmation"},
    JobRule{
        "SELECT 'machine/' || machine FROM job j WHERE state IN ('armed', 'feeding', 'held', 'draining') AND EXISTS "
        "(SELECT 1 FROM answer a WHERE a.machine = j.machine AND a.state = 'torn' AND a.confirmed_at_ms = 0)",
        "a job has its line, although a torn answer waits for a confirmation"},
    JobRule{"SELECT 'answer/' || id FROM answer WHERE confirmed_at_ms <> 0 AND state <> 'torn'",
            "a reset was confirmed for it, but it is not torn"},
};

class Verifier {
 public:
  Verifier(Database& database, std::span<const FileLook> files) : database_(database), files_(files) {}

  Result<Verification> run() {
    for (const auto look : {&Verifier::look_at_file, &Verifier::look_at_audit, &Verifier::look_at_jobs,
                            &Verifier::look_at_ledger, &Verifier::look_at_contents}) {
      if (auto looked = (this->*look)(); !looked) return std::unexpected(looked.error());
    }
    return std::move(found_);
  }

 private:
  void fault(std::string subject, std::string what) { found_.faults.push_back({std::move(subject), std::move(what)}); }

  // Damage is what is looked for; all else keeps us from looking.
  Result<void> note(const Error& error, std::string subject) {
    if (error.code != ErrorCode::corrupt) return std::unexpected(error);
    fault(std::move(subject), error.detail.empty() ? std::string("it is damaged") : error.detail);
    return {};
  }

  // Runs `body` on each row of a query. Damage that ends it is a fault of `subject`.
  template <class F>
  Result<void> each(std::string_view sql, const char* subject, F&& body) {
    auto done = database_.read(subject, [&](Session& session) -> Result<void> {
      Query query(session, sql);
      while (query.next()) body(query);
      return {};
    });
    return done ? done : note(done.error(), subject);
  }

  Result<void> look_at_file() {
    for (const FileLook& look : files_) {
      auto looked = each(look.sql, "file", [&](Query& row) {
        if (std::string what = look.fault(row); !what.empty()) fault("file", std::move(what));
      });
      if (!looked) return looked;
    }
    return {};
  }

  Result<void> look_at_audit() {
    AuditTable audit(database_);
    const auto check = audit.verify();
    if (!check) return note(check.error(), "audit");
    found_.audit_rows = check->rows;
    found_.audit_head = check->head;
    if (check->first_broken) {
      fault(fmt::format("audit/{}", *check->first_broken),
            "the chain breaks here: this row was altered, or one before it was taken out");
    }
    return {};
  }

  Result<void> look_at_jobs() {
    for (const JobRule& rule : kJobRules) {
      auto looked = each(rule.sql, "job", [&](Query& query) { fault(query.text(), std::string(rule.what)); });
      if (!looked) return looked;
    }
    return each(
        "SELECT count(*) FROM (SELECT machine FROM job WHERE torn = 1 AND confirmed_at_ms = 0 UNION "
        "SELECT machine FROM answer WHERE state = 'torn' AND confirmed_at_ms = 0) t",
        "job", [&](Query& query) { found_.torn_machines = query.number(); });
  }

  Result<void> look_at_ledger() {
    std::vector<Id> jobs;
    auto listed = each("SELECT id FROM job ORDER BY id", "job", [&](Query& query) { jobs.push_back(query.number()); });
    if (!listed) return listed;
    LedgerTable ledger(database_);
    for (const Id job : jobs) {
      const std::string subject = fmt::format("job/{}", job);
      const auto rows = ledger.verify(job);
      if (rows) {
        found_.ledger_rows += *rows;
      } else if (rows.error().code == ErrorCode::not_found) {
        fault(subject, "it has no ledger");
      } else if (rows.error().code == ErrorCode::corrupt) {
        fault(subject, fmt::format("the ledger breaks at {}", rows.error().detail));
      } else {
        return std::unexpected(rows.error());
      }
    }
    found_.jobs = jobs.size();
    return each(kLooseRows, "ledger", [&](Query& query) {
      const Id job = query.number();
      const std::uint64_t last = query.number();
      fault(fmt::format("job/{}", job),
            fmt::format("its ledger ends with row {}, but has {} rows", last, query.number()));
    });
  }

  Result<void> look_at_contents() {
    std::vector<store::Content> contents;
    auto listed =
        each("SELECT sha256, bytes FROM content WHERE sha256 IS NOT NULL ORDER BY id", "content", [&](Query& query) {
          contents.emplace_back();
          contents.back().sha256 = query.text();
          contents.back().bytes = query.number();
        });
    if (!listed) return listed;
    ContentTable table(database_);
    for (const store::Content& content : contents) {
      found_.content_bytes += content.bytes;
      const auto whole = table.verify(content.sha256);
      // One that nothing refers to may be dropped by a server that starts meanwhile.
      if (whole || whole.error().code == ErrorCode::not_found) continue;
      if (whole.error().code != ErrorCode::corrupt) return whole;
      fault(fmt::format("content/{}", content.sha256), "its bytes do not have this hash, or some are missing");
    }
    found_.contents = contents.size();
    return {};
  }

  Database& database_;
  std::span<const FileLook> files_;
  Verification found_;
};

}  // namespace

Result<Verification> verify(Database& database, std::span<const FileLook> files) {
  return Verifier(database, files).run();
}

}  // namespace dripfeed::sql

// Programs: texts that come from outside or are rendered from families. A revision is never changed; its text is found
// by its hash.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "dialects/compile/render/render.h"
#include "server/app/base/disk_reserve.h"
#include "server/app/base/documents.h"
#include "server/app/base/error.h"
#include "server/app/checks/workers.h"
#include "server/app/library/quota.h"
#include "server/app/ports/clock.h"
#include "store/store.h"

namespace dripfeed::app {

// Of a part, or of a family with values of its own.
struct RenderOrder {
  std::string part;
  std::string family;  // without a part
  Values values;       // without a part
  std::string machine;
  compile::RenderMode mode = compile::RenderMode::automatic;
  store::Delivery delivery = store::Delivery::drip;
  std::string name;       // "O0100"; empty: the renderer's
  bool optimize = false;  // a macro is made faster for the machine's control
};

struct Rendered {
  store::Program program;
  compile::RenderResult result;
};

// What rendering would store.
struct Preview {
  compile::RenderResult result;
  std::string family;       // its name
  std::string family_text;  // that the diagnostics are in
  std::string drawing;      // as Documents::write_drawing has it
};

class Programs {
 public:
  Programs(store::Store& store, const Clock& clock, const Documents& documents,
           const DiskReserve* disk_reserve = nullptr, Workers* workers = nullptr, Quota* quota = nullptr);

  // Texts are large, so none is taken while the room for the ledger is given up: all have the error unavailable, too.
  //
  // A text is stored first, in short transactions under its hash; then its rows, which add() and add_revision() write
  // in a moment, and may so share a transaction with others. What no row names is dropped when the server starts again.
  // Errors: invalid (no such dialect, empty), too_large and over_quota (see Quota).
  Result<store::NewProgramText> keep_text(std::string_view dialect, std::string_view text);
  Result<store::NewProgramText> keep_text(std::string_view text);
  Result<store::Program> add(std::string_view name, std::string_view dialect, const store::NewProgramText& text,
                             std::string_view actor);
  Result<store::Program> add_revision(store::Id program, store::Revision expected, const store::NewProgramText& text,
                                      std::string_view actor);
  // Both steps in one call.
  Result<store::Program> upload(std::string_view name, std::string_view dialect, std::string_view text,
                                std::string_view actor);
  Result<store::Program> upload_revision(store::Id program, store::Revision expected, std::string_view text,
                                         std::string_view actor);
  // Rendered and stored; nothing is stored when the family, the values or the machine are wrong.
  Result<Rendered> render(const RenderOrder& order, std::string_view actor, const Waiter& waiter = {});
  // The same, and nothing is stored.
  Result<Preview> preview(const RenderOrder& order, const Waiter& waiter = {});
  // What a check of that program would find for the machine; nothing is stored. Errors: as render and Workers::check.
  Result<CheckDone> judge(const RenderOrder& order, const Waiter& waiter = {});

 private:
  struct RenderCase;  // what an order names, read from the store
  Result<RenderCase> load(const RenderOrder& order);
  Result<RenderDone> carry_out(const RenderWork& work, const Waiter& waiter);
  Result<store::Origin> origin_of(const RenderOrder& order, std::string& family_text, Values& values);
  [[nodiscard]] store::Stamp stamp(std::string_view actor) const;

  store::Store& store_;
  const Clock& clock_;
  const Documents& documents_;
  const DiskReserve* disk_reserve_;
  Workers* workers_;
  Quota* quota_;  // nullptr: there is no limit
};

// Non-empty lines but '%'.
std::uint64_t count_blocks(std::string_view text);

}  // namespace dripfeed::app

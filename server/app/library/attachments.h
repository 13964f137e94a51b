// Files of programs, families, parts and orders: setup sheets, drawings, pictures. What a file is called and says it is
// comes from whoever brings it, so neither is believed when it goes out again.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "server/app/base/disk_reserve.h"
#include "server/app/base/error.h"
#include "server/app/base/kept_content.h"
#include "server/app/library/quota.h"
#include "server/app/ports/clock.h"
#include "store/store.h"

namespace dripfeed::app {

// The type without its parameters, in small letters; application/octet-stream for none, or what is not a type.
std::string media_type_of(std::string_view stated);

// As what a stored file is handed out: its own type where a program may show that without running any of it, or
// application/octet-stream. HTML, SVG and scripts are never among them.
std::string_view served_type(std::string_view stored);

class Attachments {
 public:
  Attachments(store::Store& store, const Clock& clock, const DiskReserve* disk_reserve = nullptr,
              Quota* quota = nullptr)
      : store_(store), clock_(clock), disk_reserve_(disk_reserve), quota_(quota) {}

  // Its bytes first, in short transactions under their hash; then its row, by add(). What no row names is dropped when
  // the server starts again. `of.sha256` is not read. Errors: invalid (name, not one owner, no bytes), not_found (the
  // owner), too_large and over_quota (see Quota), unavailable (the room for the ledger is given up).
  Result<store::NewAttachment> keep(const store::NewAttachment& of, std::uint64_t bytes, const Pieces& pieces);
  // Errors: exists, and the store's.
  Result<store::Attachment> add(const store::NewAttachment& kept, std::string_view actor);

 private:
  Result<void> look_at(const store::NewAttachment& of);

  store::Store& store_;
  const Clock& clock_;
  const DiskReserve* disk_reserve_;
  Quota* quota_;  // nullptr: there is no limit
};

}  // namespace dripfeed::app

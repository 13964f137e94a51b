// Attachments: setup sheets, drawings, pictures and other files of a program, family, part or order. Their bytes are in
// contents.h. An attachment never changes. It is removed by a person with a reason; its row stays, with the hash of
// what it was, and its bytes go when nothing else refers to them.
#pragma once

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

// Whose it is: just one is given.
struct AttachedTo {
  Id program = 0;
  std::string family{};
  std::string part{};
  Id order = 0;
  friend bool operator==(const AttachedTo&, const AttachedTo&) = default;
};

struct NewAttachment {
  AttachedTo to{};
  std::string name{};        // of the file: "setup sheet.pdf"
  std::string media_type{};  // as whoever brought it stated it
  std::string sha256{};      // of the content, which was put before
};

struct Attachment {
  Id id = 0;
  NewAttachment of;
  std::uint64_t bytes = 0;
  std::string added_by;
  std::int64_t added_at_ms = 0;
  std::string removed_by;
  std::string removed_reason;
  std::int64_t removed_at_ms = 0;  // 0: it is there

  [[nodiscard]] bool is_removed() const { return removed_at_ms != 0; }
};

class Attachments : public Repository {
 public:
  // Errors: invalid_value (no name or type, not just one owner), broken_reference (no such owner or content), exists
  // (the owner has one of this name).
  virtual Result<Attachment> add(const NewAttachment& attachment, const Stamp& by) = 0;
  // Errors: not_found, invalid_value (no reason), refused_transition (it is removed).
  virtual Result<Attachment> remove(Id attachment, std::string_view reason, const Stamp& by) = 0;
  // Also one that was removed. Errors: not_found.
  virtual Result<Attachment> get(Id attachment) = 0;
  // Those that are there, newest first; of one owner where one is given. Errors: invalid_value (more than one).
  virtual Result<Page<Attachment>> list(const PageRequest& page, const AttachedTo& of = {}) = 0;
};

}  // namespace dripfeed::store

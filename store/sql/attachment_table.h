// Attachments in the database.
#pragma once

#include "store/attachments.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class AttachmentTable final : public store::Attachments {
 public:
  explicit AttachmentTable(Database& database) : database_(database) {}
  store::Result<store::Attachment> add(const store::NewAttachment& attachment, const store::Stamp& by) override;
  store::Result<store::Attachment> remove(store::Id attachment, std::string_view reason,
                                          const store::Stamp& by) override;
  store::Result<store::Attachment> get(store::Id attachment) override;
  store::Result<store::Page<store::Attachment>> list(const store::PageRequest& page,
                                                     const store::AttachedTo& of) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql

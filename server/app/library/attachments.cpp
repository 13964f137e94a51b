// All that can be refused is refused before the first byte is stored.
#include "server/app/library/attachments.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "server/app/base/names.h"

namespace dripfeed::app {

namespace {

constexpr std::string_view kUnknownType = "application/octet-stream";
constexpr std::size_t kLongestType = 100;

// What browsers and office programs show, and none of them executes. Text is served as plain text whatever it says.
constexpr std::array<std::string_view, 22> kServed = {
    "application/gzip",
    "application/json",
    "application/msword",
    "application/pdf",
    "application/rtf",
    "application/vnd.ms-excel",
    "application/vnd.oasis.opendocument.spreadsheet",
    "application/vnd.oasis.opendocument.text",
    "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet",
    "application/vnd.openxmlformats-officedocument.wordprocessingml.document",
    "application/zip",
    "image/bmp",
    "image/gif",
    "image/jpeg",
    "image/png",
    "image/tiff",
    "image/vnd.dxf",
    "image/webp",
    "model/step",
    "model/stl",
    "text/csv",
    "text/plain",
};

// RFC 9110, 5.6.2.
bool is_token_char(char c) {
  constexpr std::string_view kOthers = "!#$%&'*+-.^_`|~";
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || kOthers.find(c) != std::string_view::npos;
}

bool is_media_type(std::string_view type) {
  const std::size_t slash = type.find('/');
  if (slash == std::string_view::npos || slash == 0 || slash + 1 == type.size() || type.size() > kLongestType)
    return false;
  return std::ranges::all_of(type.substr(0, slash), is_token_char) &&
         std::ranges::all_of(type.substr(slash + 1), is_token_char);
}

template <class Found>
Result<void> must_be_there(const store::Result<Found>& found) {
  return found ? Result<void>{} : std::unexpected(from_store(found.error()));
}

Result<void> owner_is_there(store::Store& store, const store::AttachedTo& to) {
  if (!to.family.empty()) return must_be_there(store.families().get(to.family));
  if (!to.part.empty()) return must_be_there(store.parts().get(to.part));
  if (to.order != 0) return must_be_there(store.orders().get(to.order));
  return must_be_there(store.programs().get(to.program));
}

}  // namespace

std::string media_type_of(std::string_view stated) {
  stated = stated.substr(0, stated.find(';'));
  while (stated.ends_with(' ') || stated.ends_with('\t')) stated.remove_suffix(1);
  std::string type(stated);
  for (char& c : type) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return is_media_type(type) ? type : std::string(kUnknownType);
}

std::string_view served_type(std::string_view stored) {
  const auto* const found = std::ranges::find(kServed, stored);
  return found == kServed.end() ? kUnknownType : *found;
}

Result<void> Attachments::look_at(const store::NewAttachment& of) {
  const store::AttachedTo& to = of.to;
  if (int{to.program != 0} + int{!to.family.empty()} + int{!to.part.empty()} + int{to.order != 0} != 1)
    return fail(ErrorCode::invalid, "name one program, family, part or order that the file belongs to");
  if (const std::string why = why_no_name(of.name); !why.empty())
    return fail(ErrorCode::invalid, fmt::format("the name of a file {}", why));
  if (of.name.find_first_of("/\\") != std::string::npos)
    return fail(ErrorCode::invalid, "the name of a file has no slash");
  return owner_is_there(store_, to);
}

Result<store::NewAttachment> Attachments::keep(const store::NewAttachment& of, std::uint64_t bytes,
                                               const Pieces& pieces) {
  if (auto good = look_at(of); !good) return std::unexpected(good.error());
  if (quota_ != nullptr)
    if (auto room = quota_->may_keep_attachment(bytes); !room) return std::unexpected(room.error());
  if (auto room = refuse_on_full_disk(disk_reserve_); !room) return std::unexpected(room.error());
  const auto content = keep_in_slices(store_.contents(), pieces);
  if (!content) return std::unexpected(content.error());
  if (content->bytes == 0) return fail(ErrorCode::invalid, "the file is empty");
  store::NewAttachment kept = of;
  kept.sha256 = content->sha256;
  return kept;
}

Result<store::Attachment> Attachments::add(const store::NewAttachment& kept, std::string_view actor) {
  return lift(store_.attachments().add(kept, {std::string(actor), clock_.wall_ms()}));
}

}  // namespace dripfeed::app

// Files of programs, families, parts and orders. A body is the file itself, and lies in a file of the server's when it
// is long: it is read in pieces.
#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/list_response.h"
#include "server/json/records.h"
#include "server/json/requests.h"

namespace dripfeed::http {

namespace {

std::expected<store::AttachedTo, Response> owner_of(const Request& request) {
  const auto program = id_in(request, "program");
  if (!program) return std::unexpected(program.error());
  const auto order = id_in(request, "order");
  if (!order) return std::unexpected(order.error());
  return store::AttachedTo{.program = *program,
                           .family = query_text(request, "family"),
                           .part = query_text(request, "part"),
                           .order = *order};
}

// RFC 6266: a name for whoever reads no more than ASCII, and the whole one.
std::string disposition_of(std::string_view name) {
  constexpr std::string_view kPlain = " !#$&+-.^_`|~()";
  std::string plain;
  std::string escaped;
  for (const char c : name) {
    const bool is_word = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    plain += is_word || kPlain.find(c) != std::string_view::npos ? c : '_';
    if (is_word || c == '-' || c == '.' || c == '_') {
      escaped += c;
    } else {
      escaped += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return fmt::format("attachment; filename=\"{}\"; filename*=UTF-8''{}", plain, escaped);
}

std::string type_to_serve(const store::Attachment& attachment) {
  std::string type(app::served_type(attachment.of.media_type));
  return type.starts_with("text/") ? type + "; charset=utf-8" : type;
}

}  // namespace

Response list_attachments(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  const auto owner = owner_of(call.request);
  if (!owner) return owner.error();
  return list_response(call.api.application().store().attachments().list(*page, *owner),
                       [](const store::Attachment& one) { return json::attachment(one); });
}

Response add_attachment(const Call& call) {
  const auto owner = owner_of(call.request);
  if (!owner) return owner.error();
  app::Attachments& attachments = call.api.application().attachments();
  const auto kept = attachments.keep({.to = *owner,
                                      .name = query_text(call.request, "name"),
                                      .media_type = app::media_type_of(call.request.content_type),
                                      .sha256 = {}},
                                     body_bytes(call.request), pieces_of(call.request));
  if (!kept) return problem_response(kept.error());
  return call.commit([&] {
    const auto added = attachments.add(*kept, call.user);
    if (!added) return problem_response(added.error());
    return created(fmt::format("/api/v1/attachments/{}", added->id), json::attachment(*added));
  });
}

Response get_attachment(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto found = call.api.application().store().attachments().get(*id);
  if (!found) return problem_response(app::from_store(found.error()));
  return json_response(200, json::attachment(*found));
}

// Never shown in the page's own place, whatever it is: it is saved, its type is one of a list, and were a browser to
// show it all the same, nothing in it runs.
Response get_attachment_content(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  store::Store& store = call.api.application().store();
  const auto found = store.attachments().get(*id);
  if (!found) return problem_response(app::from_store(found.error()));
  if (found->is_removed())
    return problem_response(
        404, fmt::format("{} was removed by {}: {}", found->of.name, found->removed_by, found->removed_reason));
  Response response;
  response.content_type = type_to_serve(*found);
  response.headers.emplace_back("Content-Disposition", disposition_of(found->of.name));
  response.headers.emplace_back("Content-Security-Policy", "default-src 'none'; sandbox");
  response.headers.emplace_back("ETag", fmt::format("\"{}\"", found->of.sha256));
  const auto offset = std::make_shared<std::uint64_t>(0);
  response.source = [&contents = store.contents(), sha256 = found->of.sha256,
                     offset](std::span<char> into) -> std::expected<std::size_t, std::string> {
    const auto count = contents.read(sha256, *offset, into);
    if (!count) return std::unexpected(store::message_of(count.error()));
    *offset += *count;
    return *count;
  };
  return response;
}

Response remove_attachment(const Call& call) {
  const auto id = id_of(call.parameters[0]);
  if (!id) return id.error();
  const auto body = json::read_reason_body(call.request.body, true);
  if (!body) return problem_response(body.error());
  const auto removed = call.api.application().store().attachments().remove(*id, body->reason, stamp_of(call));
  if (!removed) return problem_response(app::from_store(removed.error()));
  return json_response(200, json::attachment(*removed));
}

}  // namespace dripfeed::http

// Both ends are this program, so a package that cannot be read is a fault of ours: members are taken as they must be,
// and the fences of who calls see to the rest.
#include "server/json/work_package.h"

#include <cstdint>
#include <utility>

namespace dripfeed::json {

namespace {

const std::string kNoText;

Document write_values(const app::Values& values, WorkPackage& into) {
  Document list = Document::array();
  for (const auto& [name, value] : values) list.push_back({into.add(name), into.add(value)});
  return list;
}

app::Values read_values(const Document& from, const WorkPackage& package) {
  app::Values values;
  for (const Document& one : from) {
    values[package.texts.at(one.at(0).get<std::size_t>())] = package.texts.at(one.at(1).get<std::size_t>());
  }
  return values;
}

Document write_lines(const std::vector<family::LineRange>& ranges) {
  Document lines = Document::array();
  for (const family::LineRange& one : ranges) lines.push_back({one.first, one.last});
  return lines;
}

std::vector<family::LineRange> read_lines(const Document& from) {
  std::vector<family::LineRange> ranges;
  for (const Document& one : from) ranges.push_back({one.at(0).get<std::uint32_t>(), one.at(1).get<std::uint32_t>()});
  return ranges;
}

Document write_nominal(const app::NominalCase& nominal, WorkPackage& into) {
  return {{"family", into.add(nominal.family)},
          {"revision", nominal.revision},
          {"text", into.add(nominal.text)},
          {"values", write_values(nominal.values, into)},
          {"is_from_request", nominal.is_from_request}};
}

app::NominalCase read_nominal(const Document& from, const WorkPackage& package) {
  return {.family = package.text_of(from, "family"),
          .revision = from.at("revision").get<store::Revision>(),
          .text = package.text_of(from, "text"),
          .values = read_values(from.at("values"), package),
          .is_from_request = from.at("is_from_request").get<bool>()};
}

}  // namespace

Document write_texts(const std::vector<std::string>& texts, WorkPackage& into) {
  Document list = Document::array();
  for (const std::string& one : texts) list.push_back(into.add(one));
  return list;
}

std::vector<std::string> read_texts(const Document& from, const WorkPackage& package) {
  std::vector<std::string> texts;
  for (const Document& one : from) texts.push_back(package.texts.at(one.get<std::size_t>()));
  return texts;
}

const std::string& WorkPackage::text_of(const Document& from, std::string_view member) const {
  const auto found = from.find(member);
  return found == from.end() ? kNoText : texts.at(found->get<std::size_t>());
}

std::string write_package(const WorkPackage& package) {
  Document sizes = Document::array();
  std::size_t bytes = 0;
  for (const std::string& text : package.texts) {
    sizes.push_back(text.size());
    bytes += text.size();
  }
  std::string out = dump({{"head", package.head}, {"sizes", std::move(sizes)}});
  out.reserve(out.size() + 1 + bytes);
  out += '\n';
  for (const std::string& text : package.texts) out += text;
  return out;
}

app::Result<WorkPackage> read_package(std::string_view bytes) {
  const auto broken = [] { return app::fail(app::ErrorCode::internal, "a worker's package is not whole"); };
  const std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos) return broken();
  auto line = parse(bytes.substr(0, end));
  if (!line) return std::unexpected(line.error());
  if (!line->is_object() || !line->contains("head") || !line->contains("sizes")) return broken();
  WorkPackage package{.head = std::move((*line)["head"]), .texts = {}};
  bytes.remove_prefix(end + 1);
  for (const Document& size : (*line)["sizes"]) {
    const auto count = size.get<std::size_t>();
    if (count > bytes.size()) return broken();
    package.texts.emplace_back(bytes.substr(0, count));
    bytes.remove_prefix(count);
  }
  return package;
}

Document write_case(const app::CaseOrder& order, WorkPackage& into) {
  Document document = {{"machine", into.add(order.machine)},
                       {"folder", into.add(order.folder)},
                       {"name", into.add(order.name)},
                       {"dialect", into.add(order.dialect)},
                       {"text", into.add(order.text)},
                       {"profile", into.add(order.profile)},
                       {"drip", order.delivery == store::Delivery::drip},
                       {"profile_lines", write_lines(order.profile_lines)}};
  if (order.nominal) document["nominal"] = write_nominal(*order.nominal, into);
  return document;
}

app::CaseOrder read_case(const Document& from, const WorkPackage& package) {
  app::CaseOrder order{.machine = package.text_of(from, "machine"),
                       .folder = package.text_of(from, "folder"),
                       .name = package.text_of(from, "name"),
                       .dialect = package.text_of(from, "dialect"),
                       .text = package.text_of(from, "text"),
                       .profile = package.text_of(from, "profile"),
                       .delivery = from.at("drip").get<bool>() ? store::Delivery::drip : store::Delivery::memory,
                       .nominal = {},
                       .profile_lines = {}};
  order.profile_lines = read_lines(from.at("profile_lines"));
  if (const auto nominal = from.find("nominal"); nominal != from.end()) order.nominal = read_nominal(*nominal, package);
  return order;
}

Document write_called(const std::vector<app::CalledText>& called, WorkPackage& into) {
  Document list = Document::array();
  for (const app::CalledText& one : called) {
    list.push_back({{"key", into.add(one.key)},
                    {"program", one.program},
                    {"revision", one.revision},
                    {"name", into.add(one.name)},
                    {"text", into.add(one.text)},
                    {"why_not", into.add(one.why_not)}});
  }
  return list;
}

std::vector<app::CalledText> read_called(const Document& from, const WorkPackage& package) {
  std::vector<app::CalledText> called;
  for (const Document& one : from) {
    called.push_back({.key = package.text_of(one, "key"),
                      .program = one.at("program").get<store::Id>(),
                      .revision = one.at("revision").get<store::Revision>(),
                      .name = package.text_of(one, "name"),
                      .text = package.text_of(one, "text"),
                      .why_not = package.text_of(one, "why_not")});
  }
  return called;
}

Document write_names(const std::set<std::string>& names, WorkPackage& into) {
  return write_texts({names.begin(), names.end()}, into);
}

std::set<std::string> read_names(const Document& from, const WorkPackage& package) {
  const std::vector<std::string> names = read_texts(from, package);
  return {names.begin(), names.end()};
}

Document write_family(const app::RenderWork& work, WorkPackage& into) {
  return {{"family", into.add(work.family)},
          {"text", into.add(work.text)},
          {"values", write_values(work.values, into)},
          {"profile", into.add(work.profile)},
          {"mode", static_cast<int>(work.mode)},
          {"drip", work.delivery == store::Delivery::drip},
          {"name", into.add(work.name)},
          {"heading", write_texts(work.heading, into)},
          {"optimize", work.optimize}};
}

app::RenderWork read_family(const Document& from, const WorkPackage& package) {
  return {.family = package.text_of(from, "family"),
          .text = package.text_of(from, "text"),
          .values = read_values(from.at("values"), package),
          .profile = package.text_of(from, "profile"),
          .mode = static_cast<compile::RenderMode>(from.at("mode").get<int>()),
          .delivery = from.at("drip").get<bool>() ? store::Delivery::drip : store::Delivery::memory,
          .name = package.text_of(from, "name"),
          .heading = read_texts(from.at("heading"), package),
          .optimize = from.at("optimize").get<bool>()};
}

Document write_text_order(std::string_view kind, const app::DiagnoseOrder& order, WorkPackage& into) {
  Document head = {{"kind", kind},
                   {"dialect", into.add(order.dialect)},
                   {"text", into.add(order.text)},
                   {"profile", into.add(order.profile)},
                   {"delivery", static_cast<int>(order.delivery)},
                   {"profile_lines", write_lines(order.profile_lines)},
                   {"stock", into.add(order.stock)}};
  if (order.nominal) head["nominal"] = write_nominal(*order.nominal, into);
  return head;
}

app::DiagnoseOrder read_text_order(const WorkPackage& package) {
  const Document& head = package.head;
  app::DiagnoseOrder order{.dialect = package.text_of(head, "dialect"),
                           .text = package.text_of(head, "text"),
                           .profile = package.text_of(head, "profile"),
                           .delivery = static_cast<store::Delivery>(head.at("delivery").get<int>())};
  order.profile_lines = read_lines(head.at("profile_lines"));
  order.stock = package.text_of(head, "stock");
  if (const auto nominal = head.find("nominal"); nominal != head.end()) order.nominal = read_nominal(*nominal, package);
  return order;
}

Document write_digest_orders(const std::vector<app::DigestOrder>& orders, WorkPackage& into) {
  Document list = Document::array();
  for (const app::DigestOrder& one : orders)
    list.push_back({{"name", into.add(one.name)},
                    {"dialect", into.add(one.dialect)},
                    {"text", into.add(one.text)},
                    {"is_whole", one.is_whole}});
  return list;
}

std::vector<app::DigestOrder> read_digest_orders(const Document& from, const WorkPackage& package) {
  std::vector<app::DigestOrder> orders;
  for (const Document& one : from)
    orders.push_back({.name = package.text_of(one, "name"),
                      .dialect = package.text_of(one, "dialect"),
                      .text = package.text_of(one, "text"),
                      .is_whole = one.at("is_whole").get<bool>()});
  return orders;
}

Document write_digests(const std::vector<app::ProgramDigest>& digests, WorkPackage& into) {
  Document list = Document::array();
  for (const app::ProgramDigest& one : digests) {
    Document calls = Document::array();
    for (const compile::DigestCall& call : one.calls)
      calls.push_back({into.add(call.name), static_cast<int>(call.kind), call.line});
    list.push_back({{"names", write_texts(one.names, into)},
                    {"comments", into.add(one.comments)},
                    {"words", into.add(one.words)},
                    {"is_cut", one.is_cut},
                    {"calls", std::move(calls)},
                    {"computed_calls", one.computed_calls},
                    {"not_read", into.add(one.not_read)}});
  }
  return list;
}

std::vector<app::ProgramDigest> read_digests(const Document& from, const WorkPackage& package) {
  std::vector<app::ProgramDigest> digests;
  for (const Document& one : from) {
    app::ProgramDigest digest{.names = read_texts(one.at("names"), package),
                              .comments = package.text_of(one, "comments"),
                              .words = package.text_of(one, "words"),
                              .is_cut = one.at("is_cut").get<bool>(),
                              .calls = {},
                              .computed_calls = one.at("computed_calls").get<std::uint64_t>(),
                              .not_read = package.text_of(one, "not_read")};
    for (const Document& call : one.at("calls"))
      digest.calls.push_back({.name = package.texts.at(call.at(0).get<std::size_t>()),
                              .kind = static_cast<ir::CallKind>(call.at(1).get<int>()),
                              .line = call.at(2).get<std::uint32_t>()});
    digests.push_back(std::move(digest));
  }
  return digests;
}

WorkPackage error_package(const app::Error& error) {
  WorkPackage package;
  Document places = Document::array();
  for (const app::ErrorPlace& one : error.places)
    places.push_back({{"pointer", one.pointer}, {"line", one.line}, {"column", one.column}, {"text", one.text}});
  package.head["error"] = {{"code", static_cast<int>(error.code)}, {"text", error.text}, {"places", std::move(places)}};
  return package;
}

app::Error read_work_error(const Document& error) {
  app::Error out{.code = static_cast<app::ErrorCode>(error.at("code").get<int>()),
                 .text = error.at("text").get<std::string>(),
                 .places = {}};
  for (const Document& one : error.at("places")) {
    out.places.push_back({.pointer = one.at("pointer").get<std::string>(),
                          .line = one.at("line").get<std::uint32_t>(),
                          .column = one.at("column").get<std::uint32_t>(),
                          .text = one.at("text").get<std::string>()});
  }
  return out;
}

Document write_diagnostics(const std::vector<text::Diagnostic>& diagnostics) {
  Document list = Document::array();
  for (const text::Diagnostic& one : diagnostics) {
    list.push_back({{"id", static_cast<int>(one.id)},
                    {"severity", static_cast<int>(one.severity)},
                    {"begin", one.span.begin},
                    {"end", one.span.end},
                    {"arguments", one.arguments},
                    {"alarm", one.alarm}});
  }
  return list;
}

std::vector<text::Diagnostic> read_diagnostics(const Document& from) {
  std::vector<text::Diagnostic> all;
  for (const Document& one : from) {
    text::Diagnostic made = text::make_diagnostic(static_cast<text::DiagnosticId>(one.at("id").get<int>()), {});
    made.severity = static_cast<text::Severity>(one.at("severity").get<int>());
    made.span = {one.at("begin").get<std::uint32_t>(), one.at("end").get<std::uint32_t>()};
    made.arguments = one.at("arguments").get<std::vector<std::string>>();
    made.alarm = one.at("alarm").get<std::string>();
    all.push_back(std::move(made));
  }
  return all;
}

}  // namespace dripfeed::json

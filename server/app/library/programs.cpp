// Contents first, then the row that refers to them: a crash in between leaves only bytes that no one names.
#include "server/app/library/programs.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/text/number.h"
#include "server/app/base/kept_content.h"
#include "server/app/shop/catalog.h"

namespace dripfeed::app {

std::uint64_t count_blocks(std::string_view text) {
  std::uint64_t count = 0;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\r\n");
    const std::string_view line = text.substr(0, end);
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != std::string_view::npos && line.substr(first) != "%") ++count;
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return count;
}

Programs::Programs(store::Store& store, const Clock& clock, const Documents& documents, const DiskReserve* disk_reserve,
                   Workers* workers, Quota* quota)
    : store_(store),
      clock_(clock),
      documents_(documents),
      disk_reserve_(disk_reserve),
      workers_(workers),
      quota_(quota) {}

store::Stamp Programs::stamp(std::string_view actor) const { return {std::string(actor), clock_.wall_ms()}; }

Result<store::NewProgramText> Programs::keep_text(std::string_view dialect, std::string_view text) {
  if (compile::find_dialect(dialect) == nullptr) {
    return fail(ErrorCode::invalid, fmt::format("dialect \"{}\" is not known", dialect),
                {{.pointer = "/dialect", .text = "is not known"}});
  }
  return keep_text(text);
}

Result<store::NewProgramText> Programs::keep_text(std::string_view text) {
  if (text.empty())
    return fail(ErrorCode::invalid, "the text is empty", {{.pointer = "/text", .text = "must not be empty"}});
  if (auto room = refuse_on_full_disk(disk_reserve_); !room) return std::unexpected(room.error());
  if (quota_ != nullptr)
    if (auto room = quota_->may_keep_program(text.size()); !room) return std::unexpected(room.error());
  const auto content = keep_in_slices(store_.contents(), text);
  if (!content) return std::unexpected(content.error());
  return store::NewProgramText{
      .sha256 = content->sha256, .places_sha256 = {}, .blocks = count_blocks(text), .facts = {}, .origin = {}};
}

Result<store::Program> Programs::add(std::string_view name, std::string_view dialect, const store::NewProgramText& text,
                                     std::string_view actor) {
  return lift(store_.programs().add(name, dialect, text, stamp(actor)));
}

Result<store::Program> Programs::add_revision(store::Id program, store::Revision expected,
                                              const store::NewProgramText& text, std::string_view actor) {
  return lift(store_.programs().add_revision(program, expected, text, stamp(actor)));
}

Result<store::Program> Programs::upload(std::string_view name, std::string_view dialect, std::string_view text,
                                        std::string_view actor) {
  const auto kept = keep_text(dialect, text);
  return kept ? add(name, dialect, *kept, actor) : std::unexpected(kept.error());
}

Result<store::Program> Programs::upload_revision(store::Id program, store::Revision expected, std::string_view text,
                                                 std::string_view actor) {
  const auto kept = keep_text(text);
  return kept ? add_revision(program, expected, *kept, actor) : std::unexpected(kept.error());
}

// Where the text will come from, with the family's text and the values to bind.
Result<store::Origin> Programs::origin_of(const RenderOrder& order, std::string& family_text, Values& values) {
  if (order.part.empty() == order.family.empty()) {
    return fail(ErrorCode::invalid, "name a part or a family", {{.pointer = "/part", .text = "either part or family"}});
  }
  if (!order.part.empty() && !order.values.empty()) {
    return fail(ErrorCode::invalid, "a part has values of its own",
                {{.pointer = "/values", .text = "only with a family; a part is rendered with its own"}});
  }
  store::Origin origin;
  origin.kind = store::OriginKind::rendered;
  store::Result<store::Family> family = std::unexpected(store::Error{});
  if (!order.part.empty()) {
    const auto part = lift(store_.parts().get(order.part));
    if (!part) return std::unexpected(part.error());
    auto stored = documents_.read_values(part->made_of.values);
    if (!stored) return std::unexpected(stored.error());
    values = std::move(*stored);
    origin.part = part->number;
    origin.part_revision = part->revision;
    family = store_.families().get(part->made_of.family, part->made_of.family_revision);
  } else {
    values = order.values;
    family = store_.families().get(order.family);
  }
  if (!family) return std::unexpected(from_store(family.error()));
  family_text = family->text;
  origin.family = family->name;
  origin.family_revision = family->revision;
  origin.values = documents_.write_values(values);
  return origin;
}

namespace {

// What the program says at the control of where its text is from.
std::vector<std::string> heading_of(const store::Origin& origin) {
  std::vector<std::string> lines = {fmt::format("revision {}", origin.family_revision)};
  if (!origin.part.empty()) lines.push_back(fmt::format("part {} revision {}", origin.part, origin.part_revision));
  return lines;
}

}  // namespace

struct Programs::RenderCase {
  store::Origin origin;
  store::Machine machine;
  std::string dialect;  // of the machine
  RenderWork work;
};

Result<Programs::RenderCase> Programs::load(const RenderOrder& order) {
  std::string family_text;
  Values values;
  auto origin = origin_of(order, family_text, values);
  if (!origin) return std::unexpected(origin.error());
  auto machine = lift(store_.machines().get(order.machine));
  if (!machine) return std::unexpected(machine.error());
  const auto profile = documents_.read_profile(machine->profile);
  if (!profile) return std::unexpected(profile.error());
  RenderWork work{.family = origin->family,
                  .text = std::move(family_text),
                  .values = std::move(values),
                  .profile = machine->profile,
                  .mode = order.mode,
                  .delivery = order.delivery,
                  .name = order.name,
                  .heading = heading_of(*origin),
                  .optimize = order.optimize};
  return RenderCase{.origin = std::move(*origin),
                    .machine = std::move(*machine),
                    .dialect = profile->control.dialect,
                    .work = std::move(work)};
}

Result<RenderDone> Programs::carry_out(const RenderWork& work, const Waiter& waiter) {
  return workers_ != nullptr ? workers_->render(work, waiter) : render_family(work, documents_);
}

Result<Preview> Programs::preview(const RenderOrder& order, const Waiter& waiter) {
  auto loaded = load(order);
  if (!loaded) return std::unexpected(loaded.error());
  auto done = carry_out(loaded->work, waiter);
  if (!done) return std::unexpected(done.error());
  return Preview{.result = std::move(done->result),
                 .family = std::move(loaded->work.family),
                 .family_text = std::move(loaded->work.text),
                 .drawing = std::move(done->drawing)};
}

Result<CheckDone> Programs::judge(const RenderOrder& order, const Waiter& waiter) {
  auto loaded = load(order);
  if (!loaded) return std::unexpected(loaded.error());
  auto done = carry_out(loaded->work, waiter);
  if (!done) return std::unexpected(done.error());
  CaseOrder rendered{.machine = std::move(loaded->machine.name),
                     .name = loaded->work.name.empty() ? loaded->work.family : loaded->work.name,
                     .dialect = std::move(loaded->dialect),
                     .text = std::move(done->result.text),
                     .profile = std::move(loaded->work.profile),
                     .delivery = order.delivery,
                     .nominal = NominalCase{.family = std::move(loaded->work.family),
                                            .revision = loaded->origin.family_revision,
                                            .text = std::move(loaded->work.text),
                                            .values = std::move(loaded->work.values)},
                     .profile_lines = std::move(done->result.profile_lines)};
  CalledBy none;
  return workers_ != nullptr ? workers_->check(rendered, waiter)
                             : check_case(std::move(rendered), documents_, {}, none);
}

Result<Rendered> Programs::render(const RenderOrder& order, std::string_view actor, const Waiter& waiter) {
  auto loaded = load(order);
  if (!loaded) return std::unexpected(loaded.error());
  auto done = carry_out(loaded->work, waiter);
  if (!done) return std::unexpected(done.error());
  Rendered rendered{.program = {}, .result = std::move(done->result)};

  if (auto room = refuse_on_full_disk(disk_reserve_); !room) return std::unexpected(room.error());
  const auto content = keep_in_slices(store_.contents(), rendered.result.text);
  if (!content) return std::unexpected(content.error());
  store::NewProgramText text{.sha256 = content->sha256,
                             .places_sha256 = {},
                             .blocks = rendered.result.blocks,
                             .facts = {},
                             .origin = std::move(loaded->origin)};
  if (!done->places.empty()) {
    const auto places = keep_in_slices(store_.contents(), done->places);
    if (!places) return std::unexpected(places.error());
    text.places_sha256 = places->sha256;
  }
  text.origin.machine = loaded->machine.name;
  text.origin.machine_revision = loaded->machine.revision;
  text.origin.mode = compile::name_of(rendered.result.mode);
  for (const auto& range : rendered.result.profile_lines) {
    text.facts += fmt::format("{}{}-{}", text.facts.empty() ? "profile " : ",", range.first, range.last);
  }
  const std::string name = order.name.empty()
                               ? fmt::format("{}", text.origin.part.empty() ? text.origin.family : text.origin.part)
                               : order.name;
  auto program = lift(store_.programs().add(name, loaded->dialect, text, stamp(actor)));
  if (!program) return std::unexpected(program.error());
  rendered.program = std::move(*program);
  return rendered;
}

}  // namespace dripfeed::app

// Everything is read as it was when the program was rendered: revisions of the family and the machine.
#include "server/app/library/value_case.h"

#include <fmt/format.h>

#include "server/app/library/stored_program.h"

namespace dripfeed::app {

namespace {

constexpr std::uint64_t kLongest = std::uint64_t{4} << 20U;  // it is rendered some times for each parameter

}  // namespace

Result<ValueCase> load_value_case(store::Store& store, const Documents& documents, const store::Receipt& receipt) {
  if (receipt.of.quarantined) return fail(ErrorCode::refused, "a receipt in quarantine is not compared");
  const auto known = stored_program(store, receipt.of.name);
  if (!known) return std::unexpected(known.error());
  if (!*known) return fail(ErrorCode::refused, fmt::format("no stored program has the name {}", receipt.of.name));
  const store::Program& program = **known;
  const store::Origin& origin = program.newest.origin;
  if (origin.kind != store::OriginKind::rendered)
    return fail(ErrorCode::refused, fmt::format("program {} was not rendered from a family", program.name));
  const auto family = lift(store.families().get(origin.family, origin.family_revision));
  if (!family) return std::unexpected(family.error());
  const auto machine = lift(store.machines().get(origin.machine, origin.machine_revision));
  if (!machine) return std::unexpected(machine.error());
  auto values = documents.read_values(origin.values);
  if (!values) return std::unexpected(values.error());
  if (std::max(program.newest.bytes, receipt.bytes) > kLongest)
    return fail(ErrorCode::refused, "the program is too long for its values to be looked for");
  auto stored = lift(store::read_whole(store.contents(), program.newest.sha256, kLongest));
  if (!stored) return std::unexpected(stored.error());
  auto received = lift(store::read_whole(store.contents(), receipt.of.sha256, kLongest));
  if (!received) return std::unexpected(received.error());
  const auto mode = compile::find_render_mode(origin.mode).value_or(compile::RenderMode::automatic);
  // Loops and jumps are for a control's memory; plain blocks are the same for both.
  const auto delivery = mode == compile::RenderMode::macro ? store::Delivery::memory : store::Delivery::drip;
  RenderWork work{.family = family->name,
                  .text = family->text,
                  .values = std::move(*values),
                  .profile = machine->profile,
                  .mode = mode,
                  .delivery = delivery,
                  .name = program.name};
  return ValueCase{.stored = program.newest,
                   .order = {.work = std::move(work), .stored = std::move(*stored), .received = std::move(*received)}};
}

}  // namespace dripfeed::app

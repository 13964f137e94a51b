// A command without a group is for the program's own use.
#include "server/cli/command_shapes.h"

#include <algorithm>

#include <CLI/CLI.hpp>

namespace dripfeed::cli {

namespace {

OptionShape shape_of(const CLI::Option& option) {
  OptionShape shape{.names = {},
                    .about = option.get_description(),
                    .takes_value = option.get_items_expected_max() > 0,
                    .is_positional = option.get_positional(),
                    .is_required = option.get_required(),
                    .is_repeated = option.get_items_expected_max() > 1};
  for (const std::string& name : option.get_lnames()) shape.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) shape.names.push_back("-" + name);
  if (shape.is_positional) shape.names = {option.get_name(true)};
  return shape;
}

void add(const CLI::App& app, const std::string& path, std::vector<CommandShape>& into) {
  CommandShape shape{
      .path = path, .about = app.get_description(), .footer = app.get_footer(), .options = {}, .commands = {}};
  for (const CLI::Option* option : app.get_options()) shape.options.push_back(shape_of(*option));
  const auto below = app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
  for (const CLI::App* one : below) shape.commands.push_back(one->get_name());
  into.push_back(std::move(shape));
  for (const CLI::App* one : below) add(*one, path.empty() ? one->get_name() : path + " " + one->get_name(), into);
}

}  // namespace

std::vector<CommandShape> shapes_of(const CLI::App& program) {
  std::vector<CommandShape> all;
  add(program, "", all);
  return all;
}

}  // namespace dripfeed::cli

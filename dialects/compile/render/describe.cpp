// What can be known of a family without rendering it: its parameters, whether values fit, its geometry.
#include <memory>
#include <utility>

#include "dialects/compile/render/render.h"
#include "dialects/compile/render/wrapped_family.h"
#include "dialects/family/read.h"

namespace dripfeed::compile {

namespace {

// The family, with what can be known of a native program that it keeps.
family::ReadFamilyResult read_whole(const text::Source& source) {
  family::ReadFamilyResult read = family::read_family(source);
  if (text::has_error(read.diagnostics)) return read;
  const std::vector<text::Diagnostic> faults = target_faults(read.family);
  read.diagnostics.insert(read.diagnostics.end(), faults.begin(), faults.end());
  return read;
}

struct Bound {
  family::BoundFamily bound;
  std::vector<text::Diagnostic> diagnostics;
};

Bound read_and_bind(const text::Source& source, const std::vector<family::Override>& values) {
  family::ReadFamilyResult read = read_whole(source);
  Bound out{{}, std::move(read.diagnostics)};
  if (text::has_error(out.diagnostics)) return out;
  family::BindResult bound =
      family::bind_family(std::make_shared<const family::Family>(std::move(read.family)), values);
  out.diagnostics.insert(out.diagnostics.end(), bound.diagnostics.begin(), bound.diagnostics.end());
  out.bound = std::move(bound.bound);
  return out;
}

}  // namespace

FamilyDescription describe_family(const text::Source& family) {
  family::ReadFamilyResult read = read_whole(family);
  FamilyDescription out{.name = read.family.name,
                        .title = read.family.title,
                        .machine = read.family.machine,
                        .parameters = {},
                        .diagnostics = std::move(read.diagnostics)};
  for (const family::Parameter& parameter : read.family.parameters) {
    const double factor = parameter.unit == nullptr ? 1.0 : parameter.unit->factor;
    const bool is_list = parameter.kind == family::ParameterKind::list;
    out.parameters.push_back({.name = parameter.name,
                              .kind = family::kind_of(parameter),
                              .unit = std::string(parameter.unit == nullptr ? "" : parameter.unit->name),
                              .standard = family::format_standard(parameter),
                              .low = parameter.low / factor,
                              .high = parameter.high / factor,
                              .step = parameter.step / factor,
                              .fewest = is_list ? parameter.fewest : 0,
                              .most = is_list ? parameter.most : 0,
                              .choices = parameter.choices,
                              .text = parameter.text,
                              .group = parameter.group});
  }
  return out;
}

std::vector<text::Diagnostic> check_values(const text::Source& family, const std::vector<family::Override>& values) {
  return read_and_bind(family, values).diagnostics;
}

FamilyGeometry family_geometry(const text::Source& family, const std::vector<family::Override>& values) {
  Bound bound = read_and_bind(family, values);
  FamilyGeometry out{{}, std::move(bound.diagnostics)};
  if (!text::has_error(out.diagnostics)) out.geometry = family::geometry(bound.bound);
  return out;
}

}  // namespace dripfeed::compile

// Further names are kept where the names of global data are.
#include "dialects/interpreter/state/axis_names.h"

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/ir/motion.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::interpreter {

namespace {

constexpr double kFirstFurther = static_cast<double>(ir::kAxisCount);

}  // namespace

double axis_number(SharedData& shared, std::string_view name) {
  const std::string upper = text::upper_case(name);
  const std::size_t letter = upper.size() == 1 ? ir::kAxisLetters.find(upper.front()) : std::string_view::npos;
  return letter != std::string_view::npos ? static_cast<double>(letter) : kFirstFurther + shared.id_of(upper);
}

std::string axis_name(const SharedData& shared, double number) {
  if (!(number >= 0.0)) return std::string(kUnknownText);
  if (number < kFirstFurther) return std::string(1, ir::kAxisLetters[static_cast<std::size_t>(number)]);
  const auto id = static_cast<std::uint32_t>(number - kFirstFurther);
  return id < shared.name_count() ? shared.name_of(id) : std::string(kUnknownText);
}

}  // namespace dripfeed::interpreter

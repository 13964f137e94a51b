// Each point of a stroke is the place of the text plus its height by a constant, so that the control computes both.
#include "dialects/family/engraving.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/stroke_font.h"

namespace dripfeed::family {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Operator;

class Strokes {
 public:
  Strokes(Family& family, const Step& engraving) : family_(family), engraving_(engraving) {}

  // The steps of one text, at the end of `out`.
  void write(const std::string& text, std::vector<Step>& out) {
    double offset = 0.0;
    for (const char c : text) {
      for (const Stroke& stroke : strokes_of(c)) {
        add(out, StepKind::rapid, place(offset, stroke.front()));
        add(out, StepKind::cut, {{Address::z, value(Address::z)}});
        for (auto point = stroke.begin() + 1; point != stroke.end(); ++point)
          add(out, StepKind::cut, place(offset, *point));
        add(out, StepKind::rapid, {{Address::z, value(Address::r)}});
      }
      offset += kAdvance;
    }
  }

 private:
  [[nodiscard]] ExpressionId value(Address address) const {
    const auto begin = family_.words.begin() + engraving_.first_word;
    return std::find_if(begin, begin + engraving_.word_count,
                        [address](const StepWord& one) { return one.address == address; })
        ->value;
  }

  ExpressionId along(Address axis, double units) {
    if (units == 0.0) return value(axis);
    const ExpressionId share = family_.arena.add_constant(units / kCapitalHeight, engraving_.span);
    const ExpressionId gone = family_.arena.add_operator(Operator::multiply, value(Address::q), share, engraving_.span);
    return family_.arena.add_operator(Operator::add, value(axis), gone, engraving_.span);
  }

  std::vector<StepWord> place(double offset, const StrokePoint& at) {
    return {{Address::x, along(Address::x, offset + at.x)}, {Address::y, along(Address::y, at.y)}};
  }

  void add(std::vector<Step>& out, StepKind kind, const std::vector<StepWord>& words) {
    Step step = engraving_;
    step.kind = kind;
    step.target = ir::SymbolId::none;
    step.first_word = static_cast<std::uint32_t>(family_.words.size());
    step.word_count = static_cast<std::uint32_t>(words.size());
    family_.words.insert(family_.words.end(), words.begin(), words.end());
    out.push_back(std::move(step));
  }

  Family& family_;
  const Step& engraving_;
};

}  // namespace

BoundFamily with_strokes(const BoundFamily& bound) {
  const auto engraves = [](const Step& one) { return one.kind == StepKind::engrave; };
  if (std::ranges::none_of(bound.family->steps, engraves)) return bound;
  auto family = std::make_shared<Family>(*bound.family);
  std::vector<Step> steps;
  for (const Step& one : bound.family->steps) {
    if (engraves(one))
      Strokes(*family, one).write(bound.texts.at(one.target), steps);
    else
      steps.push_back(one);
  }
  family->steps = std::move(steps);
  return {std::move(family), bound.values, bound.texts};
}

std::string fault_of_engraving(const std::string& text) {
  const auto at = std::ranges::find_if_not(text, has_glyph);
  return at == text.end() ? "" : fmt::format("character {}, '{}',", at - text.begin() + 1, *at);
}

}  // namespace dripfeed::family

// The verb of engraving. What it stands for is known when the text is: see engraving.h.
#include <array>

#include "dialects/family/body_reader.h"

namespace dripfeed::family {

using ir::Address;
using ir::ExpressionId;

// A value under a name of its own, so that it is computed once.
ExpressionId BodyReader::kept(std::string_view stem, ExpressionId value, Dimension dimension) {
  Step out = step(StepKind::let);
  out.target = scope_.define(family_.arena, unused_name(stem), dimension, verb_, NameKind::variable);
  out.values[0] = value;
  const ExpressionId named = name_of(out);
  add(std::move(out));
  return named;
}

// engrave TEXT x X y Y height LENGTH z Z return Z
void BodyReader::engrave() {
  if (family_.machine == ir::MachineKind::lathe)
    return cursor_.syntax(verb_, "'engrave' cuts along x and y, and a lathe has no y");
  if (!may_cut()) return;
  if (compensation_waits_)
    return cursor_.syntax(verb_, "compensation begins and ends with a straight move: rapid or cut before this text");
  const Scope::Name* text = cursor_.peek().kind == LexemeKind::word ? scope_.find(cursor_.word()) : nullptr;
  if (text == nullptr || text->kind != NameKind::text) return cursor_.expected("the name of a text parameter");
  const ir::SymbolId symbol = text->symbol;
  cursor_.advance();
  struct Row {
    std::string_view word;
    Address address;
    std::string_view stem;
  };
  static constexpr auto kRows = std::to_array<Row>({{"x", Address::x, "text_x"},
                                                    {"y", Address::y, "text_y"},
                                                    {"height", Address::q, "text_height"},
                                                    {"z", Address::z, "text_bottom"},
                                                    {"return", Address::r, "text_return"}});
  std::array<ExpressionId, kRows.size()> values{};
  for (std::size_t i = 0; i < kRows.size() && !cursor_.line_failed(); ++i) {
    cursor_.expect_word(kRows[i].word);
    if (!cursor_.line_failed()) values[i] = expressions_.value_of(kLength).id;
  }
  if (cursor_.line_failed()) return;
  scope_.open();
  for (std::size_t i = 0; i < kRows.size(); ++i) values[i] = kept(kRows[i].stem, values[i], kLength);
  scope_.close();
  Step back = step(StepKind::rapid);
  word(back, Address::z, {.id = values.back()});
  add(std::move(back));
  Step out = step(StepKind::engrave);
  out.target = symbol;
  for (std::size_t i = 0; i < kRows.size(); ++i) word(out, kRows[i].address, {.id = values[i]});
  add(std::move(out));
}

}  // namespace dripfeed::family

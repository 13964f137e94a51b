// The writer of an `offset`: from the contour that was read to the steps of the moved one.
#pragma once

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dialects/family/body_reader.h"

namespace dripfeed::family {

// What becomes of a contour's points. Lengths across are on the radius; places are as the axes have them.
class BodyReader::OffsetWriter {
 public:
  OffsetWriter(BodyReader& body, Offset offset)
      : body_(body),
        family_(body.family_),
        offset_(std::move(offset)),
        is_turned_(family_.machine == ir::MachineKind::lathe && !body.face_),
        names_starts_(body.rough_.has_value()),
        names_places_(std::ranges::any_of(body.open_, [](const auto& block) {
          return block.copies && block.copies->cosine != ir::ExpressionId::none;
        })) {
    contour_.is_left = offset_.is_left;
    contour_.doubles_u = !is_turned_ && family_.machine == ir::MachineKind::lathe && family_.x_is_diameter;
    contour_.doubles_v = is_turned_ && family_.x_is_diameter;
    contour_.distance = offset_.distance;
    contour_.span = offset_.head.span;
  }

  void write(const std::vector<Step>& steps, text::Span end);

 private:
  // A length along each axis of the plane, or a place in it.
  struct Pair {
    ir::ExpressionId u = ir::ExpressionId::none;
    ir::ExpressionId v = ir::ExpressionId::none;
  };
  struct Element {
    bool is_arc = false;
    bool clockwise = false;
    bool moves_u = true;
    bool moves_v = true;
    Pair to = {};
    Pair center = {};                                  // arc: from its start
    Pair back = {};                                    // arc: from its end to the center
    Pair normal = {};                                  // line: towards the offset, of length 1
    ir::ExpressionId radius = ir::ExpressionId::none;  // arc
    std::uint32_t line = 0;
    std::size_t item = 0;
  };
  // Where two elements meet.
  struct Meeting {
    Pair at;
    ir::SymbolId corner = ir::SymbolId::none;
    std::size_t before = 0;
    std::size_t after = 0;
    bool is_start = false;  // of the contour
  };

  [[nodiscard]] ir::ExpressionId number(double value) { return family_.arena.add_constant(value, body_.verb_); }
  [[nodiscard]] bool is_number(ir::ExpressionId id, double value) const {
    const ir::Expression& e = family_.arena.at(id);
    return e.op == ir::Operator::constant && e.value == value;
  }
  [[nodiscard]] bool is_same(ir::ExpressionId a, ir::ExpressionId b) const;
  ir::ExpressionId plus(ir::ExpressionId a, ir::ExpressionId b) { return body_.sum(ir::Operator::add, a, b); }
  ir::ExpressionId minus(ir::ExpressionId a, ir::ExpressionId b) {
    return is_same(a, b) ? number(0.0) : body_.sum(ir::Operator::subtract, a, b);
  }
  ir::ExpressionId times(ir::ExpressionId a, ir::ExpressionId b) {
    return is_number(a, 0.0) || is_number(b, 0.0) ? number(0.0) : body_.sum(ir::Operator::multiply, a, b);
  }
  ir::ExpressionId by(ir::ExpressionId a, ir::ExpressionId b) {
    return is_number(a, 0.0) ? a : body_.sum(ir::Operator::divide, a, b);
  }
  ir::ExpressionId root(ir::ExpressionId a) { return body_.calculated(ir::Operator::sqrt, a, ir::ExpressionId::none); }
  ir::ExpressionId size(ir::ExpressionId a) { return body_.calculated(ir::Operator::abs, a, ir::ExpressionId::none); }
  ir::ExpressionId dot(Pair a, Pair b) { return plus(times(a.u, b.u), times(a.v, b.v)); }
  Pair plus(Pair a, Pair b) { return {plus(a.u, b.u), plus(a.v, b.v)}; }
  Pair minus(Pair a, Pair b) { return {minus(a.u, b.u), minus(a.v, b.v)}; }
  Pair times(ir::ExpressionId a, Pair b) { return {times(a, b.u), times(a, b.v)}; }
  Pair by(Pair a, ir::ExpressionId b) { return {by(a.u, b), by(a.v, b)}; }
  Pair negated(Pair a) { return {minus(number(0.0), a.u), minus(number(0.0), a.v)}; }
  Pair turned(Pair a) { return {minus(number(0.0), a.v), a.u}; }  // by 90 degrees to the left

  // Under a name, unless it is a number or a name.
  ir::ExpressionId kept(std::string_view stem, ir::ExpressionId value, Dimension dimension = kLength) {
    const Step like = body_.step(StepKind::let);
    return VerbCopy(family_, body_.scope_, like).is_simple(value) ? value : body_.kept(stem, value, dimension);
  }
  // And unless the name is of another value later.
  ir::ExpressionId stable(std::string_view stem, ir::ExpressionId value) {
    if (value == ir::ExpressionId::none) return value;
    return body_.names_one(changing_, value) ? body_.kept(stem, value, kLength) : kept(stem, value);
  }
  // The lengths from one place to another, and the place that lengths lead to.
  Pair across(Pair from, Pair to) {
    const Pair out = minus(to, from);
    return {contour_.doubles_u ? by(out.u, number(2.0)) : out.u, contour_.doubles_v ? by(out.v, number(2.0)) : out.v};
  }
  Pair place(Pair from, Pair lengths) {
    return {plus(from.u, contour_.doubles_u ? times(number(2.0), lengths.u) : lengths.u),
            plus(from.v, contour_.doubles_v ? times(number(2.0), lengths.v) : lengths.v)};
  }
  ir::SymbolId new_symbol(std::string_view stem) {
    return body_.scope_.define(family_.arena, body_.unused_name(stem), kRatio, body_.verb_);
  }
  // Of this contour alone for ever: no name of a family has capitals.
  ir::SymbolId decided(std::string_view stem) {
    return body_.scope_.define(family_.arena,
                               fmt::format("{}{}_{}", stem, family_.offsets.size(), contour_.items.size()), kRatio,
                               body_.verb_);
  }
  Pair new_names() {
    return {body_.name_of(new_symbol(is_turned_ ? "offset_z" : "offset_x")),
            body_.name_of(new_symbol(is_turned_ ? "offset_x" : "offset_y"))};
  }
  void assign(Pair names, Pair values);
  // A branch, whose names are its own.
  void open(ir::SymbolId corner, ir::Operator op, Corner kind) {
    body_.open_branch(body_.calculated(op, body_.name_of(corner), number(static_cast<double>(kind))));
    body_.scope_.open();
  }
  void close() {
    body_.scope_.close();
    body_.add(body_.step(StepKind::if_end));
  }

  bool read(const std::vector<Step>& steps);
  bool read_point(const Step& step);
  bool read_word(const StepWord& word, Element& one, OffsetContour::Item& item);
  void find_geometry(Element& one, Pair from);
  void find_line(Element& one, Pair from);
  void find_arc(Element& one, Pair from);
  Pair center_of_radius(const Element& one, Pair length);

  // Normals of an element where it begins and where it ends.
  Pair first_normal(const Element& one) { return one.is_arc ? arc_normal(one, one.center) : one.normal; }
  Pair last_normal(const Element& one) { return one.is_arc ? arc_normal(one, one.back) : one.normal; }
  Pair arc_normal(const Element& arc, Pair to_center) {
    const Pair normal = by(to_center, arc.radius);
    return is_moved_outward(arc) ? negated(normal) : normal;
  }
  [[nodiscard]] bool is_moved_outward(const Element& arc) const { return arc.clockwise == contour_.is_left; }
  ir::ExpressionId moved_radius(const Element& arc) {
    return is_moved_outward(arc) ? plus(arc.radius, offset_.distance) : minus(arc.radius, offset_.distance);
  }
  Pair straight_meeting(const Element& before, const Element& after);
  Pair crossing(const Meeting& meeting, ir::Operator op);
  Pair line_crossing(ir::Operator op, Pair normal, Pair to_center, ir::ExpressionId radius);
  Pair circle_crossing(ir::Operator op, const Element& before, const Element& after);
  template <class Use>
  void each_kind(const Meeting& meeting, const Use& use);
  [[nodiscard]] bool is_named(const Meeting& meeting) const {
    return names_starts_ || names_places_ || elements_[meeting.before].is_arc || elements_[meeting.after].is_arc;
  }
  template <class Lead>
  Pair meet(const Meeting& meeting, const Lead& lead);
  void outer_arc(const Meeting& meeting, Pair to);
  void lead(const Element& one, const Meeting& from, Pair start, Pair to);
  void move(StepKind kind, const Element& one, Pair to, Pair center);

  BodyReader& body_;
  Family& family_;
  Offset offset_;
  bool is_turned_;     // u is z, v is x
  bool names_starts_;  // each element's start has a name, whatever the corner is
  bool names_places_;  // of moves; what is turned would be too long for a block
  OffsetContour contour_;
  std::set<ir::SymbolId> changing_;
  Pair start_;
  std::size_t start_item_ = 0;
  std::uint32_t start_line_ = 0;
  std::vector<Element> elements_;
};

}  // namespace dripfeed::family

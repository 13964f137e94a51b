// rough [facing] [inside] x X z Z depth LENGTH retract LENGTH [allowance x LENGTH z LENGTH], the contour, end: passes
// from x X or z Z down to the contour, which is shifted by the allowances, and one along it.
//
//        x ^            X ___________________        Each pass is as deep as it may be, ends where it meets the
//          |        ___/____________________        contour, and leaves it at 45 degrees by `retract`. The contour
//          |    ___|  <--------------------         leads away from where the passes begin, so that a tool whose
//          |   |  <------------------------         edges lie above and right of its tip meets nothing that stays.
//          +------------------------------> z
#include <algorithm>
#include <set>
#include <utility>

#include "dialects/family/body_reader.h"
#include "dialects/family/evaluate.h"

namespace dripfeed::family {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Operator;

// Nearer than this a pass is at the height of a point of the contour; on the radius half of it.
constexpr double kSameLevel_mm = 0.0001;

bool passes_along_x(const RoughContour& contour) { return contour.is_facing; }
// Whether passes follow each other towards smaller values, and lead there.
bool steps_down(const RoughContour& contour) { return contour.is_facing || !contour.is_inside; }
bool leads_down(const RoughContour& contour) { return !(contour.is_facing && contour.is_inside); }
// Whether an arc's center lies beyond it as a pass leads.
bool center_is_beyond(const RoughContour& contour, bool clockwise) {
  return clockwise != (contour.is_inside != contour.is_facing);
}

}  // namespace

ExpressionId BodyReader::sum(Operator op, ExpressionId a, ExpressionId b) {
  Step like = step(StepKind::let);
  like.span = verb_;
  return VerbCopy(family_, scope_, like).calculated(op, a, b);
}

void BodyReader::open_if(Operator op, ExpressionId a, ExpressionId b) {
  Step out = step(StepKind::if_begin);
  out.values[0] = calculated(op, a, b);
  add(std::move(out));
}

// Of an offset, decided when the family gets its values.
void BodyReader::open_branch(ExpressionId condition) {
  Step out = step(StepKind::if_begin);
  out.number = kCornerBranch;
  out.values[0] = condition;
  add(std::move(out));
}

void BodyReader::set_name(ir::SymbolId target, ExpressionId value) {
  Step out = step(StepKind::set);
  out.target = target;
  out.values[0] = value;
  add(std::move(out));
}

void BodyReader::rough() {
  if (family_.machine == ir::MachineKind::mill)
    cursor_.syntax(verb_, "'rough' turns along a contour: on a mill 'face' and 'pocket' remove the material");
  else if (compensation_waits_ || compensated_)
    cursor_.syntax(verb_,
                   "'rough' keeps away from its contour by the allowances: compensate off, and a move, before it");
  else if (open_profiles_ > 0)
    cursor_.syntax(verb_, "'rough' leaves an allowance: a profile has only moves that make the nominal");
  else if (rough_)
    cursor_.syntax(verb_, "a 'rough' in the contour of another one");
  Rough read{.contour = {}, .head = step(StepKind::contour)};
  RoughContour& contour = read.contour;
  const auto length = [&](std::string_view name, ExpressionId& out) {
    if (!cursor_.line_failed() && cursor_.expect_word(name)) out = expressions_.value_of(kLength).id;
  };
  contour.is_facing = !cursor_.line_failed() && cursor_.accept_word("facing");
  contour.is_inside = !cursor_.line_failed() && cursor_.accept_word("inside");
  length("x", contour.x);
  length("z", contour.z);
  length("depth", contour.depth);
  length("retract", contour.retract);
  if (!cursor_.line_failed() && cursor_.accept_word("allowance")) {
    length("x", contour.allowance_x);
    length("z", contour.allowance_z);
  }
  contour.span = read.head.span = {verb_.begin, cursor_.last_span().end};
  read.first_step = steps_.size();
  const bool may = !cursor_.line_failed() && may_cut();
  open_.push_back({StepKind::contour, verb_, line_});
  scope_.open();
  if (may) rough_ = std::move(read);
}

void BodyReader::end_rough() {
  if (!rough_) return;
  Rough rough = *std::exchange(rough_, std::nullopt);
  const std::vector<Step> read(steps_.begin() + static_cast<std::ptrdiff_t>(rough.first_step), steps_.end());
  steps_.resize(rough.first_step);
  corner_waits_ = false;
  const text::Span end = std::exchange(verb_, rough.head.span);
  line_ = rough.head.line;
  std::vector<RoughPoint> points;
  if (text::has_error(cursor_.diagnostics) || !read_contour(rough, read, points)) return;
  if (points.size() < 2) return cursor_.syntax(end, "the contour of 'rough' has a cut to its start and one further");
  Step check = rough.head;
  check.number = static_cast<std::int32_t>(family_.contours.size());
  family_.contours.push_back(rough.contour);
  add(std::move(check));
  rough_passes(rough, points);
  for (std::size_t i = rough.first_step; i < steps_.size(); ++i) steps_[i].span = rough.head.span;
}

// Its lets become steps, its moves points. What an offset in it decides stays around its lets, which give the same
// names a value whatever is decided, and around its moves.
bool BodyReader::read_contour(Rough& rough, const std::vector<Step>& steps, std::vector<RoughPoint>& points) {
  rough.changing = assigned_twice(steps);
  ExpressionId when = ExpressionId::none;
  const auto keep = [this](Step one) {
    one.line = line_;
    steps_.push_back(std::move(one));
  };
  for (std::size_t at = 0; at < steps.size(); ++at) {
    const Step& one = steps[at];
    if (one.kind == StepKind::let) {
      rough.contour.items.push_back({.target = one.target, .value = one.values[0], .when = when, .span = one.span});
      keep(one);
    } else if (one.kind == StepKind::if_begin) {
      when = one.values[0];
      if (steps[at + 1].kind == StepKind::let) keep(one);
    } else if (one.kind == StepKind::if_end) {
      when = ExpressionId::none;
      if (steps[at - 1].kind == StepKind::let) keep(one);
    } else if (one.kind == StepKind::offset) {
      keep(one);
    } else {
      if (!add_point(rough, one, points)) return false;
      rough.contour.items.back().when = points.back().when = when;
    }
  }
  return true;
}

// Names whose value another line of the contour changes.
std::set<ir::SymbolId> BodyReader::assigned_twice(const std::vector<Step>& steps) {
  std::set<ir::SymbolId> once;
  std::set<ir::SymbolId> out;
  bool in_branch = false;
  for (const Step& one : steps) {
    if (one.kind == StepKind::if_begin || one.kind == StepKind::if_end) in_branch = one.kind == StepKind::if_begin;
    if (one.kind == StepKind::let && !in_branch && !once.insert(one.target).second) out.insert(one.target);
  }
  return out;
}

bool BodyReader::names_one(const std::set<ir::SymbolId>& symbols, ExpressionId value) const {
  return std::ranges::any_of(symbols, [&](ir::SymbolId one) { return names(family_.arena, value, one); });
}

bool BodyReader::add_point(Rough& rough, const Step& step, std::vector<RoughPoint>& points) {
  RoughContour& contour = rough.contour;
  const auto last = std::ranges::find_if(contour.items.rbegin(), contour.items.rend(),
                                         [](const auto& one) { return one.target == ir::SymbolId::none; });
  RoughContour::Item item{.x = contour.x, .z = contour.z, .span = step.span};
  if (last != contour.items.rend()) {
    item.x = last->x;
    item.z = last->z;
  }
  RoughPoint point{.moves_x = points.empty(), .moves_z = points.empty(), .line = step.line};
  item.is_arc = point.is_arc = step.kind != StepKind::cut;
  item.clockwise = point.clockwise = step.kind == StepKind::arc_cw;
  for (std::uint32_t n = 0; n < step.word_count; ++n) {
    const StepWord word = family_.words[step.first_word + n];
    const auto place = [&](ExpressionId& at, bool& moves) {
      at = word.is_step ? sum(Operator::add, at, word.value) : word.value;
      moves = true;
    };
    if (word.address == Address::x)
      place(item.x, point.moves_x);
    else if (word.address == Address::z)
      place(item.z, point.moves_z);
    else if (word.address == Address::i)
      item.i = point.i = word.value;
    else if (word.address == Address::k)
      item.k = point.k = word.value;
    else if (word.address == Address::arc_radius)
      item.radius = point.radius = word.value;
    else
      return cursor_.syntax(step.span,
                            "in the contour of 'rough' a cut or an arc has x and z alone: a chamfer or a "
                            "rounding is a cut or an arc of its own"),
             false;
  }
  if (points.empty() && point.is_arc)
    return cursor_.syntax(step.span, "the contour of 'rough' begins with a cut to its start"), false;
  contour.items.push_back(item);
  for (ExpressionId* one : {&point.i, &point.k, &point.radius})
    if (*one != ExpressionId::none && names_one(rough.changing, *one)) *one = kept("contour_arc", *one, kLength);
  point.x = point.moves_x ? point_value(rough, "contour_x", item.x, true) : points.back().x;
  point.z = point.moves_z ? point_value(rough, "contour_z", item.z, false) : points.back().z;
  if (point.is_arc) find_center(point, points.back());
  points.push_back(point);
  return true;
}

// With the allowance, under a name where it is not a number or a name that stays.
ExpressionId BodyReader::point_value(const Rough& rough, std::string_view stem, ExpressionId value, bool is_x) {
  const ExpressionId allowance = is_x ? rough.contour.allowance_x : rough.contour.allowance_z;
  if (allowance != ExpressionId::none) {
    const bool outward = !is_x || !rough.contour.is_inside;
    const ExpressionId along = is_x && family_.x_is_diameter
                                   ? sum(Operator::multiply, family_.arena.add_constant(2.0, verb_), allowance)
                                   : allowance;
    value = sum(outward ? Operator::add : Operator::subtract, value, along);
  }
  Step like = step(StepKind::let);
  like.span = verb_;
  if (!names_one(rough.changing, value) && VerbCopy(family_, scope_, like).is_simple(value)) return value;
  return kept(stem, value, kLength);
}

// Where passes meet an arc depends on its center. Of a radius it is found from both ends:
//   i = dx/2 -+ dz*w,  k = dz/2 +- dx*w,  w = sqrt(r^2/(dx^2 + dz^2) - 1/4), the upper sign for clockwise
void BodyReader::find_center(RoughPoint& point, const RoughPoint& before) {
  const auto number = [&](double value) { return family_.arena.add_constant(value, verb_); };
  ExpressionId i = point.i;
  ExpressionId k = point.k;
  if (point.radius != ExpressionId::none) {
    const ExpressionId across = sum(Operator::subtract, point.x, before.x);
    const ExpressionId dx =
        kept("arc_dx", family_.x_is_diameter ? sum(Operator::divide, across, number(2.0)) : across, kLength);
    const ExpressionId dz = kept("arc_dz", sum(Operator::subtract, point.z, before.z), kLength);
    const auto square = [&](ExpressionId one) { return calculated(Operator::multiply, one, one); };
    const ExpressionId share =
        calculated(Operator::divide, square(point.radius), calculated(Operator::add, square(dx), square(dz)));
    const ExpressionId w = kept(
        "arc_w",
        calculated(Operator::sqrt,
                   calculated(Operator::abs, calculated(Operator::subtract, share, number(0.25)), ExpressionId::none),
                   ExpressionId::none),
        kRatio);
    const auto half = [&](ExpressionId one) { return calculated(Operator::divide, one, number(2.0)); };
    const auto turned = [&](ExpressionId one) { return calculated(Operator::multiply, one, w); };
    i = calculated(point.clockwise ? Operator::subtract : Operator::add, half(dx), turned(dz));
    k = calculated(point.clockwise ? Operator::add : Operator::subtract, half(dz), turned(dx));
  }
  const auto center = [&](std::string_view stem, ExpressionId start, ExpressionId offset) {
    if (offset == ExpressionId::none) return start;
    const ExpressionId value = sum(Operator::add, start, offset);
    return family_.arena.at(value).op == Operator::constant ? value : kept(stem, value, kLength);
  };
  const bool doubles = family_.x_is_diameter && i != ExpressionId::none;
  point.center_x = center("arc_x", before.x, doubles ? sum(Operator::multiply, number(2.0), i) : i);
  point.center_z = center("arc_z", before.z, k);
}

// From the first height to the contour's start, each as deep as it may be.
void BodyReader::rough_passes(const Rough& rough, const std::vector<RoughPoint>& points) {
  const RoughContour& contour = rough.contour;
  const bool along_x = passes_along_x(contour);
  const Address level_axis = along_x ? Address::z : Address::x;
  const Address pass_axis = along_x ? Address::x : Address::z;
  const ExpressionId begin = along_x ? contour.x : contour.z;
  const ExpressionId lowest = along_x ? points.front().z : points.front().x;
  const ExpressionId deep = along_x || !family_.x_is_diameter
                                ? contour.depth
                                : sum(Operator::multiply, family_.arena.add_constant(2.0, verb_), contour.depth);
  const bool down = steps_down(contour);
  move_to(StepKind::rapid, Address::x, contour.x);
  move_to(StepKind::rapid, Address::z, contour.z);
  Step loop = hidden_loop(along_x ? "rough_z" : "rough_x", kLength);
  loop.down = down;
  loop.values[0] =
      calculated(down ? Operator::maximum : Operator::minimum,
                 sum(down ? Operator::subtract : Operator::add, along_x ? contour.z : contour.x, deep), lowest);
  loop.values[1] = lowest;
  loop.values[2] = deep;
  const ExpressionId level = name_of(loop);
  add(std::move(loop));
  move_to(StepKind::rapid, level_axis, level);
  const ExpressionId end = pass_end(rough, points, level);
  move_to(StepKind::cut, pass_axis, end);
  leave_rough(rough, along_x ? end : level, along_x ? level : end);
  move_to(StepKind::rapid, pass_axis, begin);
  end_hidden_loop();
  move_to(StepKind::rapid, level_axis, lowest);
  last_rough_pass(rough, points);
  move_to(StepKind::rapid, pass_axis, begin);
}

// Away from the contour at 45 degrees, from a place at it.
void BodyReader::leave_rough(const Rough& rough, ExpressionId x, ExpressionId z) {
  const RoughContour& contour = rough.contour;
  const ExpressionId on_x = family_.x_is_diameter
                                ? sum(Operator::multiply, family_.arena.add_constant(2.0, verb_), contour.retract)
                                : contour.retract;
  Step out = step(StepKind::rapid);
  word(out, Address::x, {.id = sum(contour.is_inside ? Operator::subtract : Operator::add, x, on_x)});
  word(out, Address::z, {.id = sum(Operator::add, z, contour.retract)});
  add(std::move(out));
}

// Where a pass at this height ends. As far as that is the same for all of them it takes no steps.
ExpressionId BodyReader::pass_end(const Rough& rough, const std::vector<RoughPoint>& points, ExpressionId level) {
  const bool along_x = passes_along_x(rough.contour);
  const auto climbs = [&](const RoughPoint& one) { return along_x ? one.moves_z : one.moves_x; };
  const auto leads = [&](const RoughPoint& one) { return along_x ? one.moves_x : one.moves_z; };
  std::size_t n = 1;
  while (n < points.size() && !climbs(points[n])) ++n;
  const ExpressionId first = along_x ? points[n - 1].x : points[n - 1].z;
  if (std::none_of(points.begin() + static_cast<std::ptrdiff_t>(n), points.end(), leads)) return first;
  Step end = step(StepKind::let);
  end.target = scope_.define(family_.arena, unused_name(along_x ? "pass_end_x" : "pass_end_z"), kLength, verb_,
                             NameKind::variable);
  end.values[0] = first;
  add(end);
  for (; n < points.size(); ++n) {
    if (!leads(points[n])) continue;
    if (points[n].when != ExpressionId::none) open_branch(points[n].when);
    pass_end_at(rough, points[n - 1], points[n], level, end);
    if (points[n].when != ExpressionId::none) add(step(StepKind::if_end));
  }
  return name_of(end);
}

// if the pass is at the height of `from` or beyond it: end = to, but where it meets the line or arc between them
void BodyReader::pass_end_at(const Rough& rough, const RoughPoint& from, const RoughPoint& to, ExpressionId level,
                             const Step& end) {
  const RoughContour& contour = rough.contour;
  const bool along_x = passes_along_x(contour);
  const bool down = steps_down(contour);
  const auto number = [&](double value) { return family_.arena.add_constant(value, verb_); };
  const auto height = [&](const RoughPoint& one) { return along_x ? one.z : one.x; };
  const auto place = [&](const RoughPoint& one) { return along_x ? one.x : one.z; };
  const auto limit = [&](const RoughPoint& one) {
    return sum(down ? Operator::subtract : Operator::add, height(one), number(kSameLevel_mm));
  };
  open_if(down ? Operator::greater_equal : Operator::less_equal, level, limit(from));
  set_name(end.target, place(to));
  if (along_x ? to.moves_z : to.moves_x) {
    open_if(down ? Operator::less : Operator::greater, level, limit(to));
    const auto minus = [&](ExpressionId a, ExpressionId b) { return sum(Operator::subtract, a, b); };
    if (!to.is_arc) {
      const ExpressionId part = calculated(
          Operator::divide, calculated(Operator::multiply, minus(level, height(from)), minus(place(to), place(from))),
          minus(height(to), height(from)));
      set_name(end.target, calculated(Operator::add, place(from), part));
    } else {
      const auto on_radius = [&](ExpressionId value, bool is_x, Operator op) {
        return is_x && family_.x_is_diameter ? calculated(op, value, number(2.0)) : value;
      };
      const auto square = [&](ExpressionId one) { return calculated(Operator::multiply, one, one); };
      ExpressionId radius = to.radius;
      if (radius != ExpressionId::none)
        radius = square(radius);
      else if (to.i != ExpressionId::none && to.k != ExpressionId::none)
        radius = calculated(Operator::add, square(to.i), square(to.k));
      else
        radius = square(to.i == ExpressionId::none ? to.k : to.i);
      const ExpressionId off = minus(level, along_x ? to.center_z : to.center_x);
      const ExpressionId rest =
          calculated(Operator::subtract, radius, square(on_radius(off, !along_x, Operator::divide)));
      const ExpressionId reach =
          calculated(Operator::sqrt, calculated(Operator::abs, rest, ExpressionId::none), ExpressionId::none);
      const bool adds = center_is_beyond(contour, to.clockwise) != leads_down(contour);
      set_name(end.target, calculated(adds ? Operator::add : Operator::subtract, along_x ? to.center_x : to.center_z,
                                      on_radius(reach, along_x, Operator::multiply)));
    }
    add(step(StepKind::if_end));
  }
  add(step(StepKind::if_end));
}

// Along the whole contour, at its own lines.
void BodyReader::last_rough_pass(const Rough& rough, const std::vector<RoughPoint>& points) {
  const std::uint32_t line = line_;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const RoughPoint& one = points[n];
    line_ = one.line;
    Step out = step(!one.is_arc ? StepKind::cut : one.clockwise ? StepKind::arc_cw : StepKind::arc_ccw);
    if (n == 0) {
      word(out, passes_along_x(rough.contour) ? Address::x : Address::z,
           {.id = passes_along_x(rough.contour) ? one.x : one.z});
    } else {
      if (one.moves_x || one.is_arc) word(out, Address::x, {.id = one.x});
      if (one.moves_z || one.is_arc) word(out, Address::z, {.id = one.z});
    }
    if (one.i != ExpressionId::none) word(out, Address::i, {.id = one.i});
    if (one.k != ExpressionId::none) word(out, Address::k, {.id = one.k});
    if (one.radius != ExpressionId::none) word(out, Address::arc_radius, {.id = one.radius});
    if (one.when != ExpressionId::none) open_branch(one.when);
    add(std::move(out));
    if (one.when != ExpressionId::none) add(step(StepKind::if_end));
  }
  line_ = line;
  leave_rough(rough, points.back().x, points.back().z);
}

}  // namespace dripfeed::family

// Verbs of mills that stand for many moves, in the language of families itself: a subprogram each. What its values must
// fulfil stands in functions of the same parameters.
#pragma once

#include <string_view>

namespace dripfeed::family {

// `feed entry_feed` is in effect from there to `feed feed_before`, and is left out where no entry has a feed of its
// own. Lengths are those of the part: a cutter's diameter is allowed for here.
inline constexpr std::string_view kVerbTexts = R"(family verbs
machine mill

const gap = 0.5 mm

# --- face: passes there and back across a rectangle, in layers; every pass leaves the rectangle at both ends
function face_leads_down(top length, bottom length) = bottom < top
function is_positive(value_here length) = value_here > 0 mm
function is_in_order(first length, last length) = first < last
function face_overlaps(stepover length, cutter length) = stepover <= 0.95*cutter + 0.0001 mm
function is_above(clear length, top length) = clear > top

sub face(first_x length, last_x length, first_y length, last_y length, top length, bottom length, layer_depth length, stepover length, beyond length, clear length, cutter length)
  let start = first_x - cutter/2 - beyond
  let far = last_x + cutter/2 + beyond
  let first_row = first_y - cutter/2 + stepover        # the cutter's edge is one width inside
  let last_row = max(last_y - cutter/2, first_row)
  let side = start
  rapid z clear
  for level from max(top - layer_depth, bottom) down to bottom step layer_depth
    rapid x side  y first_row
    rapid z level
    for row from first_row to last_row step stepover
      cut y row
      set side = start + far - side
      cut x side
    end
    rapid z clear
  end
end

# The same, each move with both x and y, as moves that are turned have them.
sub face_turned(first_x length, last_x length, first_y length, last_y length, top length, bottom length, layer_depth length, stepover length, beyond length, clear length, cutter length)
  let start = first_x - cutter/2 - beyond
  let far = last_x + cutter/2 + beyond
  let first_row = first_y - cutter/2 + stepover
  let last_row = max(last_y - cutter/2, first_row)
  let side = start
  rapid z clear
  for level from max(top - layer_depth, bottom) down to bottom step layer_depth
    rapid x side  y first_row
    rapid z level
    for row from first_row to last_row step stepover
      cut x side  y row
      set side = start + far - side
      cut x side  y row
    end
    rapid z clear
  end
end

# --- pocket: from the middle outward in rings, and once around the wall at full depth, in and out on quarter circles
# Between two rings that are a stepover s apart nothing is left along their sides while s <= 2*r, r the cutter's radius.
# At a sharp corner the inner ring, whose corner is (0, 0), clears what is within r of it, and the outer ring, whose
# corner is (s, s), all with x or y above s - r. The farthest place between them is (s - r, s - r): it is cleared while
# (s - r)*sqrt(2) <= r, which is s <= (1 + sqrt(0.5))*r = 0.8535*cutter. Where the outer corner is round with a radius q
# above r, the farthest place is nearer, at (s - q)*sqrt(2) + q - r. Rings around a center have no corner.
function pocket_overlaps(stepover length, cutter length) = stepover <= 0.85*cutter + 0.0001 mm
function rings_overlap(stepover length, cutter length) = stepover <= 0.95*cutter + 0.0001 mm
function is_above_gap(clear length, top length) = clear >= top + gap
function entry_descends(entry_angle angle) = entry_angle > 0 deg and entry_angle <= 45 deg
function corner_takes(corner_radius length, cutter length) = corner_radius >= cutter/2 - 0.0001 mm
function corners_fit(size_x length, size_y length, corner_radius length) = 2*corner_radius <= min(size_x, size_y) + 0.0001 mm
function pass_fits(size_x length, size_y length, cutter length, finish length) = min(size_x, size_y) - cutter >= 6*finish - 0.0001 mm
function helix_fits(size_x length, size_y length, cutter length, finish length) = min(size_x, size_y)/2 - cutter/2 - finish >= 0.1*cutter - 0.0001 mm
function ramp_fits(size_x length, size_y length, cutter length) = abs(size_x - size_y) >= cutter - 0.0001 mm

sub around(at_x length, at_y length, half_x length, half_y length, turn length)
  cut x at_x + half_x  y at_y + half_y - turn
  if turn > 0.001 mm
    arc ccw x at_x + half_x - turn  y at_y + half_y  center i -turn  j 0 mm
  end
  cut x at_x + turn - half_x  y at_y + half_y
  if turn > 0.001 mm
    arc ccw x at_x - half_x  y at_y + half_y - turn  center i 0 mm  j -turn
  end
  cut x at_x - half_x  y at_y + turn - half_y
  if turn > 0.001 mm
    arc ccw x at_x + turn - half_x  y at_y - half_y  center i turn  j 0 mm
  end
  cut x at_x + half_x - turn  y at_y - half_y
  if turn > 0.001 mm
    arc ccw x at_x + half_x  y at_y + turn - half_y  center i 0 mm  j turn
  end
  cut x at_x + half_x  y at_y
end

sub helix(at_x length, at_y length, helix_radius length, above length, level length, entry_angle angle, entry_feed feed mm/min, feed_before feed mm/min)
  cut x at_x + helix_radius  y at_y
  feed entry_feed
  let turns = max(trunc((above - level)/(2*pi*helix_radius*tan(entry_angle)) + 0.9999), 1)
  for n from 1 to turns step 1
    arc ccw x at_x + helix_radius  y at_y  z above - (above - level)*n/turns  center i -helix_radius  j 0 mm
  end
  feed feed_before
  arc ccw x at_x + helix_radius  y at_y  center i -helix_radius  j 0 mm
end

sub rings(at_x length, at_y length, wall_x length, wall_y length, wall_turn length, inside length, finish length, stepover length)
  for inset from inside down to finish step stepover
    cut x at_x + wall_x - inset  y at_y
    call around(at_x, at_y, wall_x - inset, wall_y - inset, max(wall_turn - inset, 0 mm))
  end
end

sub wall(at_x length, at_y length, wall_x length, wall_y length, wall_turn length, lead length)
  cut x at_x + wall_x - lead  y at_y - lead
  arc ccw x at_x + wall_x  y at_y  center i 0 mm  j lead
  call around(at_x, at_y, wall_x, wall_y, wall_turn)
  arc ccw x at_x + wall_x - lead  y at_y + lead  center i -lead  j 0 mm
end

sub pocket_by_helix(at_x length, at_y length, size_x length, size_y length, corner_radius length, top length, bottom length, layer_depth length, stepover length, finish length, entry_angle angle, clear length, cutter length, entry_feed feed mm/min, feed_before feed mm/min)
  let wall_x = (size_x - cutter)/2                     # of the cutter's center
  let wall_y = (size_y - cutter)/2
  let wall_turn = max(corner_radius - cutter/2, 0 mm)
  let inside = min(wall_x, wall_y)                     # from the wall to the line in the middle
  let helix_radius = min(0.4*cutter, inside - finish)
  let lead = min(cutter/2, inside - finish)
  rapid z clear
  rapid x at_x + helix_radius  y at_y
  rapid z top + gap
  let above = top + gap
  for level from max(top - layer_depth, bottom) down to bottom step layer_depth
    call helix(at_x, at_y, helix_radius, above, level, entry_angle, entry_feed, feed_before)
    call rings(at_x, at_y, wall_x, wall_y, wall_turn, inside, finish, stepover)
    set above = level
  end
  call wall(at_x, at_y, wall_x, wall_y, wall_turn, lead)
  rapid z clear
end

sub pocket_by_ramp(at_x length, at_y length, size_x length, size_y length, corner_radius length, top length, bottom length, layer_depth length, stepover length, finish length, entry_angle angle, clear length, cutter length, entry_feed feed mm/min, feed_before feed mm/min)
  let wall_x = (size_x - cutter)/2
  let wall_y = (size_y - cutter)/2
  let wall_turn = max(corner_radius - cutter/2, 0 mm)
  let inside = min(wall_x, wall_y)
  let line_x = wall_x - inside                         # the line in the middle: one of them is 0
  let line_y = wall_y - inside
  let lead = min(cutter/2, inside - finish)
  rapid z clear
  rapid x at_x + line_x  y at_y + line_y
  rapid z top + gap
  let above = top + gap
  for level from max(top - layer_depth, bottom) down to bottom step layer_depth
    cut x at_x + line_x  y at_y + line_y
    feed entry_feed
    let passes = max(trunc((above - level)/(2*(line_x + line_y)*tan(entry_angle)) + 0.9999), 1)
    let side = 1
    for n from 1 to passes step 1
      set side = -side
      cut x at_x + side*line_x  y at_y + side*line_y  z above - (above - level)*n/passes
    end
    feed feed_before
    call rings(at_x, at_y, wall_x, wall_y, wall_turn, inside, finish, stepover)
    set above = level
  end
  call wall(at_x, at_y, wall_x, wall_y, wall_turn, lead)
  rapid z clear
end

sub pocket_round(at_x length, at_y length, pocket_diameter length, top length, bottom length, layer_depth length, stepover length, finish length, entry_angle angle, clear length, cutter length, entry_feed feed mm/min, feed_before feed mm/min)
  let wall = (pocket_diameter - cutter)/2              # of the cutter's center
  let helix_radius = min(0.4*cutter, wall - finish)
  let lead = min(cutter/2, wall - finish)
  let last_ring = wall - finish
  rapid z clear
  rapid x at_x + helix_radius  y at_y
  rapid z top + gap
  let above = top + gap
  for level from max(top - layer_depth, bottom) down to bottom step layer_depth
    call helix(at_x, at_y, helix_radius, above, level, entry_angle, entry_feed, feed_before)
    for ring from min(helix_radius + stepover, last_ring) to last_ring step stepover
      cut x at_x + ring  y at_y
      arc ccw x at_x + ring  y at_y  center i -ring  j 0 mm
    end
    set above = level
  end
  cut x at_x + wall - lead  y at_y - lead
  arc ccw x at_x + wall  y at_y  center i 0 mm  j lead
  arc ccw x at_x + wall  y at_y  center i -wall  j 0 mm
  arc ccw x at_x + wall - lead  y at_y + lead  center i -lead  j 0 mm
  rapid z clear
end

program none
end
)";

}  // namespace dripfeed::family

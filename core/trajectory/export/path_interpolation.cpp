// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/export/path_interpolation.h"

namespace dewpoint::trajectory {
namespace {

Eigen::Vector3d slope(const TimedPosition& a, const TimedPosition& b) {
  return (b.position - a.position) / (b.time - a.time);
}

/// Slope at `b` of the parabola through three places.
Eigen::Vector3d middleSlope(const TimedPosition& a, const TimedPosition& b,
                            const TimedPosition& c) {
  return (slope(a, b) * (c.time - b.time) + slope(b, c) * (b.time - a.time)) / (c.time - a.time);
}

} // namespace

Eigen::Vector3d interpolatedPosition(const std::optional<TimedPosition>& before,
                                     const TimedPosition& begin, const TimedPosition& end,
                                     const std::optional<TimedPosition>& after, double time) {
  const Eigen::Vector3d chord = slope(begin, end);
  std::optional<Eigen::Vector3d> first;
  std::optional<Eigen::Vector3d> last;
  if (before) {
    first = middleSlope(*before, begin, end);
  }
  if (after) {
    last = middleSlope(begin, end, *after);
  }
  // Without a neighbor: the slope of the parabola that the other side gives, or the chord's.
  const Eigen::Vector3d atBegin = first ? *first : last ? 2.0 * chord - *last : chord;
  const Eigen::Vector3d atEnd = last ? *last : first ? 2.0 * chord - *first : chord;
  const double length = end.time - begin.time;
  const double s = (time - begin.time) / length;
  const double s2 = s * s;
  const double s3 = s2 * s;
  return (2.0 * s3 - 3.0 * s2 + 1.0) * begin.position + (s3 - 2.0 * s2 + s) * length * atBegin +
         (3.0 * s2 - 2.0 * s3) * end.position + (s3 - s2) * length * atEnd;
}

} // namespace dewpoint::trajectory

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/people/person_shape.h"

#include "core/tracking/people/people_volume.h"

#include <algorithm>

namespace dewpoint::session {
namespace {

BodyCloud thinned(const BodyCloud& body) {
  const Eigen::Index count = body.points.rows();
  const Eigen::Index kept = std::min<Eigen::Index>(count, kMaxShapePoints);
  BodyCloud result{Eigen::ArrayXXd(kept, 3), Eigen::ArrayXd(kept)};
  for (Eigen::Index i = 0; i < kept; ++i) {
    result.points.row(i) = body.points.row(i * count / kept);
    result.weights[i] = body.weights[i * count / kept];
  }
  const double sum = result.weights.sum();
  if (sum > 0.0) {
    result.weights /= sum;
  }
  return result;
}

} // namespace

PersonShape personShape(const BodyCloud& body) {
  PersonShape shape;
  if (body.points.rows() == 0) {
    return shape;
  }
  const BodyCloud shown = thinned(body);
  shape.hull = bodyHull(shown);
  shape.volume = shape.hull.volume();
  const GroundGrid density = groundDensity(shown);
  for (const double share : kGroundProbabilities) {
    shape.groundCurves.push_back(levelCurves(density, levelForProbability(density, share)));
  }
  return shape;
}

} // namespace dewpoint::session

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/people/walker.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::simulation {
namespace {

// How people walk: round numbers for an adult who does not hurry.
constexpr double kRounding = 0.4;       ///< seconds over which corners of the way are rounded off
constexpr double kStrideLength = 1.4;   ///< meters of two steps
constexpr double kUsualSpeed = 1.2;     ///< m/s at which limbs swing fully
constexpr double kStandingSpeed = 0.05; ///< m/s below which somebody stands

// The body of kReferenceHeight that all are scaled from: heights of its points in meters, chosen
// within the usual proportions of adults.
constexpr float kHeadTop = 1.735F;
constexpr float kHairTop = 1.755F;
constexpr float kHeadHalf = 0.125F; ///< half the height of the head
constexpr float kHips = 0.90F;
constexpr float kThighLength = 0.44F;
constexpr float kShinLength = 0.44F;
/// Height of a fitting seat: the lower side of the thighs of somebody of 1.75 m who sits.
constexpr double kReferenceSeat = 0.41;

/// See headHeightFraction(): of a height of kSmallHeight and less, a child of two or three.
constexpr double kChildHeadShare = 0.19;
constexpr double kSmallHeight = 0.9; ///< meters

Eigen::Vector2d onWay(const std::vector<Waypoint>& way, double time) {
  const auto after = std::ranges::upper_bound(way, time, {}, &Waypoint::time);
  if (after == way.begin()) {
    return way.front().position;
  }
  if (after == way.end()) {
    return way.back().position;
  }
  const Waypoint& before = *(after - 1);
  const double part = (time - before.time) / (after->time - before.time);
  return before.position + part * (after->position - before.position);
}

/// Distance gone since the first waypoint, meters.
double gone(const std::vector<Waypoint>& way, double time) {
  double sum = 0.0;
  for (std::size_t k = 1; k < way.size() && way[k - 1].time < time; ++k) {
    const double end = std::min(time, way[k].time);
    const double length = (way[k].position - way[k - 1].position).norm();
    sum += length * (end - way[k - 1].time) / (way[k].time - way[k - 1].time);
  }
  return sum;
}

/// How a body stands: its own axes (forward, left, up) and size.
struct Stance {
  Vector3f foot;
  Eigen::Matrix3f axes; ///< rows: forward, left, up
  float scale = 1.0F;

  Vector3f at(float forward, float left, float up) const {
    return foot + axes.transpose() * (scale * Vector3f{forward, left, up});
  }
};

/// How much larger the head is than an adult's would be on a body of `height` meters.
float headGrowth(double height) {
  return static_cast<float>(headHeightFraction(height) / kAdultHeadHeightFraction);
}

/// How much shorter everything below a head is that is `head` times as large.
float lengthBelow(float head) {
  return 1.0F - 2.0F * kHeadHalf * (head - 1.0F) / (kHeadTop - 2.0F * kHeadHalf);
}

/// A body in its posture. What it is made of is given as of somebody of 1.75 m who stands.
struct Figure {
  Stance stance;
  JointAngles angles;
  float head = 1.0F;  ///< see headGrowth()
  float below = 1.0F; ///< see lengthBelow()

  Figure(const Stance& theStance, const JointAngles& theAngles, double height)
      : stance(theStance), angles(theAngles), head(headGrowth(height)), below(lengthBelow(head)) {}

  float hips() const {
    const float thigh = kThighLength * (1.0F - std::cos(angles.thigh));
    const float shin = kShinLength * (1.0F - std::cos(angles.shin));
    return kHips * below - below * (thigh + shin);
  }
  /// A point that moves with the trunk: of the body that stands, `up` meters above its feet.
  Vector3f onTrunk(float forward, float left, float up) const {
    if (angles.isUpright()) {
      return stance.at(forward, left, up);
    }
    const float c = std::cos(angles.lean);
    const float s = std::sin(angles.lean);
    const float above = up - kHips * below;
    return stance.at(c * forward + s * above, left, hips() + c * above - s * forward);
  }
  Eigen::Matrix3f trunkAxes() const {
    if (angles.isUpright()) {
      return stance.axes;
    }
    const float c = std::cos(angles.lean);
    const float s = std::sin(angles.lean);
    Eigen::Matrix3f axes = stance.axes;
    axes.row(0) = c * stance.axes.row(0) - s * stance.axes.row(2);
    axes.row(2) = s * stance.axes.row(0) + c * stance.axes.row(2);
    return axes;
  }
};

/// A limb that hangs from `joint`, swung forward by `angle`; returns where it ends.
Vector3f addLimb(const Stance& stance, const Vector3f& joint, float length, float thickness,
                 float angle, const Vector3f& color, std::vector<BodyPart>& parts) {
  const Vector3f forward = stance.axes.row(0);
  const Vector3f up = stance.axes.row(2);
  const Vector3f along = std::sin(angle) * forward - std::cos(angle) * up;
  const Vector3f end = joint + stance.scale * length * along;
  BodyPart part;
  part.center = 0.5F * (joint + end);
  part.halfSize = stance.scale * Vector3f{thickness, thickness, 0.55F * length};
  part.axes.row(2) = along;
  part.axes.row(1) = stance.axes.row(1);
  part.axes.row(0) = Vector3f(part.axes.row(1)).cross(along);
  part.color = color;
  parts.push_back(part);
  return end;
}

void addHeadAndTrunk(const Figure& figure, const Clothes& wears, std::vector<BodyPart>& parts) {
  const Stance& stance = figure.stance;
  const float growth = figure.head - 1.0F;
  const auto part = [&](const Vector3f& center, const Vector3f& half, const Eigen::Matrix3f& axes,
                        const Vector3f& color) -> BodyPart& {
    return parts.emplace_back(BodyPart{center, stance.scale * half, axes, color});
  };
  part(figure.onTrunk(0.0F, 0.0F, 1.61F - kHeadHalf * growth),
       figure.head * Vector3f{0.095F, 0.08F, kHeadHalf}, stance.axes, wears.skin);
  part(figure.onTrunk(-0.02F, 0.0F, 1.655F - 0.1F * growth),
       figure.head * Vector3f{0.095F, 0.085F, 0.1F}, stance.axes, wears.hair);
  const Eigen::Matrix3f axes = figure.trunkAxes();
  part(figure.onTrunk(0.0F, 0.0F, 1.21F * figure.below), {0.125F, 0.195F, 0.29F * figure.below},
       axes, wears.shirt)
      .cloth = wears.shirtCloth;
  part(figure.onTrunk(0.0F, 0.0F, 0.93F * figure.below), {0.12F, 0.165F, 0.15F * figure.below},
       axes, wears.trousers);
}

void addLimbs(const Figure& figure, const Walker& walker, float swing,
              std::vector<BodyPart>& parts) {
  constexpr float kElbow = 0.35F; // radians: arms hang a little bent
  // Arms that hold a box, further forward than hanging ones, radians.
  constexpr float kHoldArm = 0.15F;
  constexpr float kHoldForearm = 1.0F;
  const Stance& stance = figure.stance;
  const JointAngles& angles = figure.angles;
  const Clothes& wears = walker.clothes;
  const bool holdsBox =
      walker.carriedObject && walker.carriedObject->kind == CarriedObject::Kind::Box;
  for (const float side : {-1.0F, 1.0F}) {
    const float leg = side * swing;
    const Vector3f knee =
        addLimb(stance, stance.at(0.0F, 0.09F * side, figure.hips()), kThighLength * figure.below,
                0.08F, leg + angles.thigh, wears.trousers, parts);
    addLimb(stance, knee, kShinLength * figure.below, 0.055F,
            leg - 0.5F * std::abs(swing) + angles.shin, wears.trousers, parts);
    const float armSwing = walker.carriedObject ? 0.0F : -0.8F * leg;
    const float arm = armSwing + angles.arm + (holdsBox ? kHoldArm : 0.0F);
    const float forearm =
        armSwing + kElbow + angles.arm + angles.forearm + (holdsBox ? kHoldForearm : 0.0F);
    const Vector3f elbow =
        addLimb(stance, figure.onTrunk(0.0F, 0.225F * side, 1.43F * figure.below),
                0.30F * figure.below, 0.05F, arm, wears.shirt, parts);
    parts.back().cloth = wears.shirtCloth;
    addLimb(stance, elbow, 0.28F * figure.below, 0.04F, forearm, wears.shirt, parts);
    parts.back().cloth = wears.shirtCloth;
  }
}

void addLoad(const Figure& figure, const CarriedObject& load, std::vector<BodyPart>& parts) {
  constexpr float kGap = 0.01F; // meters between the box and the chest
  const Vector3f forward = figure.stance.axes.row(0);
  const Vector3f up = figure.stance.axes.row(2);
  BodyPart part;
  if (load.kind == CarriedObject::Kind::Box) {
    const float reach = figure.stance.scale * 0.125F + kGap + load.halfSize.x();
    part.center = figure.onTrunk(0.0F, 0.0F, 1.10F * figure.below) + reach * forward;
  } else {
    part.center = figure.onTrunk(0.02F, -0.26F, 0.86F * figure.below) - load.halfSize.z() * up;
  }
  part.halfSize = load.halfSize;
  part.axes = figure.stance.axes;
  part.color = load.color;
  part.shape = PartShape::Box;
  part.belongsToBody = false;
  parts.push_back(part);
}

/// How high the highest point of an ellipsoid is.
float topOf(const BodyPart& part) {
  return part.center.z() + part.halfSize.cwiseProduct(part.axes.col(2)).norm();
}

} // namespace

double headHeightFraction(double height) {
  const double grown =
      std::clamp((height - kSmallHeight) / (kAdultHeight - kSmallHeight), 0.0, 1.0);
  return grown >= 1.0 ? kAdultHeadHeightFraction
                      : kChildHeadShare + grown * (kAdultHeadHeightFraction - kChildHeadShare);
}

double seatHeight(double height) {
  return kReferenceSeat * height / kReferenceHeight *
         static_cast<double>(lengthBelow(headGrowth(height)));
}

Eigen::Vector2d Walker::positionAt(double time) const {
  constexpr int kSamples = 9; // of the rounding, odd: one at the time itself
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int k = 0; k < kSamples; ++k) {
    sum += onWay(waypoints, time + kRounding * ((k + 0.5) / kSamples - 0.5));
  }
  return sum / kSamples;
}

double Walker::topHeightAt(double time) const {
  if (jointAnglesAt(postures, time).isUpright()) {
    return height;
  }
  float highest = 0.0F;
  for (const BodyPart& part : bodyParts(*this, time)) {
    highest = part.belongsToBody ? std::max(highest, topOf(part)) : highest;
  }
  return static_cast<double>(highest) * kReferenceHeight / static_cast<double>(kHairTop);
}

std::vector<BodyPart> bodyParts(const Walker& walker, double time) {
  constexpr double kHeadingSpan = 0.6; // seconds: turning takes a while
  const Eigen::Vector2d position = walker.positionAt(time);
  Eigen::Vector2d going =
      walker.positionAt(time + 0.5 * kHeadingSpan) - walker.positionAt(time - 0.5 * kHeadingSpan);
  const double speed = going.norm() / kHeadingSpan;
  if (speed < kStandingSpeed) { // looks where it came from, or will go
    going = walker.waypoints.back().position - walker.waypoints.front().position;
  }
  const Eigen::Vector2d ahead =
      going.norm() > 1e-6 ? Eigen::Vector2d(going.normalized()) : Eigen::Vector2d(1.0, 0.0);
  Stance stance;
  stance.foot = {static_cast<float>(position.x()), static_cast<float>(position.y()), 0.0F};
  const auto c = static_cast<float>(ahead.x());
  const auto s = static_cast<float>(ahead.y());
  stance.axes << c, s, 0.0F, -s, c, 0.0F, 0.0F, 0.0F, 1.0F;
  stance.scale = static_cast<float>(walker.height / kReferenceHeight);
  const double phase = 2.0 * std::numbers::pi * gone(walker.waypoints, time) / kStrideLength;
  const auto swing = static_cast<float>(0.5 * std::min(1.0, speed / kUsualSpeed) * std::sin(phase));

  const Figure figure(stance, jointAnglesAt(walker.postures, time), walker.height);
  std::vector<BodyPart> parts;
  addHeadAndTrunk(figure, walker.clothes, parts);
  addLimbs(figure, walker, swing, parts);
  if (walker.carriedObject) {
    addLoad(figure, *walker.carriedObject, parts);
  }
  return parts;
}

} // namespace dewpoint::simulation

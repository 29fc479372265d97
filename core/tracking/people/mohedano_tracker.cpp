// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/mohedano_tracker.h"

#include "core/filter/person_motion.h"
#include "core/filter/systematic_resampling.h"

#include <cmath>
#include <numbers>

namespace dewpoint::tracking {
namespace {

constexpr double kBirthHalfWidth = 0.25;  ///< meters around the place of birth
constexpr double kPersonBirthSpeed = 0.5; ///< m/s, standard deviation of a new person's velocity

/// The middle of hues in [0, 1], which lie on a circle.
double meanHue(const Eigen::ArrayXd& hues, const Eigen::ArrayXd& weights) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double angle =
      std::atan2((weights * (kTurn * hues).sin()).sum(), (weights * (kTurn * hues).cos()).sum()) /
      kTurn;
  return angle - std::floor(angle);
}

} // namespace

MohedanoTracker::MohedanoTracker(const ParameterValues& parameters, const CameraRig& rig,
                                 bool color)
    : PeopleTrackLifecycle(parameters, rig), parameters_(parameters), color_(color) {}

void MohedanoTracker::configure(const ParameterValues& parameters) {
  parameters_ = parameters;
  PeopleTrackLifecycle::configure(parameters);
}

Eigen::Vector2d MohedanoTracker::colorAt(const Eigen::Vector3d& position, double pick) const {
  std::vector<Eigen::Vector2d> seen;
  for (std::size_t k = 0; k < cameras().cameraCount(); ++k) {
    const auto pixel = cameras().projector(k).project(position);
    cv::Point at;
    if (pixel && cameras().isUsable(k) &&
        findNearestPixel(pixel->x(), pixel->y(), cameras().foregroundMask(k), at) &&
        cameras().foregroundMask(k).at<unsigned char>(at) != 0) {
      const Eigen::Vector2d color = hueAndSaturation(cameras().image(k).ptr(at.y, at.x));
      if (!std::isnan(color[0])) {
        seen.push_back(color);
      }
    }
  }
  if (seen.empty()) {
    return {pick, 0.5};
  }
  return seen[static_cast<std::size_t>(pick * static_cast<double>(seen.size()))];
}

void MohedanoTracker::createBelief(const PersonEstimate& person, const RandomKey& key) {
  const auto count = static_cast<Eigen::Index>(parameters_.at("particles"));
  const RandomStream stream = key.stream(RandomPurpose::Start);
  Eigen::ArrayXXd states(count, color_ ? 8 : 6);
  // An upright box around the middle, as high as the middle is above the floor and again.
  const double halfHeight = std::max(0.2, person.position.z() - settings().area.floorHeight);
  const Eigen::Vector3d half(kBirthHalfWidth, kBirthHalfWidth, halfHeight);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const auto uniform = stream.uniform3(index, 0);
    const auto normal = stream.normal4(index, 1);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      states(i, axis) = person.position[axis] + half[axis] * (2.0 * uniform[k] - 1.0);
      states(i, axis + 3) = kPersonBirthSpeed * normal[k];
    }
    if (color_) {
      states.row(i).tail<2>() =
          colorAt(states.row(i).head<3>().transpose().matrix(), stream.uniform(index, 2))
              .transpose()
              .array();
    }
  }
  Belief& belief = beliefs_.emplace_back();
  belief.identity = person.identity;
  belief.filter.start(std::move(states));
}

void MohedanoTracker::removeBelief(std::size_t index) {
  beliefs_.erase(beliefs_.begin() + static_cast<std::ptrdiff_t>(index));
}

std::unique_ptr<Tracker> MohedanoTracker::clone() const {
  if (!cameras().canBeCopied()) {
    return nullptr;
  }
  auto copy = std::make_unique<MohedanoTracker>(*this);
  copy->likelihoods_.clear(); // made anew with every frame
  return copy;
}

std::size_t MohedanoTracker::beliefMemoryBytes() const {
  return sizeof(Belief) +
         std::size_t{3} * 8 * sizeof(double) * std::size_t(parameters_.at("particles"));
}

PersonObservation MohedanoTracker::observation() const {
  std::vector<PersonCamera> views;
  for (std::size_t k = 0; k < cameras().cameraCount(); ++k) {
    views.push_back({&cameras().projector(k), likelihoods_[k], cameras().image(k)});
  }
  std::optional<ColorCue> cue;
  if (color_) {
    cue = ColorCue{parameters_.at("hue_sigma"), parameters_.at("saturation_sigma"),
                   parameters_.at("hue_floor"), parameters_.at("saturation_floor")};
  }
  return {std::move(views), parameters_.at("motion_floor"), cue};
}

void MohedanoTracker::updateBeliefs(ThreadTeam& team) {
  likelihoods_.assign(cameras().cameraCount(), cv::Mat());
  team.forEachRange(static_cast<std::int64_t>(cameras().cameraCount()), [&](std::int64_t begin,
                                                                            std::int64_t end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      if (cameras().isUsable(k) && !people_.empty()) {
        computeMotionLikelihood(cameras().foregroundMask(k), parameters_.at("mask_sigma"),
                                parameters_.at("motion_floor"), likelihoods_[k]);
      }
    }
  });
  if (people_.empty()) {
    return;
  }
  PersonMotion motion;
  motion.interval = cameras().secondsBetweenFrames();
  motion.positionSigma = parameters_.at("position_sigma");
  motion.velocitySigma = parameters_.at("velocity_sigma");
  motion.colorSigma = color_ ? parameters_.at("color_noise") : 0.0;
  const MotionProposal<PersonMotion> proposal{motion};
  const PersonObservation model = observation();
  const auto count = static_cast<Eigen::Index>(parameters_.at("particles"));
  for (std::size_t k = 0; k < beliefs_.size(); ++k) {
    Belief& belief = beliefs_[k];
    const StateEstimate estimate = belief.filter.iterate(proposal, model, SystematicResampling{},
                                                         count, randomKeyOf(belief.identity), team);
    describe(estimate, belief, people_[k]);
  }
}

void MohedanoTracker::describe(const StateEstimate& estimate, const Belief& belief,
                               PersonEstimate& person) const {
  person.position = estimate.mean.head<3>();
  person.velocity = estimate.mean.segment<3>(3);
  person.covariance = estimate.covariance.topLeftCorner<3, 3>();
  person.effectiveSampleSize = estimate.effectiveSampleSize;
  person.particleCount = static_cast<int>(belief.filter.states().rows());
  if (color_) {
    person.hueAndSaturation = Eigen::Vector2d(
        meanHue(belief.filter.states().col(6), belief.filter.weights().linearWeights()),
        estimate.mean[7]);
  }
}

BodyCloud MohedanoTracker::bodyOf(int identity) const {
  for (const Belief& belief : beliefs_) {
    if (belief.identity == identity) {
      return {belief.filter.states().leftCols<3>(), belief.filter.weights().linearWeights()};
    }
  }
  return {};
}

} // namespace dewpoint::tracking

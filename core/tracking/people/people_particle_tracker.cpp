// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/people_particle_tracker.h"

#include "core/filter/person_motion.h"
#include "core/filter/systematic_resampling.h"
#include "core/observation/people/person_observation.h"
#include "core/observation/people/person_score.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::tracking {
namespace {

constexpr double kBirthSpread = 0.12;      ///< meters, standard deviation of a new person's place
constexpr double kWalkingBirthSpeed = 0.6; ///< m/s, the same of the velocity
constexpr double kHeightSpread = 0.08;     ///< meters, the same of the height
constexpr double kTooNear = 8.0;           ///< nats against standing in somebody else's place
constexpr double kColorReach = 1.5;        ///< meters within which clothes are compared
constexpr double kMeetingMemory = 4.0;     ///< seconds after which a meeting is settled
constexpr double kEvidenceLoss = 0.9;      ///< per frame
constexpr double kMistaken = -4.0;         ///< evidence at which two people change identities
constexpr double kBodyMaskSigma = 2.0;     ///< pixels of the reduced masks
constexpr double kBodyMaskFloor = 0.2;     ///< the paper's p_B
constexpr double kBodyWider = 1.2;         ///< points are drawn a little beyond the usual body

/// How well standing bodies fit: states x y vx vy height.
class StandingObservation {
public:
  StandingObservation(std::vector<const SilhouetteProjector*> makers, std::vector<ScoreSums> scores,
                      double floor, double evidence, double meanHeight)
      : makers_(std::move(makers)), scores_(std::move(scores)), floor_(floor), evidence_(evidence),
        usualHeight_(meanHeight) {}

  void keepFrom(std::vector<Eigen::Vector2d> others, double distance) {
    others_ = std::move(others);
    leastDistance_ = distance;
  }

  void addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const {
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const Eigen::Vector2d place(rows(i, 0), rows(i, 1));
      double sum = 0.0;
      for (std::size_t k = 0; k < scores_.size(); ++k) {
        if (!scores_[k].sums.empty()) {
          sum += bodyScore(scores_[k], makers_[k]->project(place, floor_, rows(i, 4)), kPieceFloor);
        }
      }
      // Pixels speak, not shares of a body: a mean alone would be best for one too small, which
      // has no pixel beside the person.
      const double size = rows(i, 4) / usualHeight_;
      logLikelihood[i] += evidence_ * size * size * sum - crowding(place);
    }
  }

private:
  double crowding(const Eigen::Vector2d& place) const {
    double sum = 0.0;
    for (const Eigen::Vector2d& other : others_) {
      const double gap = (place - other).norm();
      sum += gap < leastDistance_ ? kTooNear * (1.0 - gap / leastDistance_) : 0.0;
    }
    return sum;
  }

  std::vector<const SilhouetteProjector*> makers_;
  std::vector<ScoreSums> scores_;
  std::vector<Eigen::Vector2d> others_;
  double floor_;
  double evidence_;
  double usualHeight_;
  double leastDistance_ = 0.0;
};

cv::Rect boundsOf(const BodySilhouette& silhouette) {
  cv::Rect all = silhouette.partRects.front();
  for (const cv::Rect& piece : silhouette.partRects) {
    all |= piece;
  }
  const int more = all.height / 4 + 2;
  return {all.x - more, all.y - more, all.width + 2 * more, all.height + 2 * more};
}

} // namespace

PeopleParticleTracker::PeopleParticleTracker(const ParameterValues& parameters,
                                             const CameraRig& rig)
    : PeopleTrackLifecycle(parameters, rig), parameters_(parameters) {}

void PeopleParticleTracker::configure(const ParameterValues& parameters) {
  parameters_ = parameters;
  PeopleTrackLifecycle::configure(parameters);
}

void PeopleParticleTracker::createBelief(const PersonEstimate& person, const RandomKey& key) {
  const auto count = static_cast<Eigen::Index>(parameters_.at("particles"));
  const RandomStream stream = key.stream(RandomPurpose::Start);
  Eigen::ArrayXXd states(count, 5);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const auto normal = stream.normal4(index, 0);
    states(i, 0) = person.position.x() + kBirthSpread * normal[0];
    states(i, 1) = person.position.y() + kBirthSpread * normal[1];
    states(i, 2) = kWalkingBirthSpeed * normal[2];
    states(i, 3) = kWalkingBirthSpeed * normal[3];
    states(i, 4) = parameters_.at("usual_height") + kHeightSpread * stream.normal4(index, 1)[0];
  }
  Belief& belief = beliefs_.emplace_back();
  belief.identity = person.identity;
  belief.filter.start(std::move(states));
}

void PeopleParticleTracker::removeBelief(std::size_t index) {
  const int identity = beliefs_[index].identity;
  std::erase_if(meetings_, [&](const auto& meeting) {
    return meeting.first.first == identity || meeting.first.second == identity;
  });
  beliefs_.erase(beliefs_.begin() + static_cast<std::ptrdiff_t>(index));
}

void PeopleParticleTracker::removeAllBeliefs() {
  beliefs_.clear();
  meetings_.clear();
}

std::unique_ptr<Tracker> PeopleParticleTracker::clone() const {
  return cameras().canBeCopied() ? std::make_unique<PeopleParticleTracker>(*this) : nullptr;
}

std::size_t PeopleParticleTracker::beliefMemoryBytes() const {
  return sizeof(Belief) +
         std::size_t{3} * 5 * sizeof(double) * std::size_t(parameters_.at("particles"));
}

bool PeopleParticleTracker::areNear(std::size_t one, std::size_t other) const {
  return (floorPosition(people_[one]) - floorPosition(people_[other])).norm() < kColorReach;
}

cv::Mat PeopleParticleTracker::coveredByOthers(std::size_t person, std::size_t camera) const {
  cv::Mat covered;
  for (std::size_t k = 0; k < people_.size(); ++k) {
    if (k != person) {
      if (covered.empty()) {
        covered = cv::Mat::zeros(cameras().foregroundMask(camera).size(), CV_8UC1);
      }
      drawSilhouette(silhouetteOf(people_[k], camera), 255, covered);
    }
  }
  return covered;
}

std::vector<ScoreSums> PeopleParticleTracker::scoresFor(std::size_t person) const {
  std::vector<ScoreSums> result(cameras().cameraCount());
  for (std::size_t k = 0; k < cameras().cameraCount(); ++k) {
    if (!cameras().isUsable(k)) {
      continue;
    }
    cv::Mat scores = maskScores(cameras().foregroundMask(k), coveredByOthers(person, k));
    const BodySilhouette own = silhouetteOf(people_[person], k);
    for (std::size_t other = 0; other < people_.size() && own.isVisible; ++other) {
      if (other != person && areNear(person, other)) {
        addColorScores(cameras().image(k), cameras().foregroundMask(k), boundsOf(own),
                       own.partRects[kBodyPartCount / 2].br().y,
                       beliefs_[person].clothes.logRatioAgainst(beliefs_[other].clothes),
                       parameters_.at("color_weight"), scores);
      }
    }
    result[k].build(scores);
  }
  return result;
}

void PeopleParticleTracker::weigh(std::size_t person, ThreadTeam& team) {
  std::vector<const SilhouetteProjector*> makers;
  for (std::size_t k = 0; k < cameras().cameraCount(); ++k) {
    makers.push_back(&silhouetteProjector(k));
  }
  StandingObservation observation(std::move(makers), scoresFor(person), settings().area.floorHeight,
                                  parameters_.at("evidence"), parameters_.at("usual_height"));
  std::vector<Eigen::Vector2d> others;
  for (std::size_t k = 0; k < people_.size(); ++k) {
    if (k != person) {
      others.push_back(floorPosition(people_[k]));
    }
  }
  observation.keepFrom(std::move(others), parameters_.at("least_distance"));
  WalkingMotion motion;
  motion.interval = cameras().secondsBetweenFrames();
  motion.accelerationSigma = parameters_.at("acceleration_sigma");
  motion.meanHeight = parameters_.at("usual_height");
  Belief& belief = beliefs_[person];
  const StateEstimate estimate = belief.filter.iterate(
      MotionProposal<WalkingMotion>{motion}, observation, SystematicResampling{},
      static_cast<Eigen::Index>(parameters_.at("particles")), randomKeyOf(belief.identity), team);
  PersonEstimate& result = people_[person];
  result.height = estimate.mean[4];
  result.position = {estimate.mean[0], estimate.mean[1],
                     settings().area.floorHeight + 0.5 * result.height};
  result.velocity = {estimate.mean[2], estimate.mean[3], 0.0};
  result.covariance.setZero();
  result.covariance.topLeftCorner<2, 2>() = estimate.covariance.topLeftCorner<2, 2>();
  result.covariance(2, 2) = 0.25 * estimate.covariance(4, 4);
  result.effectiveSampleSize = estimate.effectiveSampleSize;
  result.particleCount = static_cast<int>(belief.filter.states().rows());
}

void PeopleParticleTracker::updateBeliefs(ThreadTeam& team) {
  // Where everybody is expected, so that those who come later explain what is theirs.
  for (PersonEstimate& person : people_) {
    person.position += cameras().secondsBetweenFrames() * person.velocity;
  }
  for (std::size_t k = 0; k < people_.size(); ++k) {
    weigh(k, team);
  }
  learnClothes();
  updateMeetings();
}

void PeopleParticleTracker::learnClothes() {
  for (std::size_t person = 0; person < people_.size(); ++person) {
    bool alone = true;
    for (std::size_t other = 0; other < people_.size(); ++other) {
      alone = alone && (other == person || !areNear(person, other));
    }
    if (!alone) {
      continue;
    }
    for (std::size_t k = 0; k < cameras().cameraCount(); ++k) {
      if (cameras().isUsable(k)) {
        beliefs_[person].clothes.learn(cameras().image(k), cameras().foregroundMask(k),
                                       silhouetteOf(people_[person], k),
                                       coveredByOthers(person, k));
      }
    }
    beliefs_[person].clothes.finishFrame();
  }
}

double PeopleParticleTracker::clothesEvidence(std::size_t one, std::size_t other) const {
  double sum = 0.0;
  for (const auto& [own, foreign] : {std::pair(one, other), std::pair(other, one)}) {
    const ClothesRatio ratio = beliefs_[own].clothes.logRatioAgainst(beliefs_[foreign].clothes);
    for (std::size_t k = 0; k < cameras().cameraCount(); ++k) {
      if (cameras().isUsable(k)) {
        sum += ClothesModel::meanLogRatioInSilhouette(
            ratio, cameras().image(k), cameras().foregroundMask(k), silhouetteOf(people_[own], k),
            coveredByOthers(own, k));
      }
    }
  }
  return sum;
}

void PeopleParticleTracker::swapIdentities(std::size_t one, std::size_t other) {
  // Who is who changes; where they are does not.
  std::swap(beliefs_[one].filter, beliefs_[other].filter);
  std::swap(people_[one], people_[other]);
  std::swap(people_[one].identity, people_[other].identity);
  std::swap(people_[one].ageSeconds, people_[other].ageSeconds);
}

/// That of the 95 % volumes: the filter itself weighs with whole bodies.
PeopleTrackLifecycle::MotionSmoothing PeopleParticleTracker::motionSmoothing() const {
  return {kBodyMaskSigma, kBodyMaskFloor};
}

void PeopleParticleTracker::updateMeetings() {
  for (std::size_t one = 0; one < people_.size(); ++one) {
    for (std::size_t other = one + 1; other < people_.size(); ++other) {
      const std::pair key(people_[one].identity, people_[other].identity);
      if (areNear(one, other)) {
        meetings_[key].secondsSinceNear = 0.0;
      }
      const auto found = meetings_.find(key);
      if (found == meetings_.end()) {
        continue;
      }
      Meeting& meeting = found->second;
      meeting.secondsSinceNear += cameras().secondsBetweenFrames();
      meeting.identityEvidence =
          kEvidenceLoss * meeting.identityEvidence + clothesEvidence(one, other);
      if (meeting.identityEvidence < kMistaken) {
        swapIdentities(one, other);
        meeting.identityEvidence = 0.0;
      }
      if (meeting.secondsSinceNear > kMeetingMemory) {
        meetings_.erase(found);
      }
    }
  }
}

BodyCloud PeopleParticleTracker::bodyOf(int identity) const {
  const auto found = std::ranges::find(beliefs_, identity, &Belief::identity);
  if (found == beliefs_.end()) {
    return {};
  }
  std::vector<PersonCamera> views;
  std::vector<cv::Mat> likelihoods(cameras().cameraCount());
  for (std::size_t k = 0; k < cameras().cameraCount(); ++k) {
    if (cameras().isUsable(k)) {
      computeMotionLikelihood(cameras().foregroundMask(k), kBodyMaskSigma, kBodyMaskFloor,
                              likelihoods[k]);
    }
    views.push_back({&cameras().projector(k), likelihoods[k], cv::Mat()});
  }
  const RandomStream stream = randomKeyOf(identity).stream(RandomPurpose::Search);
  const auto count = static_cast<Eigen::Index>(parameters_.at("body_points"));
  Ancestors ancestors;
  SystematicResampling{}.drawAncestors(found->filter.weights().linearWeights(), count, stream,
                                       ancestors);
  BodyCloud cloud;
  cloud.points.resize(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto state = found->filter.states().row(ancestors[static_cast<std::size_t>(i)]);
    const auto uniform = stream.uniform3(static_cast<std::uint32_t>(i), 1);
    const double height = state[4];
    const int piece = static_cast<int>(kBodyPartCount * uniform[0]);
    const double radius = kBodyWider * bodyHalfWidth(piece, height) * std::sqrt(uniform[1]);
    const double angle = 2.0 * std::numbers::pi * uniform[2];
    cloud.points(i, 0) = state[0] + radius * std::cos(angle);
    cloud.points(i, 1) = state[1] + radius * std::sin(angle);
    cloud.points(i, 2) = settings().area.floorHeight + height * uniform[0];
  }
  Eigen::ArrayXd logWeights = Eigen::ArrayXd::Zero(count);
  PersonObservation(std::move(views), kBodyMaskFloor, std::nullopt)
      .addLogLikelihood(cloud.points, logWeights);
  ThreadTeam alone(1);
  normalize(logWeights, cloud.weights, alone);
  return cloud;
}

} // namespace dewpoint::tracking

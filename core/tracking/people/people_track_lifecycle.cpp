// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/people_track_lifecycle.h"

#include "core/filter/evenly_picked.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::tracking {
namespace {

constexpr double kSeenScore = 0.25;     ///< from which a camera confirms a person
constexpr double kFreeShare = 0.3;      ///< of a silhouette, below which a camera cannot judge
constexpr double kHiddenPatience = 4.0; ///< a hidden person survives so many times as long
constexpr double kExplainedWider = 1.3; ///< silhouettes explain a rim around them
constexpr double kNear = 1.0;           ///< meters between two people who interact
constexpr double kBirthMargin = 0.05;   ///< meters within the area's border

double withinImage(const cv::Rect& piece, const cv::Mat& image) {
  return (piece & cv::Rect(0, 0, image.cols, image.rows)).area();
}

} // namespace

PeopleTrackLifecycle::PeopleTrackLifecycle(const ParameterValues& parameters, const CameraRig& rig)
    : settings_(peopleSettings(parameters)), rig_(rig), cameras_(rig, settings_) {
  apply(parameters);
  prepare();
}

void PeopleTrackLifecycle::apply(const ParameterValues& parameters) {
  settings_ = peopleSettings(parameters);
  const auto declared = parameters.declarations();
  if (std::ranges::find(declared, "usual_height", &ParameterDeclaration::key) != declared.end()) {
    usualHeight_ = parameters.at("usual_height");
  }
}

void PeopleTrackLifecycle::prepare() {
  makers_.clear();
  for (std::size_t k = 0; k < cameras_.cameraCount(); ++k) {
    makers_.emplace_back(cameras_.camera(k));
  }
  initiation_.setCameras(cameras_, settings_.area, usualHeight_);
}

void PeopleTrackLifecycle::configure(const ParameterValues& parameters) {
  apply(parameters);
  cameras_.configure(settings_);
  cameras_.setRig(rig_);
  prepare();
}

void PeopleTrackLifecycle::setCameras(const CameraRig& rig) {
  rig_ = rig;
  cameras_.setRig(rig);
  prepare();
}

void PeopleTrackLifecycle::setBackgroundImages(const std::vector<cv::Mat>& images) {
  cameras_.setBackgroundImages(images);
}

void PeopleTrackLifecycle::restart(std::uint64_t seed) {
  seed_ = seed;
  nextIdentity_ = 1;
  removeAllBeliefs();
  people_.clear();
  unseen_.clear();
  cameras_.restart();
  initiation_.restart();
  peopleAsTargets_.clear();
  bodies_.clear();
  frames_ = nullptr;
  stepped_ = false;
  prepare();
}

void PeopleTrackLifecycle::beginFrame(FrameSetPtr frames) {
  frames_ = std::move(frames);
  stepped_ = false;
}

void PeopleTrackLifecycle::iterate(ThreadTeam& team) {
  if (frames_ && !std::exchange(stepped_, true)) {
    step(*frames_, team);
    assignTracks();
  }
}

void PeopleTrackLifecycle::assignTracks() {
  bodies_.clear();
  for (const PersonEstimate& person : people_) {
    while (static_cast<int>(peopleAsTargets_.size()) < person.identity) {
      Target& target = peopleAsTargets_.emplace_back();
      target.name = personName(static_cast<int>(peopleAsTargets_.size()));
    }
  }
}

TrackEstimate PeopleTrackLifecycle::estimate(std::size_t track) const {
  const std::size_t index = indexOf(static_cast<int>(track) + 1);
  return index < people_.size() ? TrackEstimate(people_[index]) : TrackEstimate(AbsentEstimate{});
}

void PeopleTrackLifecycle::copyParticles(std::size_t track, int limit, Eigen::ArrayXXd& positions,
                                         Eigen::ArrayXd& weights) const {
  positions.resize(0, 3);
  weights.resize(0);
  const int identity = static_cast<int>(track) + 1;
  if (indexOf(identity) == people_.size()) {
    return;
  }
  auto known = bodies_.find(identity);
  if (known == bodies_.end()) {
    known = bodies_.emplace(identity, bodyOf(identity)).first;
  }
  pickEvenly(known->second.points, known->second.weights, limit, 3, positions, weights);
}

std::size_t PeopleTrackLifecycle::memoryBytes() const {
  return cameras_.memoryBytes() + initiation_.memoryBytes() + people_.size() * beliefMemoryBytes() +
         peopleAsTargets_.capacity() * (sizeof(Target) + sizeof(TrackEstimate));
}

RandomKey PeopleTrackLifecycle::randomKeyOf(int identity) const {
  return {derivedSeed(seed_, static_cast<std::uint32_t>(identity)),
          static_cast<std::uint32_t>(std::max<std::int64_t>(0, cameras_.frameNumber())), 0};
}

int PeopleTrackLifecycle::addPerson(const Eigen::Vector3d& center) {
  const int identity = createTrack(center);
  assignTracks();
  return identity;
}

void PeopleTrackLifecycle::removePerson(int identity) {
  removeTrack(identity);
  assignTracks();
}

int PeopleTrackLifecycle::createTrack(const Eigen::Vector3d& center) {
  PersonEstimate& person = people_.emplace_back();
  person.identity = nextIdentity_++;
  person.position = center;
  unseen_.push_back(0.0);
  const PersonEstimate copy = person; // createBelief() may look at people_
  createBelief(copy, randomKeyOf(copy.identity));
  return copy.identity;
}

std::size_t PeopleTrackLifecycle::indexOf(int identity) const {
  return static_cast<std::size_t>(std::ranges::find(people_, identity, &PersonEstimate::identity) -
                                  people_.begin());
}

void PeopleTrackLifecycle::removeTrack(int identity) {
  const std::size_t index = indexOf(identity);
  if (index < people_.size()) {
    removeBelief(index);
    people_.erase(people_.begin() + static_cast<std::ptrdiff_t>(index));
    unseen_.erase(unseen_.begin() + static_cast<std::ptrdiff_t>(index));
  }
}

BodySilhouette PeopleTrackLifecycle::silhouetteOf(const PersonEstimate& person,
                                                  std::size_t camera) const {
  return makers_[camera].project(floorPosition(person), settings_.area.floorHeight,
                                 heightOf(person));
}

std::vector<cv::Mat> PeopleTrackLifecycle::silhouettesOfAll(double wider) const {
  std::vector<cv::Mat> masks(cameras_.cameraCount());
  for (std::size_t k = 0; k < cameras_.cameraCount(); ++k) {
    if (people_.empty() || !cameras_.isUsable(k)) {
      continue;
    }
    masks[k] = cv::Mat::zeros(cameras_.foregroundMask(k).size(), CV_8UC1);
    for (const PersonEstimate& person : people_) {
      BodySilhouette body = silhouetteOf(person, k);
      for (cv::Rect& piece : body.partRects) {
        const int more = static_cast<int>(std::lround(0.5 * (wider - 1.0) * piece.width)) + 1;
        piece.x -= more;
        piece.width += 2 * more;
      }
      body.partRects.back().y -= body.partRects.back().height / 2; // above the head
      body.partRects.back().height += body.partRects.back().height / 2;
      drawSilhouette(body, 255, masks[k]);
    }
  }
  return masks;
}

PeopleTrackLifecycle::Visibility PeopleTrackLifecycle::visibilityOf(std::size_t person,
                                                                    std::size_t camera) const {
  Visibility sight;
  if (!cameras_.isUsable(camera)) {
    return sight;
  }
  const cv::Mat& mask = cameras_.foregroundMask(camera);
  const BodySilhouette body = silhouetteOf(people_[person], camera);
  double all = 0.0;
  double free = 0.0;
  double moving = 0.0;
  std::vector<cv::Rect> others;
  for (std::size_t k = 0; k < people_.size() && ignoresForegroundOfKnownPeople(); ++k) {
    if (k != person) {
      const BodySilhouette other = silhouetteOf(people_[k], camera);
      if (other.isVisible) {
        others.insert(others.end(), other.partRects.begin(), other.partRects.end());
      }
    }
  }
  const cv::Rect image(0, 0, mask.cols, mask.rows);
  for (std::size_t k = 0; body.isVisible && k < kBodyPartCount; ++k) {
    all += body.partRects[k].area();
    const cv::Rect inside = body.partRects[k] & image;
    for (int row = inside.y; row < inside.y + inside.height; ++row) {
      for (int column = inside.x; column < inside.x + inside.width; ++column) {
        const auto covers = [&](const cv::Rect& other) {
          return other.contains(cv::Point(column, row));
        };
        if (std::ranges::none_of(others, covers)) {
          free += 1.0;
          moving += mask.at<unsigned char>(row, column) != 0 ? 1.0 : 0.0;
        }
      }
    }
    sight.isInView = sight.isInView || withinImage(body.partRects[k], mask) > 0.0;
  }
  sight.uncoveredFraction = all > 0.0 ? free / all : 0.0;
  sight.foregroundFraction = free > 0.0 ? moving / free : 0.0;
  return sight;
}

void PeopleTrackLifecycle::updateVisibility() {
  const double interval = cameras_.secondsBetweenFrames();
  for (std::size_t person = 0; person < people_.size(); ++person) {
    PersonEstimate& estimate = people_[person];
    int seeing = 0;
    int unable = 0;
    for (std::size_t k = 0; k < cameras_.cameraCount(); ++k) {
      const Visibility sight = visibilityOf(person, k);
      if (sight.isInView && sight.uncoveredFraction < kFreeShare) {
        ++unable;
      } else if (sight.isInView && sight.foregroundFraction >= kSeenScore) {
        ++seeing;
      }
    }
    const int needed = std::min<int>(2, static_cast<int>(cameras_.cameraCount()));
    double& unseen = unseen_[person];
    if (seeing >= needed) {
      unseen = std::max(0.0, unseen - 2.0 * interval);
    } else {
      unseen += seeing > 0 && seeing + unable >= needed ? interval / kHiddenPatience : interval;
    }
    estimate.seeingCameraCount = seeing;
    estimate.existenceProbability = std::clamp(1.0 - unseen / settings_.survivalSeconds, 0.0, 1.0);
    estimate.ageSeconds += interval;
    estimate.isInteracting = std::ranges::any_of(people_, [&](const PersonEstimate& other) {
      return other.identity != estimate.identity &&
             (floorPosition(other) - floorPosition(estimate)).norm() < kNear;
    });
  }
}

std::vector<LikelihoodMap> PeopleTrackLifecycle::motionLikelihoodMaps() const {
  const MotionSmoothing smoothing = motionSmoothing();
  std::vector<LikelihoodMap> maps(cameras_.cameraCount());
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const cv::Mat& mask = cameras_.foregroundMask(k);
    if (mask.empty()) {
      continue;
    }
    cv::Mat likelihood;
    computeMotionLikelihood(mask, smoothing.sigma, smoothing.minLikelihood, likelihood);
    cv::log(likelihood, maps[k].logLikelihood);
    maps[k].area = {{0, 0}, mask.size()};
    maps[k].minLogLikelihood = std::log(smoothing.minLikelihood);
    maps[k].maxLogLikelihood = 0.0; // D = 1: motion all around
  }
  return maps;
}

void PeopleTrackLifecycle::terminateTracks() {
  for (std::size_t k = people_.size(); k-- > 0;) {
    if (!settings_.area.contains(floorPosition(people_[k])) ||
        people_[k].existenceProbability <= 0.0) {
      removeTrack(people_[k].identity);
    }
  }
}

void PeopleTrackLifecycle::initiateTracks() {
  std::vector<Eigen::Vector2d> taken;
  for (const PersonEstimate& person : people_) {
    taken.push_back(floorPosition(person));
  }
  const auto explained = silhouettesOfAll(kExplainedWider);
  PeopleArea inside = settings_.area;
  inside.halfSize.array() -= kBirthMargin;
  for (const auto& position :
       initiation_.update(cameras_, explained, taken, settings_.confirmationSeconds)) {
    if (inside.contains(position)) {
      createTrack({position.x(), position.y(), settings_.area.floorHeight + 0.5 * usualHeight_});
    }
  }
}

void PeopleTrackLifecycle::step(const FrameSet& frames, ThreadTeam& team) {
  cameras_.computeForegroundMasks(frames, silhouettesOfAll(kExplainedWider), team);
  const bool anyUsable = std::ranges::any_of(cameras_.cameraStates(), &PeopleCameraState::isUsable);
  if (!anyUsable) {
    return; // learning, or no images: what is believed stays as it is
  }
  updateBeliefs(team);
  updateVisibility();
  terminateTracks();
  if (settings_.createsTracks) {
    initiateTracks();
  }
}

} // namespace dewpoint::tracking

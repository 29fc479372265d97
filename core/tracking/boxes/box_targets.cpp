// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/boxes/box_targets.h"

#include "core/base/random.h"

#include <algorithm>
#include <utility>

namespace dewpoint::tracking {
namespace {

/// A method that knows no hiding may follow its box out of the image, where nothing is alike.
bool isSeen(const BoxEstimate& estimate) {
  return estimate.visible && estimate.similarity > 0.0;
}

} // namespace

BoxTargets::BoxTargets(std::string method, const ParameterValues& parameters,
                       const std::vector<Target>& targets)
    : method_(std::move(method)), parameters_(parameters) {
  setTargets(targets);
}

BoxTargets::BoxTargets(const BoxTargets& other)
    : MultiTracker(), method_(other.method_), parameters_(other.parameters_), seed_(other.seed_),
      estimates_(other.estimates_), frames_(other.frames_) {
  for (const Followed& one : other.followed_) {
    followed_.push_back({one.name, one.box, one.tracker ? one.tracker->clone() : nullptr,
                         one.startedAt, one.estimate});
  }
}

void BoxTargets::configure(const ParameterValues& parameters) {
  parameters_ = parameters;
  for (Followed& one : followed_) {
    if (one.tracker) {
      one.tracker->configure(parameters_);
    }
  }
}

void BoxTargets::setTargets(const std::vector<Target>& targets) {
  std::vector<Followed> before = std::exchange(followed_, {});
  const bool sameNumber = before.size() == targets.size(); // then one may have got another name
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const auto old = sameNumber ? before.begin() + static_cast<std::ptrdiff_t>(k)
                                : std::ranges::find(before, targets[k].name, &Followed::name);
    if (old != before.end() && old->box == targets[k].box) {
      followed_.push_back(std::move(*old));
      followed_.back().name = targets[k].name;
    } else {
      followed_.push_back({targets[k].name, targets[k].box, nullptr, -1, {}});
    }
  }
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    start(k);
  }
  showEstimates();
}

void BoxTargets::beginFrame(FrameSetPtr frames) {
  frames_ = std::move(frames);
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    start(k);
  }
  showEstimates();
}

void BoxTargets::restart(std::uint64_t seed) {
  seed_ = seed;
  frames_ = nullptr;
  for (Followed& one : followed_) {
    one.tracker.reset();
    one.startedAt = -1;
    one.estimate = {};
  }
  showEstimates();
}

const cv::Mat* BoxTargets::imageOf(const TargetBox& box) const {
  const auto camera = static_cast<std::size_t>(box.camera);
  const bool there = frames_ && box.camera >= 0 && camera < frames_->frames.size() &&
                     frames_->frames[camera] && !frames_->frames[camera]->image.empty();
  return there ? &frames_->frames[camera]->image : nullptr;
}

/// Begins to follow a target whose box is of the frame that the run stands at.
void BoxTargets::start(std::size_t target) {
  Followed& one = followed_[target];
  if (!frames_ || !one.box || one.box->frame != frames_->index || one.startedAt == frames_->index) {
    return;
  }
  const cv::Mat* image = imageOf(*one.box);
  auto tracker = makeBoxTracker(method_, parameters_);
  if (image == nullptr || !tracker ||
      !(*tracker)->start(*image, one.box->box,
                         derivedSeed(seed_, static_cast<std::uint32_t>(target)))) {
    return; // a box beyond the image: there is nothing to follow
  }
  one.tracker = std::move(*tracker);
  one.startedAt = frames_->index;
  one.estimate = BoxEstimate{};
  one.estimate.box = one.box->box;
  one.estimate.similarity = 1.0;
  one.estimate.particleCount = static_cast<int>(parameters_.at("particles"));
  one.estimate.effectiveSampleSize = one.estimate.particleCount;
}

void BoxTargets::step(Followed& one, ThreadTeam& team) const {
  if (!one.tracker || one.startedAt == frames_->index) {
    return; // the box as it was given is what is known of its own image
  }
  if (const cv::Mat* image = imageOf(*one.box)) {
    one.estimate = one.tracker->step(*image, team);
  } else {
    one.estimate.visible = false; // the camera delivered nothing
  }
}

void BoxTargets::showEstimate(std::size_t target) {
  const Followed& one = followed_[target];
  TargetEstimate& shown = estimates_[target];
  shown = {};
  shown.gone = !one.tracker; // there is nothing to look for yet
  if (one.tracker) {
    shown.valid = isSeen(one.estimate);
    shown.existence = one.estimate.similarity;
    shown.effectiveSampleSize = one.estimate.effectiveSampleSize;
    shown.degenerate = one.estimate.degenerate;
    shown.camerasSeeing = shown.valid ? 1 : 0;
  }
}

void BoxTargets::showEstimates() {
  estimates_.resize(followed_.size());
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    showEstimate(k);
  }
}

void BoxTargets::iterate(ThreadTeam& team) {
  for (std::size_t k = 0; frames_ && k < followed_.size(); ++k) {
    step(followed_[k], team);
    showEstimate(k);
  }
}

void BoxTargets::particles(std::size_t /*target*/, int /*limit*/, Eigen::ArrayXXd& positions,
                           Eigen::ArrayXd& weights) const {
  positions.resize(0, 3);
  weights.resize(0);
}

std::optional<BoxBelief> BoxTargets::box(std::size_t target, int particleLimit) const {
  const Followed& one = followed_.at(target);
  if (!one.tracker) {
    return std::nullopt;
  }
  BoxBelief belief{one.box->camera, one.estimate, {}, {}};
  Eigen::ArrayXXd centers;
  Eigen::ArrayXd weights;
  one.tracker->particles(particleLimit, centers, weights);
  belief.centers = centers.cast<float>();
  belief.weights = weights.cast<float>();
  return belief;
}

std::vector<CameraReport> BoxTargets::explain(std::size_t target) const {
  const Followed& one = followed_.at(target);
  std::vector<CameraReport> reports;
  if (one.tracker && frames_) {
    reports.resize(frames_->frames.size()); // the other cameras do not look for it
    reports.at(static_cast<std::size_t>(one.box->camera)).trouble =
        imageOf(*one.box) == nullptr ? CameraStatus::NoImage
        : isSeen(one.estimate)       ? CameraStatus::None
        : one.estimate.visible       ? CameraStatus::OutOfView
                                     : CameraStatus::Hidden;
  }
  return reports;
}

std::unique_ptr<MultiTracker> BoxTargets::clone() const {
  return std::make_unique<BoxTargets>(*this);
}

std::size_t BoxTargets::memoryBytes() const {
  std::size_t bytes = sizeof(BoxTargets);
  for (const Followed& one : followed_) {
    bytes += sizeof(Followed) + (one.tracker ? one.tracker->memoryBytes() : 0);
  }
  return bytes;
}

} // namespace dewpoint::tracking

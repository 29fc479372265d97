// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/camera_agreement.h"

#include "core/camera_motion/agreement/agreement_model.h"
#include "core/camera_motion/agreement/agreement_search.h"
#include "core/camera_motion/agreement/rig_check.h"

#include <algorithm>
#include <limits>

namespace dewpoint::camera_motion {
namespace {

// Chosen: as often as keeps the search cheap, and several times within the time in which a fault is
// to be named.
constexpr double kEvery = 0.3;        ///< seconds between checks
constexpr double kSlower = 1.5;       ///< by which that grows while nothing explains what is seen
constexpr double kSlowest = 10.0;     ///< seconds
constexpr double kImagesEvery = 0.02; ///< seconds: faster cameras are not looked at more often
// A rig that has been right for kSparseAfter is checked sparsely: for kCheckWindow after each
// kPause, which is enough to notice that it is right no longer.
constexpr double kSparseAfter = 1.5; ///< seconds
constexpr double kCheckWindow = 1.0; ///< seconds
constexpr double kPause = 5.0;       ///< seconds
/// Counted sightings, in all cameras, from which on a check tells something.
constexpr std::size_t kFewest = 8;
/// Regions in an image, on average, up to which it can be told which of them is which.
constexpr double kMostRegions = 5.0;
/// Seconds of disagreement until it is said without a reason.
constexpr double kPatience = 2.5;
constexpr double kGoodAgain = 3.0; ///< seconds of agreement until what was said is taken back

} // namespace

CameraAgreement::CameraAgreement(const CameraRig& rig)
    : rig_(rig), found_(checkRig(rig)), rigFaultCount_(found_.size()) {
  restart();
}

void CameraAgreement::restart() {
  found_.resize(rigFaultCount_);
  for (auto& color : histories_) {
    for (SightingHistory& history : color) {
      history.clear();
    }
  }
  lastTimes_.assign(rig_.size(), -std::numeric_limits<double>::infinity());
  due_ = 0.0;
  wait_ = kEvery;
  badSince_.reset();
  unclearSince_.reset();
  goodSince_.reset();
  suspected_.reset();
  sparse_ = false;
}

void CameraAgreement::updateColors(const std::vector<Target>& targets) {
  std::vector<ColorRanges> colors;
  std::vector<double> radii;
  for (const Target& target : targets) {
    const auto known = std::ranges::find(colors, target.colors());
    if (known == colors.end()) {
      colors.push_back(target.colors());
      radii.push_back(target.radius);
    } else if (double& radius = radii[static_cast<std::size_t>(known - colors.begin())];
               radius != target.radius) {
      radius = 0.0; // of one color, but not of one size
    }
  }
  radii_ = std::move(radii);
  if (colors != colors_) {
    colors_ = std::move(colors);
    histories_.clear();
    for (const ColorRanges& color : colors_) {
      auto& histories = histories_.emplace_back();
      for (const Camera& camera : rig_) {
        histories.emplace_back(color, camera);
      }
    }
    suspected_.reset();
    badSince_.reset();
    sparse_ = false;
    wait_ = kEvery;
  }
}

void CameraAgreement::watch(const FrameSet& frames, const std::vector<Target>& targets) {
  const double now = seconds(frames.time);
  if (rig_.size() < 2 || (sparse_ && now < due_ - kCheckWindow)) {
    return;
  }
  updateColors(targets);
  for (std::size_t k = 0; k < std::min(rig_.size(), frames.frames.size()); ++k) {
    const FramePtr& frame = frames.frames[k];
    const Intrinsics& in = rig_[k].intrinsics;
    if (!frame || frame->image.size() != cv::Size(in.width, in.height)) {
      continue;
    }
    const double time = seconds(frame->captureTime);
    if (time < lastTimes_[k] + kImagesEvery) {
      continue;
    }
    lastTimes_[k] = time;
    for (auto& color : histories_) {
      color[k].add(frame->image, time);
    }
  }
  if (now >= due_ && !colors_.empty()) {
    check(now);
    due_ = now + (sparse_ ? kPause + kCheckWindow : wait_);
  }
}

bool CameraAgreement::hasEnoughSightings() const {
  std::size_t counted = 0;
  double regions = 0.0;
  double images = 0.0;
  for (const auto& color : histories_) {
    for (const SightingHistory& history : color) {
      counted += history.countEvidence();
      for (const SightingImage& image : history.images()) {
        regions += static_cast<double>(image.regions.size());
        images += image.regions.empty() ? 0.0 : 1.0;
      }
    }
  }
  return counted >= kFewest && regions <= kMostRegions * images;
}

void CameraAgreement::check(double time) {
  if (!hasEnoughSightings()) {
    setSparseChecking(sparse_);
    return;
  }
  const AgreementModel model(rig_, histories_, radii_);
  const AgreementFit asDeclared = model.fit({});
  if (asDeclared.lowestMeanLogLikelihood == 0.0) {
    setSparseChecking(sparse_); // hardly ever seen at one instant
  } else if (isGoodFit(asDeclared)) {
    onGoodFit(model, asDeclared, time);
  } else {
    sparse_ = false;
    onDoubtfulFit(model, asDeclared, time);
  }
}

void CameraAgreement::setSparseChecking(bool sparse) {
  sparse_ = sparse;
  if (sparse_) {
    for (auto& color : histories_) {
      for (SightingHistory& history : color) {
        history.clear(); // what comes after the pause is new
      }
    }
  }
}

void CameraAgreement::onGoodFit(const AgreementModel& model, const AgreementFit& asDeclared,
                                double time) {
  badSince_.reset();
  unclearSince_.reset();
  suspected_.reset();
  wait_ = kEvery;
  goodSince_ = goodSince_.value_or(time);
  const auto ratio = model.sizeRatio(asDeclared.errors);
  const double unit = ratio ? lengthUnitFromRatio(*ratio) : 0.0;
  if (unit > 0.0) {
    report(CameraDisagreement{.fault = CameraFault::Unit, .metersPerUnit = unit});
  } else if (time - *goodSince_ >= kGoodAgain) {
    report(std::nullopt);
  }
  const bool isQuiet = found_.size() == rigFaultCount_;
  setSparseChecking(sparse_ || (isQuiet && time - *goodSince_ >= kSparseAfter));
}

void CameraAgreement::onDoubtfulFit(const AgreementModel& model, const AgreementFit& asDeclared,
                                    double time) {
  goodSince_.reset();
  badSince_ = isBadFit(asDeclared) ? std::optional(badSince_.value_or(time)) : std::nullopt;
  unclearSince_ = unclearSince_.value_or(time);
  const bool isNamed =
      found_.size() > rigFaultCount_ && found_.back().fault != CameraFault::Unknown;
  if (isNamed) {
    return; // once is enough
  }
  // What is of no known size may be anything, and something else in each image.
  const bool mayBeUnknown = std::ranges::all_of(radii_, [](double radius) { return radius > 0.0; });
  auto seen = findFault(model, rig_, asDeclared,
                        mayBeUnknown && badSince_ && time - *badSince_ >= kPatience);
  if (seen && suspected_ && seen->isSameAs(*suspected_)) {
    report(seen);
  }
  wait_ = time - *unclearSince_ > kPatience && !seen ? std::min(kSlowest, kSlower * wait_) : kEvery;
  suspected_ = std::move(seen);
}

void CameraAgreement::report(const std::optional<CameraDisagreement>& seen) {
  const bool isOfRig =
      seen &&
      std::any_of(found_.begin(), found_.begin() + static_cast<std::ptrdiff_t>(rigFaultCount_),
                  [&](const CameraDisagreement& one) {
                    return one.isSameAs(*seen) && one.metersPerUnit == seen->metersPerUnit;
                  });
  found_.resize(rigFaultCount_);
  if (seen && !isOfRig) {
    found_.push_back(*seen);
  }
}

} // namespace dewpoint::camera_motion

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/boxes/box_follower.h"

#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/tracker_capabilities.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/tracking.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr const char* kBoxSuffix = "-box"; ///< behind the names of OpenCV's trackers

cv::Rect wholePixels(const ImageBox& box) {
  return {static_cast<int>(std::lround(box.x)), static_cast<int>(std::lround(box.y)),
          static_cast<int>(std::lround(box.width)), static_cast<int>(std::lround(box.height))};
}

ImageBox boxOf(const cv::Rect& box) {
  return {double(box.x), double(box.y), double(box.width), double(box.height)};
}

/// One image after the other, as OpenCV's trackers are fed: the loop over the images is that of the
/// comparison, which stops the clock around each image and has one for all followers. A TrackingRun
/// takes the box from its definition and draws with a seed derived for each target; here start()
/// gives the box, and the seed itself is drawn with, as in the numbers that are published.
class OwnFollower final : public BoxFollower {
public:
  /// The tracker has one target, and a method that follows boxes (asserted).
  OwnFollower(std::unique_ptr<Tracker> tracker, std::uint64_t seed)
      : tracker_(std::move(tracker)), seed_(seed) {}

  Status start(const cv::Mat& bgr, const ImageBox& box) override {
    frame_ = 0;
    auto* const following = capability<BoxTracking>(*tracker_);
    assert(following != nullptr);
    return following->startFollowing(0, bgr, {0, frame_, box}, seed_);
  }
  std::optional<ImageBox> step(const cv::Mat& bgr) override {
    ++frame_;
    FrameSet frames{frame_, {}, {std::make_shared<const Frame>(Frame{frame_, {}, bgr})}};
    tracker_->beginFrame(std::make_shared<const FrameSet>(std::move(frames)));
    tracker_->iterate(team_);
    const auto estimate = std::get<BoxEstimate>(tracker_->estimate(0));
    claim_ = {estimate.similarity, estimate.isVisible};
    return estimate.box;
  }
  std::optional<BoxConfidence> confidence() const override { return claim_; }

private:
  std::unique_ptr<Tracker> tracker_;
  BoxConfidence claim_;
  std::uint64_t seed_;
  std::int64_t frame_ = 0;
  ThreadTeam team_;
};

Status refused(const cv::Exception& problem) {
  return failure(ErrorCode::BadValue, "", "box", problem.err);
}

/// CSRT (Lukežič et al. 2017) and KCF (Henriques et al. 2015).
class CorrelationFollower final : public BoxFollower {
public:
  explicit CorrelationFollower(cv::Ptr<cv::Tracker> tracker) : tracker_(std::move(tracker)) {}

  Status start(const cv::Mat& bgr, const ImageBox& box) override {
    try {
      tracker_->init(bgr, wholePixels(box));
    } catch (const cv::Exception& problem) {
      return refused(problem);
    }
    return {};
  }

  std::optional<ImageBox> step(const cv::Mat& bgr) override {
    try {
      cv::Rect box;
      return tracker_->update(bgr, box) ? std::optional(boxOf(box)) : std::nullopt;
    } catch (const cv::Exception&) {
      return std::nullopt; // they refuse boxes that have left the image
    }
  }

private:
  cv::Ptr<cv::Tracker> tracker_;
};

/// CamShift (Bradski 1998) and meanShift on the back-projected hues.
class HueFollower final : public BoxFollower {
public:
  explicit HueFollower(bool adaptive) : adaptive_(adaptive) {}

  Status start(const cv::Mat& bgr, const ImageBox& box) override {
    window_ = wholePixels(box) & cv::Rect({0, 0}, bgr.size());
    try {
      convert(bgr);
      const cv::Mat part = hsv_(window_);
      const cv::Mat mask = colored_(window_);
      cv::calcHist(&part, 1, &kChannel, mask, hues_, 1, &kHues, &range_);
      cv::normalize(hues_, hues_, 0, 255, cv::NORM_MINMAX);
    } catch (const cv::Exception& problem) {
      return refused(problem);
    }
    return {};
  }

  std::optional<ImageBox> step(const cv::Mat& bgr) override {
    try {
      convert(bgr);
      cv::Mat probability;
      cv::calcBackProject(&hsv_, 1, &kChannel, hues_, probability, &range_);
      probability &= colored_;
      const cv::TermCriteria until(cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 10, 1.0);
      if (adaptive_) {
        return boxOf(cv::CamShift(probability, window_, until).boundingRect());
      }
      cv::meanShift(probability, window_, until);
      return boxOf(window_);
    } catch (const cv::Exception&) {
      return std::nullopt; // windows that have shrunk to nothing
    }
  }

private:
  static constexpr int kChannel = 0; ///< the hue of HSV images
  static constexpr int kHues = 16;   ///< bins, as in OpenCV's example of CAMShift
  static constexpr float kRange[] = {0.0F, 180.0F};

  void convert(const cv::Mat& bgr) {
    cv::cvtColor(bgr, hsv_, cv::COLOR_BGR2HSV);
    cv::inRange(hsv_, cv::Scalar(0, 30, 10), cv::Scalar(180, 256, 256), colored_);
  }

  bool adaptive_;
  const float* range_ = kRange;
  cv::Rect window_;
  cv::Mat hues_;
  cv::Mat hsv_;
  cv::Mat colored_;
};

} // namespace

Result<std::unique_ptr<BoxFollower>> makeDewpointFollower(const std::string& method, int particles,
                                                          std::uint64_t seed) {
  ParameterValues parameters(methodParameters(method));
  if (const auto set = parameters.set("particles", particles); !set) {
    return tl::make_unexpected(set.error());
  }
  auto tracker = makeTracker(method, parameters, CameraRig(1), std::vector<Target>(1));
  if (!tracker) {
    return tl::make_unexpected(tracker.error());
  }
  return std::make_unique<OwnFollower>(std::move(*tracker), seed);
}

const std::vector<std::string>& openCvFollowerNames() {
  static const std::vector<std::string> kNames{"camshift", "meanshift", "csrt", "kcf"};
  return kNames;
}

std::unique_ptr<BoxFollower> makeOpenCvFollower(const std::string& name) {
  if (name == "csrt") {
    return std::make_unique<CorrelationFollower>(cv::TrackerCSRT::create());
  }
  if (name == "kcf") {
    return std::make_unique<CorrelationFollower>(cv::TrackerKCF::create());
  }
  return std::make_unique<HueFollower>(name == "camshift");
}

const std::vector<std::string>& boxFollowerNames() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names = methodNames(TargetSource::Box);
    for (const std::string& name : openCvFollowerNames()) {
      names.push_back(name + kBoxSuffix);
    }
    return names;
  }();
  return kNames;
}

Result<std::unique_ptr<BoxFollower>> makeFollowerByName(const std::string& name, int particles,
                                                        std::uint64_t seed) {
  if (std::ranges::find(boxFollowerNames(), name) == boxFollowerNames().end()) {
    return failure(ErrorCode::NotFound, "", "--method", name + " follows no boxes");
  }
  if (name.ends_with(kBoxSuffix)) {
    return makeOpenCvFollower(name.substr(0, name.size() - std::strlen(kBoxSuffix)));
  }
  return makeDewpointFollower(name, particles, seed);
}

} // namespace dewpoint::experiment

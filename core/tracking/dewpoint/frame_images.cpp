// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/frame_images.h"

#include <algorithm>
#include <utility>

namespace dewpoint::tracking {

void FrameImages::setFrames(FrameSetPtr frames) {
  frames_ = std::move(frames);
}

FramePtr FrameImages::frame(std::size_t camera) const {
  return frames_ && camera < frames_->frames.size() ? frames_->frames[camera] : nullptr;
}

double FrameImages::timeOffset(std::size_t camera) const {
  const FramePtr image = frame(camera);
  return image ? seconds(image->captureTime - frames_->time) - delays_[camera] : 0.0;
}

void FrameImages::passImagesTo(SphereObservation& observation, const AdaptiveColor& color) const {
  for (std::size_t camera = 0; camera < backgrounds_.size(); ++camera) {
    const FramePtr image = frame(camera);
    observation.setImage(camera, image ? image->image : cv::Mat(), timeOffset(camera),
                         backgrounds_[camera], color.classifierInUse(camera),
                         color.learnedClassifier());
  }
}

void FrameImages::passImagesTo(RegionObservation& observation, const AdaptiveColor& color) const {
  for (std::size_t camera = 0; camera < backgrounds_.size(); ++camera) {
    const FramePtr image = frame(camera);
    observation.setImage(camera, image ? image->image : cv::Mat(), timeOffset(camera),
                         backgrounds_[camera], color.classifierInUse(camera),
                         color.learnedClassifier());
  }
}

void FrameImages::setBackgroundImages(const std::vector<cv::Mat>& images) {
  for (std::size_t camera = 0; camera < std::min(images.size(), backgrounds_.size()); ++camera) {
    backgrounds_[camera].setBackgroundImage(images[camera]);
  }
}

void FrameImages::resetBackgrounds() {
  for (BackgroundModel& background : backgrounds_) {
    background.reset();
  }
}

void FrameImages::resetReferenceLight() {
  for (BackgroundModel& background : backgrounds_) {
    background.resetReferenceLight();
  }
}

void FrameImages::adaptToLight() {
  for (std::size_t camera = 0; camera < backgrounds_.size(); ++camera) {
    if (const FramePtr image = frame(camera)) {
      backgrounds_[camera].adaptToLight(image->image);
    }
  }
}

void FrameImages::learnBackground(std::size_t camera,
                                  const std::vector<BackgroundModel::ExcludedCircle>& hidden,
                                  bool noTargetElsewhere) {
  backgrounds_[camera].learn(frame(camera)->image, hidden, noTargetElsewhere);
}

void FrameImages::forgetFamiliarPixels() {
  for (BackgroundModel& background : backgrounds_) {
    background.forgetFamiliarPixels();
  }
}

void FrameImages::forgetFamiliarPixels(std::size_t camera,
                                       const BackgroundModel::ExcludedCircle& circle) {
  backgrounds_[camera].forgetFamiliarPixels(circle);
}

std::size_t FrameImages::memoryBytes() const {
  std::size_t bytes = 0;
  for (const BackgroundModel& background : backgrounds_) {
    bytes += background.memoryBytes();
  }
  return bytes;
}

} // namespace dewpoint::tracking

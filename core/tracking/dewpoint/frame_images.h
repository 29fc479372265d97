// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/observation/background/background_model.h"
#include "core/observation/region/region_observation.h"
#include "core/observation/sphere/adaptive_color.h"
#include "core/observation/sphere/sphere_observation.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <vector>

namespace dewpoint::tracking {

/// The images of the frame that is being tracked, and what each camera usually shows.
class FrameImages {
public:
  explicit FrameImages(std::size_t cameraCount) : backgrounds_(cameraCount) {}

  std::size_t cameraCount() const { return backgrounds_.size(); }
  /// The images of a frame; null for none.
  void setFrames(FrameSetPtr frames);
  const FrameSetPtr& frames() const { return frames_; }
  /// A camera's image; null when there is none.
  FramePtr frame(std::size_t camera) const;
  /// Seconds by which a camera's image was taken after the frame's time.
  double timeOffset(std::size_t camera) const;
  /// Shows the images to an observation. They, the backgrounds and the color must outlive its use.
  void showTo(SphereObservation& observation, const AdaptiveColor& color) const;

  void showTo(RegionObservation& observation, const AdaptiveColor& color) const;

  /// Images without targets, per camera; empty where not known. Known from the next
  /// resetBackgrounds() on.
  void setEmptyRooms(const std::vector<cv::Mat>& images);
  void resetBackgrounds();
  /// The light of now becomes the one that colors are relative to.
  void resetReferenceLight();
  /// Adapts the backgrounds to the light of the frame; before it is shown to any observation.
  void followLight();
  /// Learns a camera's background from the frame, but not inside `hidden`, as
  /// BackgroundModel::learn(). There must be an image.
  void learnBackground(std::size_t camera, const std::vector<BackgroundModel::Hidden>& hidden,
                       bool noTargetElsewhere);
  /// BackgroundModel::forgetEmptyPlaces() of all cameras, and inside a circle in one.
  void forgetEmptyPlaces();
  void forgetEmptyPlaces(std::size_t camera, const BackgroundModel::Hidden& circle);
  const BackgroundModel& background(std::size_t camera) const { return backgrounds_[camera]; }
  /// Bytes of the backgrounds.
  std::size_t memoryBytes() const;

private:
  FrameSetPtr frames_;
  std::vector<BackgroundModel> backgrounds_;
};

} // namespace dewpoint::tracking

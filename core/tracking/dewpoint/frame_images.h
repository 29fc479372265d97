// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/observation/background/background_model.h"
#include "core/observation/region/region_observation.h"
#include "core/observation/sphere/adaptive_color.h"
#include "core/observation/sphere/sphere_observation.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace dewpoint::tracking {

/// Images of the frame being tracked, and the background of each camera.
class FrameImages {
public:
  explicit FrameImages(std::size_t cameraCount)
      : backgrounds_(cameraCount), delays_(cameraCount, 0.0) {}

  std::size_t cameraCount() const { return backgrounds_.size(); }
  /// Sets the images of a frame, or removes all images if `frames` is null.
  void setFrames(FrameSetPtr frames);
  const FrameSetPtr& frames() const { return frames_; }
  /// Returns the image of a camera, or null if the camera has no image.
  FramePtr frame(std::size_t camera) const;
  /// Sets the delay of each camera in seconds: the time from the capture of an image to its time
  /// stamp.
  void setDelays(std::vector<double> delays) { delays_ = std::move(delays); }
  /// Returns the time in seconds from the time of the frame to the capture of a camera's image. The
  /// capture time is the time stamp of the image minus the delay from setDelays().
  double timeOffset(std::size_t camera) const;
  /// Passes the images of all cameras to an observation model. The images, the backgrounds and
  /// `color` must remain valid while the observation is used.
  void passImagesTo(SphereObservation& observation, const AdaptiveColor& color) const;

  void passImagesTo(RegionObservation& observation, const AdaptiveColor& color) const;

  /// Sets the background images, one per camera. The image is empty for a camera without a
  /// background image. The images take effect at the next resetBackgrounds().
  void setBackgroundImages(const std::vector<cv::Mat>& images);
  void resetBackgrounds();
  /// Makes the light of the newest images the reference, relative to which later changes of the
  /// light are measured.
  void resetReferenceLight();
  /// Adapts the backgrounds to the light of the frame. Call it before the images are passed to an
  /// observation.
  void adaptToLight();
  /// Learns a camera's background from the frame, except inside the circles `hidden`. Set
  /// `noTargetElsewhere` if there certainly is no target outside these circles. The camera must
  /// have an image.
  void learnBackground(std::size_t camera,
                       const std::vector<BackgroundModel::ExcludedCircle>& hidden,
                       bool noTargetElsewhere);
  /// Discards, for the images of all cameras, which pixels of the background are known to have the
  /// target color (BackgroundModel::forgetFamiliarPixels()).
  void forgetFamiliarPixels();
  /// Discards which pixels of the background inside a circle are known to have the target color,
  /// for the image of one camera.
  void forgetFamiliarPixels(std::size_t camera, const BackgroundModel::ExcludedCircle& circle);
  const BackgroundModel& background(std::size_t camera) const { return backgrounds_[camera]; }
  /// Returns the size of the backgrounds in bytes.
  std::size_t memoryBytes() const;

private:
  FrameSetPtr frames_;
  std::vector<BackgroundModel> backgrounds_;
  std::vector<double> delays_; ///< seconds
};

} // namespace dewpoint::tracking

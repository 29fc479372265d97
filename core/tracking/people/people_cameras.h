// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/capture/frame.h"
#include "core/geometry/camera.h"
#include "core/geometry/projector.h"
#include "core/observation/background/foreground_model.h"
#include "core/tracking/people/people_parameters.h"
#include "core/tracking/people_state.h"

#include <opencv2/core/mat.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace dewpoint::tracking {

/// Cameras as used by methods for people: images reduced in size, their motion masks, and
/// projectors for the reduced size.
class PeopleCameras {
public:
  PeopleCameras(const CameraRig& rig, const PeopleSettings& settings);

  /// Returns whether all background models can be copied. If not, a copy of this object has no
  /// background models.
  bool canBeCopied() const;
  /// Returns the approximate size of a copy in bytes.
  std::size_t memoryBytes() const;

  void setRig(const CameraRig& rig);
  void configure(const PeopleSettings& settings) { settings_ = settings; }
  void setBackgroundImages(const std::vector<cv::Mat>& images) { backgroundImages_ = images; }
  /// Restarts, so that the next frame is treated as the first frame.
  void restart();
  /// Computes the motion masks of a frame. `keep` has one image per camera, of the mask's size or
  /// empty. Pixels that are nonzero in `keep` are not learned as background.
  void computeForegroundMasks(const FrameSet& frames, const std::vector<cv::Mat>& keep,
                              ThreadTeam& team);

  std::size_t cameraCount() const { return views_.size(); }
  const Projector& projector(std::size_t camera) const { return views_[camera].projector; }
  /// Returns the camera with intrinsics for the reduced images. The pose is unchanged.
  const Camera& camera(std::size_t camera) const { return views_[camera].camera; }
  bool isUsable(std::size_t camera) const { return states_[camera].isUsable; }
  const cv::Mat& image(std::size_t camera) const { return views_[camera].image; }
  const cv::Mat& foregroundMask(std::size_t camera) const { return views_[camera].mask; }
  const std::vector<PeopleCameraState>& cameraStates() const { return states_; }
  /// Returns the seconds between the last two frames.
  double secondsBetweenFrames() const { return interval_; }
  std::int64_t frameNumber() const { return frame_; }

private:
  /// Background model that is copied together with its owner.
  class Model {
  public:
    Model() = default;
    Model(std::unique_ptr<ForegroundModel> model) : model_(std::move(model)) {} // NOLINT: implicit
    Model(const Model& other)
        : model_(other.copyable() != nullptr ? other.copyable()->clone() : nullptr) {}
    Model(Model&&) noexcept = default;
    Model& operator=(const Model&) = delete;
    Model& operator=(Model&&) noexcept = default;
    ~Model() = default;
    explicit operator bool() const { return model_ != nullptr; }
    ForegroundModel* operator->() const { return model_.get(); }
    /// Returns the model as one that can be copied; null if there is none, or if it cannot be
    /// copied.
    const CopyableForeground* copyable() const { return copyableForeground(model_.get()); }

  private:
    std::unique_ptr<ForegroundModel> model_;
  };
  struct View {
    Camera camera; ///< camera of the reduced images
    Projector projector;
    cv::Mat image; ///< reduced image; the pixels of `image` and `mask` are never changed afterward
    cv::Mat mask;
    Model model;
    int learnedFrameCount = 0;
  };

  void updateMask(const FrameSet& frames, std::size_t camera, const cv::Mat& keep);
  void learnBackgroundImage(std::size_t camera);
  ForegroundSettings foregroundSettings() const;

  PeopleSettings settings_;
  CameraRig rig_;
  std::vector<View> views_;
  std::vector<PeopleCameraState> states_;
  std::vector<cv::Mat> backgroundImages_;
  std::int64_t frame_ = -1;
  TimeStamp time_{};
  double interval_ = 0.0;
  double sinceStart_ = 0.0;
};

} // namespace dewpoint::tracking

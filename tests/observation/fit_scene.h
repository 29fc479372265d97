// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/sphere/outline_fit.h"
#include "tests/observation/drawn_spheres.h"

#include <memory>
#include <vector>

namespace dewpoint::tests::drawn {

/// Cameras with what they see of some balls, before a wall they know.
class FitScene {
public:
  explicit FitScene(const CameraRig& rig) : rig_(rig) {
    for (const Camera& camera : rig_) {
      projectors_.emplace_back(camera);
      backgrounds_.emplace_back();
      for (int frame = 0; frame < 20; ++frame) {
        backgrounds_.back().learn(wall(camera), {});
      }
      images_.push_back(wall(camera));
      labels_.emplace_back();
    }
  }

  std::size_t cameraCount() const { return rig_.size(); }
  cv::Mat& image(std::size_t camera) { return images_[camera]; }
  const SphereProjector& projector(std::size_t camera) const { return projectors_[camera]; }

  void show(const std::vector<Ball>& balls, double noise = 0.0, std::uint32_t frame = 0) {
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      images_[k] = draw(rig_[k], balls);
      if (noise > 0.0) {
        addNoise(images_[k], noise, frame, 99 + k);
      }
    }
  }

  /// The labels of the images as they are now.
  std::vector<OutlineView> views() {
    std::vector<OutlineView> all;
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      labels_[k].setImage(images_[k], backgrounds_[k], classifier_);
      all.push_back({&projectors_[k], &labels_[k], Eigen::Vector3d::Zero()});
    }
    return all;
  }
  LabelImage& labels(std::size_t camera) { return labels_[camera]; }

private:
  CameraRig rig_;
  ColorClassifier classifier_{kRed};
  std::vector<SphereProjector> projectors_;
  std::vector<BackgroundModel> backgrounds_;
  std::vector<cv::Mat> images_;
  std::vector<LabelImage> labels_;
};

} // namespace dewpoint::tests::drawn

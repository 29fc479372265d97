// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid_image.h"
#include "core/observation/region/region_observation.h"
#include "tests/observation/drawn_spheres.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include <memory>
#include <vector>

namespace dewpoint::tests::drawn {

/// What tests paint into the images by hand.
inline const cv::Scalar kRedPaint(0, 0, 230);
inline const cv::Scalar kSomethingNew(200, 40, 40);

/// An ellipsoid of these semi-axes (meters), rotated by `angle` radians about `axis`.
inline Ellipsoid ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& semiAxes,
                           double angle = 0.0, const Eigen::Vector3d& axis = {0.3, 1.0, 0.5}) {
  const Eigen::Matrix3d turned(Eigen::AngleAxisd(angle, axis.normalized()));
  return {center, turned * semiAxes.cwiseAbs2().asDiagonal() * turned.transpose()};
}

/// Paints the pixels whose rays hit the ellipsoid. Without lens distortion.
inline void paint(cv::Mat& image, const Camera& camera, const Ellipsoid& solid,
                  const cv::Vec3b& color = {0, 0, 230}) {
  const Eigen::Matrix3d inverse = solid.extent.inverse();
  const Eigen::Vector3d eye = camera.center() - solid.center;
  const Eigen::Matrix3d worldFromCamera = camera.cameraFromWorld.linear().transpose();
  const Intrinsics& in = camera.intrinsics;
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const Eigen::Vector3d way =
          worldFromCamera *
          Eigen::Vector3d((column - in.centerX) / in.focalX, (row - in.centerY) / in.focalY, 1.0);
      const double b = way.dot(inverse * eye);
      if (b < 0.0 && b * b - way.dot(inverse * way) * (eye.dot(inverse * eye) - 1.0) >= 0.0) {
        image.at<cv::Vec3b>(row, column) = color;
      }
    }
  }
}

/// Cameras with what they see of some red ellipsoids, before a wall they know.
class RegionScene {
public:
  explicit RegionScene(const CameraRig& rig) : rig_(rig), observation_(rig) {
    for (const Camera& camera : rig_) {
      backgrounds_.emplace_back();
      for (int frame = 0; frame < 20; ++frame) {
        backgrounds_.back().learn(wall(camera), {});
      }
      images_.push_back(wall(camera));
    }
  }

  cv::Mat& image(std::size_t camera) { return images_[camera]; }
  void show(const std::vector<Ellipsoid>& solids) {
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      images_[k] = wall(rig_[k]);
      for (const Ellipsoid& solid : solids) {
        paint(images_[k], rig_[k], solid);
      }
    }
  }
  /// With the images as they are now.
  RegionObservation& observation() {
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      observation_.setImage(k, images_[k], 0.0, backgrounds_[k], classifier_, classifier_);
    }
    return observation_;
  }

private:
  CameraRig rig_;
  ColorClassifier classifier_{kRed};
  std::vector<BackgroundModel> backgrounds_;
  std::vector<cv::Mat> images_;
  RegionObservation observation_;
};

} // namespace dewpoint::tests::drawn

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/particle_set.h"
#include "core/geometry/camera.h"
#include "core/geometry/projector.h"
#include "core/observation/boxes/motion_likelihood.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace dewpoint::observation {

/// Input from one camera in a frame, for the methods of Mohedano et al. 2009.
struct PersonCamera {
  const Projector* projector = nullptr;
  /// Motion likelihood image D, CV_32FC1; see computeMotionLikelihood(). Empty if the camera has no
  /// image.
  cv::Mat motionLikelihood;
  cv::Mat image; ///< CV_8UC3 of the same size; used by the color cue only
};

/// Observation model of Mohedano et al. 2009. In the MS variant, the likelihood of a particle is
/// the product over all cameras of D at the particle's projection, where D is the motion likelihood
/// image. In the MS+C variant, the product also contains the color likelihood at this pixel. The
/// columns of a state are x y z vx vy vz (meters, m/s). With MS+C, hue and saturation follow, both
/// in [0, 1]. If the projection of a particle is outside a camera's image, each factor has its
/// lowest value: `floor` for D, and exp(ColorCue::minLogLikelihoodPerPixel()) for the color. The
/// paper does not specify this case. Without the color factor, a particle outside the image would
/// get a higher likelihood than a particle inside the image at pixels of the wrong color.
class PersonObservation {
public:
  PersonObservation(std::vector<PersonCamera> cameras, double floor, std::optional<ColorCue> color)
      : cameras_(std::move(cameras)), floor_(floor), color_(color) {}

  /// Adds the log likelihood of each state to `logLikelihood`.
  void addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const {
    constexpr Eigen::Index kBlockSize = 128;
    std::array<double, kBlockSize> column;
    std::array<double, kBlockSize> row;
    for (Eigen::Index begin = 0; begin < rows.rows(); begin += kBlockSize) {
      const Eigen::Index count = std::min(kBlockSize, rows.rows() - begin);
      for (const PersonCamera& camera : cameras_) {
        if (camera.motionLikelihood.empty()) {
          continue;
        }
        camera.projector->projectBatch(count, rows.col(0).data() + begin,
                                       rows.col(1).data() + begin, rows.col(2).data() + begin,
                                       column.data(), row.data());
        for (Eigen::Index i = 0; i < count; ++i) {
          const auto at = static_cast<std::size_t>(i);
          const double hue = color_ ? rows(begin + i, 6) : 0.0;
          const double saturation = color_ ? rows(begin + i, 7) : 0.0;
          logLikelihood[begin + i] += logLikelihoodAt(camera, column[at], row[at], hue, saturation);
        }
      }
    }
  }

private:
  double logLikelihoodAt(const PersonCamera& camera, double column, double row, double hue,
                         double saturation) const {
    cv::Point pixel;
    if (!findNearestPixel(column, row, camera.motionLikelihood, pixel)) {
      return std::log(floor_) + (color_ ? color_->minLogLikelihoodPerPixel() : 0.0);
    }
    double sum = std::log(static_cast<double>(camera.motionLikelihood.at<float>(pixel)));
    if (color_) {
      sum += color_->logLikelihood(camera.image.ptr(pixel.y, pixel.x), hue, saturation);
    }
    return sum;
  }

  std::vector<PersonCamera> cameras_;
  double floor_;
  std::optional<ColorCue> color_;
};

} // namespace dewpoint::observation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid_image.h"
#include "core/geometry/ray.h"
#include "core/observation/background/label_image.h"

#include <cstddef>
#include <vector>

namespace dewpoint::observation {

/// Images of all cameras in which a target of any shape is measured.
class RegionObservation {
public:
  /// Camera and its image.
  struct View {
    EllipsoidProjector projector;
    Unprojector unprojector;
    LabelImage labels;       ///< labels of the image; empty if the camera has no image
    double timeOffset = 0.0; ///< image time relative to the frame time, seconds
  };

  explicit RegionObservation(const CameraRig& rig) {
    views_.reserve(rig.size());
    for (const Camera& camera : rig) {
      views_.push_back({EllipsoidProjector(camera), Unprojector(camera), {}});
    }
  }

  std::size_t cameraCount() const { return views_.size(); }
  std::vector<View>& views() { return views_; }
  const std::vector<View>& views() const { return views_; }

  /// Sets the image of a camera, taken `timeOffset` seconds after the frame's time. The image is
  /// empty if the camera has none. `classifier` tests for the target color in the light of the
  /// image, `usual` in the reference light (BackgroundModel::relativeLight()).
  void setImage(std::size_t camera, const cv::Mat& image, double timeOffset,
                const BackgroundModel& background, const ColorClassifier& classifier,
                const ColorClassifier& usual) {
    View& view = views_.at(camera);
    view.timeOffset = timeOffset;
    if (image.type() != CV_8UC3 || image.empty()) {
      view.labels.clear();
    } else {
      view.labels.setImage(image, background, classifier, usual);
    }
  }

private:
  std::vector<View> views_;
};

} // namespace dewpoint::observation

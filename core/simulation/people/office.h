// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/simulation/people/movable_furniture.h"
#include "core/simulation/people/walker.h"
#include "core/simulation/room/view_cache.h"
#include "core/simulation/sensor/usual_camera.h"

#include <opencv2/core.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace dewpoint::simulation {

/// Returns four 320x240 cameras in the upper corners of the simulated office (7 x 7 x 2.7 m). The
/// cameras are 2.4 m above the floor and look at the center of the office.
CameraRig officeRig();

/// Scene with people in the simulated office, with shadows, and with furniture that partly hides
/// people. Clothes may have the same colors as the room, so that the motion masks of people break
/// into pieces.
struct OfficeScene {
  CameraRig cameras = officeRig();
  std::vector<simulation::Walker> people;
  std::vector<MovableFurniture> furniture; ///< in addition to the fixed furniture
  double framesPerSecond = 15.0;
  std::int64_t frameCount = 150;
  std::uint64_t seed = 1;                 ///< seed of the sensor noise
  double noiseSigma = kDefaultNoiseSigma; ///< standard deviation of the sensor noise, gray levels

  double timeOf(std::int64_t frame) const { return static_cast<double>(frame) / framesPerSecond; }
};

/// Renders an office scene.
class OfficeRenderer {
public:
  /// Creates a renderer that takes the views of the office without people from the cache `views`.
  /// Many renderers can share a cache.
  OfficeRenderer(OfficeScene scene, simulation::ViewCache& views);
  /// Creates a renderer with the given views of the office without people, one per camera of the
  /// scene, in camera order.
  OfficeRenderer(OfficeScene scene, std::vector<std::shared_ptr<const simulation::RoomView>> views);

  const OfficeScene& scene() const { return scene_; }
  /// Renders the image (CV_8UC3, BGR) of a camera in a frame. The result depends only on the scene
  /// and the arguments. If `who` is not null, it is set to the image that visiblePeopleMask()
  /// returns.
  cv::Mat render(std::size_t camera, std::int64_t frame, cv::Mat* who = nullptr) const;
  /// Returns which person is visible at each pixel, without rendering the image: CV_8UC1, 0 where
  /// no person is visible, otherwise 1 + the index of the person.
  cv::Mat visiblePeopleMask(std::size_t camera, std::int64_t frame) const;
  /// Returns the complete silhouette of a person as if nothing hid the person: CV_8UC1, 255 on the
  /// body, 0 elsewhere and on a carried object. The image is 0 everywhere while the person is
  /// absent. visiblePeopleMask() returns only the visible parts of silhouettes.
  cv::Mat silhouette(std::size_t camera, std::int64_t frame, std::size_t person) const;
  /// Returns the image of the office at time 0 without people and without noise (CV_8UC3).
  cv::Mat backgroundImage(std::size_t camera) const;
  /// Returns whether the person is present and inside the office walls.
  bool isInsideOffice(std::size_t person, double time) const;
  /// Returns the center of a person's body (world, meters) at a time (seconds): above the floor
  /// position, at half the height of the top of the head.
  Eigen::Vector3d bodyCenter(std::size_t person, double time) const;

private:
  /// Returns the light at the sensor (CV_32FC3).
  cv::Mat renderLight(std::size_t camera, std::int64_t frame, cv::Mat* who) const;

  OfficeScene scene_;
  std::vector<std::shared_ptr<const simulation::RoomView>> views_;
};

} // namespace dewpoint::simulation

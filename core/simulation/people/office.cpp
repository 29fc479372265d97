// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/people/office.h"

#include "core/geometry/camera_name.h"
#include "core/simulation/people/people_painter.h"
#include "core/simulation/sensor/sensor.h"

#include <array>
#include <utility>

namespace dewpoint::simulation {
CameraRig officeRig() {
  // World x and y, meters: 0.2 m inside the corners. 230 pixels are a lens of 70 degrees.
  static constexpr std::array<std::array<double, 2>, 4> kCorners{
      {{-3.3, -3.3}, {3.3, -3.3}, {3.3, 3.3}, {-3.3, 3.3}}};
  CameraRig rig;
  for (const auto& corner : kCorners) {
    Camera camera;
    camera.name = defaultCameraName(rig.size());
    camera.intrinsics = {320, 240, 230.0, 230.0, 159.5, 119.5};
    camera.cameraFromWorld = lookAt({corner[0], corner[1], 2.4}, {0.0, 0.0, 0.8});
    rig.push_back(camera);
  }
  return rig;
}

OfficeRenderer::OfficeRenderer(OfficeScene scene, simulation::ViewCache& views)
    : scene_(std::move(scene)) {
  for (const Camera& camera : scene_.cameras) {
    views_.push_back(views.view(camera, simulation::Furnishing::Office));
  }
}

OfficeRenderer::OfficeRenderer(OfficeScene scene,
                               std::vector<std::shared_ptr<const simulation::RoomView>> views)
    : scene_(std::move(scene)), views_(std::move(views)) {}

cv::Mat OfficeRenderer::renderLight(std::size_t camera, std::int64_t frame, cv::Mat* who) const {
  const auto& view = *views_.at(camera);
  std::vector<std::vector<simulation::BodyPart>> people;
  people.reserve(scene_.people.size() + scene_.furniture.size());
  const double time = scene_.timeOf(frame);
  for (const auto& walker : scene_.people) {
    people.push_back(walker.isPresentAt(time) ? bodyParts(walker, time)
                                              : std::vector<simulation::BodyPart>{});
  }
  for (const MovableFurniture& piece : scene_.furniture) {
    people.push_back(furnitureParts(piece, time));
  }
  cv::Mat image = view.background.clone();
  paintPeople(view, people, simulation::kOfficeLampPosition, image, who);
  return image;
}

cv::Mat OfficeRenderer::render(std::size_t camera, std::int64_t frame, cv::Mat* who) const {
  const cv::Mat image = renderLight(camera, frame, who);
  const RandomStream noise(scene_.seed, static_cast<std::uint32_t>(frame),
                           static_cast<std::uint32_t>(camera), RandomPurpose::Simulation);
  return simulation::digitize(image, scene_.noiseSigma, noise);
}

cv::Mat OfficeRenderer::visiblePeopleMask(std::size_t camera, std::int64_t frame) const {
  cv::Mat who;
  renderLight(camera, frame, &who);
  return who;
}

cv::Mat OfficeRenderer::silhouette(std::size_t camera, std::int64_t frame,
                                   std::size_t person) const {
  const double time = scene_.timeOf(frame);
  const auto& walker = scene_.people.at(person);
  return wholeSilhouette(*views_.at(camera), walker.isPresentAt(time)
                                                 ? bodyParts(walker, time)
                                                 : std::vector<simulation::BodyPart>{});
}

cv::Mat OfficeRenderer::backgroundImage(std::size_t camera) const {
  const auto& view = *views_.at(camera);
  cv::Mat empty = view.background;
  if (!scene_.furniture.empty()) {
    std::vector<std::vector<simulation::BodyPart>> pieces;
    pieces.reserve(scene_.furniture.size());
    for (const MovableFurniture& piece : scene_.furniture) {
      pieces.push_back(furnitureParts(piece, 0.0));
    }
    empty = view.background.clone();
    paintPeople(view, pieces, simulation::kOfficeLampPosition, empty);
  }
  cv::Mat image;
  empty.convertTo(image, CV_8UC3);
  return image;
}

bool OfficeRenderer::isInsideOffice(std::size_t person, double time) const {
  const auto& walker = scene_.people.at(person);
  return walker.isPresentAt(time) &&
         walker.positionAt(time).cwiseAbs().maxCoeff() < double{kOfficeHalfSize};
}

Eigen::Vector3d OfficeRenderer::bodyCenter(std::size_t person, double time) const {
  const auto& walker = scene_.people.at(person);
  const Eigen::Vector2d position = walker.positionAt(time);
  return {position.x(), position.y(), 0.5 * walker.topHeightAt(time)};
}

} // namespace dewpoint::simulation

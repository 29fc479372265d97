// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/scene/scene_renderer.h"

#include "core/base/thread_count.h"
#include "core/base/thread_team.h"
#include "core/simulation/body/body_painter.h"
#include "core/simulation/room/room.h"
#include "core/simulation/sensor/sensor.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::simulation {
namespace {

using simulation::Body;
using simulation::RoomView;
using simulation::Vector3f;

/// Width, height and thickness of the occluder, halved; meters; chosen: larger than a ball.
const Vector3f kOccluderHalf{0.06F, 0.09F, 0.012F};

} // namespace

struct SceneRenderer::Parts {
  explicit Parts(Scene theScene);

  std::vector<Body> bodiesAt(double time) const;

  Scene scene;
  std::vector<RoomView> views;
  Eigen::Matrix3f occluderAxes = Eigen::Matrix3f::Identity(); ///< rows: its axes in the world
};

SceneRenderer::Parts::Parts(Scene theScene) : scene(std::move(theScene)) {
  const simulation::Room room(scene.hasClutter ? simulation::Furnishing::ClutteredDesk
                                               : simulation::Furnishing::Desk);
  const auto count = static_cast<std::int64_t>(scene.cameras.size());
  std::vector<std::optional<RoomView>> built(scene.cameras.size());
  ThreadTeam team(threadCountForTasks(scene.cameras.size()));
  team.forEachRange(count, [&](std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      built[i].emplace(scene.cameras[i], room);
    }
  });
  for (auto& view : built) {
    views.push_back(std::move(*view));
  }
  if (!scene.cameras.empty()) {
    occluderAxes = scene.cameras.front().cameraFromWorld.linear().cast<float>();
  }
}

std::vector<Body> SceneRenderer::Parts::bodiesAt(double time) const {
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    const SceneBall& ball = scene.balls[i];
    bodies.push_back({false, ballPosition(scene, static_cast<int>(i), time).cast<float>(),
                      static_cast<float>(ball.radius), ball.color.cast<float>()});
  }
  if (!scene.balls.empty()) {
    for (int i = 0; i < scene.distractorCount; ++i) {
      bodies.push_back({false, distractorPosition(scene, i).cast<float>(), bodies.front().radius,
                        bodies.front().color});
    }
    if (scene.hasOccluder) {
      bodies.push_back({true,
                        occluderPosition(scene, time).cast<float>(),
                        kOccluderHalf.norm(),
                        {150.0F, 122.0F, 96.0F},
                        kOccluderHalf,
                        occluderAxes});
    }
  }
  return bodies;
}

SceneRenderer::SceneRenderer(Scene scene)
    : parts_(std::make_unique<const Parts>(std::move(scene))) {}
SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

cv::Mat SceneRenderer::render(int camera, std::int64_t frame) const {
  const RoomView& view = parts_->views.at(static_cast<std::size_t>(camera));
  cv::Mat image = view.background.clone();
  simulation::paintBodies(
      view, [this](double time) { return parts_->bodiesAt(time); },
      {frameTime(scene(), frame), scene().exposureSeconds}, image);
  const Eigen::Vector3d gain = lightGain(scene(), frameTime(scene(), frame));
  if (gain != Eigen::Vector3d::Ones()) {
    cv::multiply(image, cv::Scalar(gain[0], gain[1], gain[2], 0.0), image);
  }
  const RandomStream stream(scene().seed, static_cast<std::uint32_t>(frame),
                            static_cast<std::uint32_t>(camera), RandomPurpose::Simulation);
  return simulation::digitize(image, scene().noiseSigma, stream);
}

const Scene& SceneRenderer::scene() const {
  return parts_->scene;
}

} // namespace dewpoint::simulation

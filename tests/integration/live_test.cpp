// SPDX-License-Identifier: GPL-3.0-or-later
// Two network cameras on this machine's loopback, tracked live by the same session as the window's.
#include "app/wiring/open_project.h"
#include "core/simulation/scene/scene_renderer.h"
#include "tests/capture/mjpeg_server.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace dewpoint::tests {
namespace {

TEST(Live, TwoLoopbackStreamsAreTrackedToTheBall) {
  Scene scene = demoScene();
  scene.balls.front().motion = Motion::Still;
  const SceneRenderer renderer(scene);
  const cv::Mat pictures[] = {renderer.render(0, 0), renderer.render(1, 0)};
  test::MjpegServer left([&](auto&&...) { return pictures[0]; });
  test::MjpegServer right([&](auto&&...) { return pictures[1]; });

  Project project = makeSceneProject(scene, "");
  project.cameras[0].source = project.cameras[1].source = SourceKind::Stream;
  project.cameras[0].location = left.address();
  project.cameras[1].location = right.address();
  auto inputs = openInputs(project);
  ASSERT_TRUE(inputs) << errorSentence(inputs.error());
  Session session(std::move(*inputs));
  session.play();

  // JPEG blurs the ball's rim a little; the paper's 3 cm is the bound all the same.
  const Eigen::Vector3d truth = ballPosition(scene, 0, 0.0);
  double error = 1.0;
  for (int wait = 0; wait < 600 && error > 0.03; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const auto snapshot = session.newest();
    if (!snapshot->targets.empty() &&
        std::get<SphereEstimate>(snapshot->targets.front().estimate).isValid) {
      error = (std::get<SphereEstimate>(snapshot->targets.front().estimate).mean - truth).norm();
    }
  }
  EXPECT_LT(error, 0.03);
  EXPECT_FALSE(session.newest()->frameCount.has_value()) << "it is live";
}

} // namespace
} // namespace dewpoint::tests

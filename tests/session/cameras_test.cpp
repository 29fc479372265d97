// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/tracking_run.h"
#include "core/session/session.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using test::eventually;
using test::inputs;
using test::reaches;

Project projectWithMethod(const std::string& method) {
  Project project = test::twoCameraProject();
  project.method = method;
  project.parameters = ParameterValues(methodParameters(method));
  project.parameters.markAllAsGiven();
  return project;
}

/// Every camera moved by so many meters along x of the world.
CameraRig shifted(CameraRig rig, double meters) {
  for (Camera& camera : rig) {
    camera.cameraFromWorld.translation() -=
        camera.cameraFromWorld.linear() * Eigen::Vector3d(meters, 0.0, 0.0);
  }
  return rig;
}

void step(Session& session, std::int64_t frames) {
  for (std::int64_t k = 0; k < frames; ++k) {
    const std::int64_t before = session.newest()->iterationCount;
    session.stepFrame();
    ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount > before; }));
  }
}

class Cameras : public testing::TestWithParam<std::string> {};

TEST_P(Cameras, AnotherCalibrationActsAtTheNextStepAndKeepsTheBelief) {
  const Project project = projectWithMethod(GetParam());
  Session session(inputs({}, project));
  step(session, 4);
  const auto before = session.newest();
  const bool holds = GetParam() == "dewpoint"; // the other one wanders long before it holds
  ASSERT_TRUE(!holds || std::get<SphereEstimate>(before->targets[0].estimate).isValid);
  const CameraRig rig = shifted(rigOf(project), 0.01);
  session.setCameras(rig);
  ASSERT_TRUE(eventually([&] { return *session.newest()->rig == rig; }));
  EXPECT_EQ(session.newest()->iterationCount, before->iterationCount) << "nothing starts over";
  EXPECT_EQ(session.newest()->frame, before->frame);
  step(session, 4);
  const auto after = session.newest();
  EXPECT_GT(after->iterationCount, before->iterationCount);
  if (!holds) {
    return;
  }
  EXPECT_TRUE(std::get<SphereEstimate>(after->targets[0].estimate).isValid);
  // The world moved by 1 cm with the cameras, and so did the target in it.
  EXPECT_NEAR(std::get<SphereEstimate>(after->targets[0].estimate).mean.x() -
                  std::get<SphereEstimate>(before->targets[0].estimate).mean.x(),
              0.01, 0.008);
}

TEST_P(Cameras, GoingBackBeforeTheChangeTracksTheSameAgain) {
  const Project project = projectWithMethod(GetParam());
  Session session(inputs({}, project));
  step(session, 5);
  session.setCameras(shifted(rigOf(project), 0.004));
  session.setCameras(shifted(rigOf(project), 0.01));
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Ended));
  const Trajectory first = session.trajectory();
  session.rerunFrom(8);
  ASSERT_TRUE(eventually([&] {
    return session.trajectory().samples.size() == first.samples.size() && !session.newest()->rerun;
  }));
  EXPECT_TRUE(test::sameBits(session.trajectory(), first));
}

TEST(OtherCameras, OtherImagesAreAnotherRun) {
  const Project project = projectWithMethod("dewpoint");
  Session session(inputs({}, project));
  CameraRig rig = rigOf(project);
  rig[0].intrinsics.width += 2;
  session.setCameras(rig);
  step(session, 1);
  EXPECT_TRUE(*session.newest()->rig == rigOf(project));
}

INSTANTIATE_TEST_SUITE_P(Methods, Cameras, testing::Values("dewpoint", "barrera"));

} // namespace
} // namespace dewpoint::tests

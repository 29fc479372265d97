// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/projector.h"
#include "core/simulation/scene/scene_catalog.h"
#include "core/simulation/scene/scene_file.h"
#include "core/simulation/scene/scene_renderer.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

/// Pixels of the pink ball, in ratios so that its dark underside counts too. Nothing else in the
/// room is pink; wood and skin have less blue than green.
cv::Mat pinkPixels(const cv::Mat& image) {
  cv::Mat mask(image.size(), CV_8UC1, cv::Scalar(0));
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const auto& pixel = image.at<cv::Vec3b>(row, column);
      const bool pink = pixel[2] > 1.5 * pixel[1] && pixel[0] > 1.15 * pixel[1];
      mask.at<std::uint8_t>(row, column) = pink ? 255 : 0;
    }
  }
  return mask;
}

Scene stillScene() {
  Scene scene = demoScene();
  scene.balls.front().motion = Motion::Still;
  return scene;
}

TEST(SceneRenderer, TheBallIsWhereTheTruthSays) {
  for (const std::int64_t frame : {0, 90, 150, 210, 299}) {
    Scene noiseless = demoScene();
    noiseless.noiseSigma = 0.0; // it would tip dark pixels either way
    const SceneRenderer renderer(noiseless);
    const Scene& scene = renderer.scene();
    const auto truth = ballPosition(scene, 0, frameTime(scene, frame));
    for (int camera = 0; camera < 2; ++camera) {
      const auto moments = cv::moments(pinkPixels(renderer.render(camera, frame)), true);
      const auto center = Projector(scene.cameras[static_cast<std::size_t>(camera)]).project(truth);
      ASSERT_TRUE(center);
      // A sphere's outline is centered a little outside its center's projection: at 25 px radius
      // and 20 degrees off the axis about 0.3 px; noise and the dark rim add the rest.
      EXPECT_NEAR(moments.m10 / moments.m00, center->x(), 1.5) << camera << " " << frame;
      EXPECT_NEAR(moments.m01 / moments.m00, center->y(), 1.5) << camera << " " << frame;
      const auto& view = scene.cameras[static_cast<std::size_t>(camera)];
      const double depth = (view.cameraFromWorld * truth).z();
      const double radius = view.intrinsics.focalX * scene.balls.front().radius / depth;
      const double seen = std::sqrt(moments.m00 / std::numbers::pi);
      EXPECT_NEAR(seen / radius, 1.0, 0.06) << camera << " " << frame;
    }
  }
}

TEST(SceneRenderer, CameraTwoIsPortraitAsInThePaper) {
  const SceneRenderer renderer(demoScene());
  EXPECT_EQ(renderer.render(0, 0).size(), cv::Size(320, 240));
  EXPECT_EQ(renderer.render(1, 0).size(), cv::Size(240, 320));
}

TEST(SceneRenderer, TheSameSeedGivesTheSameBytesInAnyOrder) {
  const SceneRenderer one(demoScene());
  const SceneRenderer two(demoScene());
  const cv::Mat late = one.render(0, 7);
  const cv::Mat early = two.render(0, 3);
  EXPECT_EQ(cv::norm(one.render(0, 3), early, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(two.render(0, 7), late, cv::NORM_INF), 0.0);
  Scene other = demoScene();
  other.seed = 2;
  EXPECT_GT(cv::norm(SceneRenderer(other).render(0, 3), early, cv::NORM_INF), 0.0);
}

TEST(SceneRenderer, SensorNoiseHasTheStatedSize) {
  Scene scene = stillScene();
  const cv::Mat noisy = SceneRenderer(scene).render(0, 0);
  scene.noiseSigma = 0.0;
  const cv::Mat clean = SceneRenderer(scene).render(0, 0);
  cv::Mat difference;
  cv::subtract(noisy, clean, difference, cv::noArray(), CV_32F);
  cv::Scalar mean;
  cv::Scalar sigma;
  cv::meanStdDev(difference, mean, sigma);
  // Rounding to whole gray levels adds 1/12: sqrt(9 + 1/12) = 3.01.
  EXPECT_NEAR(sigma[1], 3.0, 0.1);
  EXPECT_NEAR(mean[1], 0.0, 0.1);
}

TEST(SceneRenderer, TheLightChangesAsTheSceneSays) {
  Scene scene = stillScene();
  scene.noiseSigma = 0.0;
  const cv::Mat full = SceneRenderer(scene).render(0, 0);
  scene.lights = {{1.0, 0.5, 5500.0}, {3.0, 0.125, 5500.0}};
  EXPECT_NEAR(lightGain(scene, 0.0)[1], 0.5, 1e-12);
  EXPECT_NEAR(lightGain(scene, 2.0)[1], 0.25, 1e-12) << "equal factors in equal times";
  EXPECT_NEAR(lightGain(scene, 9.0)[1], 0.125, 1e-12);
  const cv::Mat dark = SceneRenderer(scene).render(0, 300);
  EXPECT_LE(cv::norm(dark, full * 0.125, cv::NORM_INF), 1.0);
  scene.lights = {{0.0, 1.0, 4500.0}};
  const Eigen::Vector3d warm = lightGain(scene, 0.0);
  // Planck's law by hand: exp(-0.014388 (1/4500 - 1/5500) (1/460e-9 - 1/540e-9)) = 0.829.
  EXPECT_NEAR(warm[0], 0.829, 0.003);
  EXPECT_EQ(warm[1], 1.0);
  EXPECT_GT(warm[2], 1.1);

  const auto again = parseScene(sceneToml(scene), "scene.toml");
  ASSERT_TRUE(again) << errorSentence(again.error());
  ASSERT_EQ(again->lights.size(), 1U);
  EXPECT_EQ(again->lights[0].colorTemperature, 4500.0);
  EXPECT_EQ(parseScene("[[light]]\nbrightness = 0\n", "dark.toml").error().field,
            "light 1.brightness");
}

TEST(SceneRenderer, DistractorsAddBallsOfTheSameColor) {
  Scene scene = stillScene();
  const double one = cv::countNonZero(pinkPixels(SceneRenderer(scene).render(0, 0)));
  scene.distractorCount = 3;
  const double four = cv::countNonZero(pinkPixels(SceneRenderer(scene).render(0, 0)));
  EXPECT_GT(four, 1.3 * one); // smaller where they lie farther off
}

TEST(SceneRenderer, TheOccluderHidesTheBallForAWhile) {
  Scene scene = stillScene();
  scene.hasOccluder = true;
  const SceneRenderer renderer(scene);
  int fewest = 1 << 20;
  int most = 0;
  for (std::int64_t frame = 0; frame < scene.frameCount; frame += 5) {
    const int seen = cv::countNonZero(pinkPixels(renderer.render(0, frame)));
    fewest = std::min(fewest, seen);
    most = std::max(most, seen);
  }
  EXPECT_LT(fewest, most / 20);
}

TEST(SceneFile, ComesBackAsItWas) {
  Scene scene = demoScene();
  scene.distractorCount = 2;
  scene.hasOccluder = true;
  scene.seed = 11;
  const auto parsed = parseScene(sceneToml(scene), "scene.toml");
  ASSERT_TRUE(parsed) << errorSentence(parsed.error());
  EXPECT_EQ(parsed->distractorCount, 2);
  EXPECT_TRUE(parsed->hasOccluder);
  EXPECT_EQ(parsed->seed, 11U);
  EXPECT_EQ(parsed->balls.front().color, scene.balls.front().color);
  EXPECT_EQ(parsed->balls.front().stillSeconds, scene.balls.front().stillSeconds);
  ASSERT_EQ(parsed->cameras.size(), scene.cameras.size());
  for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
    // The file holds the optical center, not the translation: rounding in the last digit.
    EXPECT_TRUE(
        parsed->cameras[k].cameraFromWorld.isApprox(scene.cameras[k].cameraFromWorld, 1e-14));
  }
}

TEST(SceneFile, NamesFileAndKeyOfWhatIsWrong) {
  const auto unknown = parseScene("colour = 3\n", "scene.toml");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().file, "scene.toml");
  EXPECT_EQ(unknown.error().field, "colour");
  const auto missing = loadScene("no-such-scene");
  ASSERT_FALSE(missing);
}

TEST(Scene, EveryBuiltInNameOpens) {
  for (const auto& name : sceneNames()) {
    EXPECT_TRUE(loadScene(name)) << name;
  }
}

// A filter of one iteration per frame takes up to 25 of them.
TEST(Scene, TheBallRestsWhileAFilterIsWatchedConverging) {
  const auto scene = loadScene("converge");
  ASSERT_TRUE(scene);
  EXPECT_EQ(ballPosition(*scene, 0, frameTime(*scene, 25)), ballPosition(*scene, 0, 0.0));
  EXPECT_GT(frameTime(*scene, 15), 1.5); // slow enough to be seen
}

TEST(Scene, TheDemoBallRestsFirstAndThenMoves) {
  const Scene scene = demoScene();
  EXPECT_EQ(ballPosition(scene, 0, 0.0), ballPosition(scene, 0, 1.9)); // still for 2 s
  EXPECT_GT((ballPosition(scene, 0, 3.0) - ballPosition(scene, 0, 0.0)).norm(), 0.02);
}

} // namespace
} // namespace dewpoint::tests

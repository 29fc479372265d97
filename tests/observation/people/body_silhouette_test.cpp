// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/people/body_silhouette.h"
#include "core/observation/people/person_score.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace dewpoint::tests {
namespace {

/// At the origin, 1 m high, looking along x, level.
Camera levelCamera() {
  Camera camera;
  camera.intrinsics = {200, 200, 100.0, 100.0, 100.0, 100.0};
  camera.cameraFromWorld = lookAt({0.0, 0.0, 1.0}, {1.0, 0.0, 1.0});
  return camera;
}

TEST(BodySilhouette, StandsWhereItIsSeen) {
  const SilhouetteProjector maker(levelCamera());
  const BodySilhouette body = maker.project({4.0, 0.0}, 0.0, 2.0);
  ASSERT_TRUE(body.isVisible);
  // The feet 1 m below the axis at 4 m: 25 px; the head as far above. Edges of pixels lie at
  // halves.
  EXPECT_EQ(body.partRects.front().br().y, 126);
  EXPECT_EQ(body.partRects.back().y, 76);
  for (int k = 0; k < kBodyPartCount; ++k) {
    const cv::Rect& piece = body.partRects[static_cast<std::size_t>(k)];
    EXPECT_NEAR(piece.width, 2.0 * 25.0 * bodyHalfWidth(k, 2.0), 1.0);
    EXPECT_NEAR(piece.x + 0.5 * piece.width, 100.5, 0.6);
  }
  EXPECT_FALSE(maker.project({-4.0, 0.0}, 0.0, 2.0).isVisible); // behind
}

TEST(ScoreSums, AreMeansOverRectangles) {
  cv::Mat mask = cv::Mat::zeros(40, 60, CV_8UC1);
  mask(cv::Rect(10, 10, 10, 10)).setTo(255);
  cv::Mat explained = cv::Mat::zeros(40, 60, CV_8UC1);
  explained(cv::Rect(10, 15, 10, 5)).setTo(255);
  ScoreSums scores;
  scores.build(maskScores(mask, cv::Mat()));
  EXPECT_NEAR(scores.mean({10, 10, 10, 10}), kMovingPixel, 0.02); // bytes
  EXPECT_NEAR(scores.mean({30, 10, 10, 10}), kStillPixel, 0.02);
  EXPECT_NEAR(scores.mean({5, 10, 10, 10}), 0.5 * (kMovingPixel + kStillPixel), 0.02);
  // Half outside the image: that half says nothing.
  EXPECT_NEAR(scores.mean({-5, 30, 10, 10}), 0.5 * kStillPixel, 0.02);
  EXPECT_EQ(scores.mean({-50, -50, 10, 10}), 0.0);
  scores.build(maskScores(mask, explained));
  EXPECT_NEAR(scores.mean({10, 10, 10, 10}), 0.5 * kMovingPixel, 0.02);
}

TEST(BodyScore, TheUpperHalfCountsByItself) {
  // A column of six pieces of 10 x 10 pixels; the upper three move, but for half of the head.
  BodySilhouette body;
  body.isVisible = true;
  for (int k = 0; k < kBodyPartCount; ++k) {
    body.partRects[static_cast<std::size_t>(k)] =
        cv::Rect(20, 10 * (kBodyPartCount - 1 - k), 10, 10);
  }
  cv::Mat mask = cv::Mat::zeros(60, 60, CV_8UC1);
  mask(cv::Rect(20, 5, 10, 25)).setTo(255);
  ScoreSums scores;
  scores.build(maskScores(mask, cv::Mat()));
  // Two whole pieces and one that is half moving, half still: bytes round to 0.02.
  const double head = 0.5 * (kMovingPixel + kStillPixel);
  EXPECT_NEAR(upperBodyScore(scores, body, -0.25), (2.0 * kMovingPixel + head) / 3.0, 0.02);
  // The legs add three pieces at the floor, which is above what still pixels say (-0.3).
  EXPECT_NEAR(bodyScore(scores, body, -0.25), (2.0 * kMovingPixel + head + 3.0 * -0.25) / 6.0,
              0.02);
  // A piece says at least the floor, also of the upper half.
  scores.build(maskScores(cv::Mat::zeros(60, 60, CV_8UC1), cv::Mat()));
  EXPECT_NEAR(upperBodyScore(scores, body, -0.2), -0.2, 1e-9);
  body.isVisible = false;
  EXPECT_EQ(upperBodyScore(scores, body, -0.2), 0.0);
}

TEST(ClothesModel, TellsColorsApart) {
  const cv::Rect body(10, 10, 20, 60);
  BodySilhouette silhouette;
  silhouette.isVisible = true;
  for (int k = 0; k < kBodyPartCount; ++k) {
    silhouette.partRects[static_cast<std::size_t>(k)] =
        cv::Rect(body.x, body.y + 10 * (kBodyPartCount - 1 - k), body.width, 10);
  }
  cv::Mat mask = cv::Mat::zeros(80, 60, CV_8UC1);
  mask(body).setTo(255);
  const cv::Mat blue(80, 60, CV_8UC3, cv::Scalar(180, 70, 50));
  const cv::Mat red(80, 60, CV_8UC3, cv::Scalar(50, 60, 180));
  ClothesModel one;
  ClothesModel other;
  EXPECT_FALSE(one.isKnown());
  for (int look = 0; look < 5; ++look) {
    one.learn(blue, mask, silhouette, cv::Mat());
    one.finishFrame();
    other.learn(red, mask, silhouette, cv::Mat());
    other.finishFrame();
  }
  ASSERT_TRUE(one.isKnown());
  const ClothesRatio ratio = one.logRatioAgainst(other);
  // log(1.01 / 0.01) is cut at 1.
  EXPECT_NEAR(ClothesModel::meanLogRatioInSilhouette(ratio, blue, mask, silhouette, cv::Mat()), 1.0,
              1e-6);
  EXPECT_NEAR(ClothesModel::meanLogRatioInSilhouette(ratio, red, mask, silhouette, cv::Mat()), -1.0,
              1e-6);
  EXPECT_EQ(ClothesModel::meanLogRatioInSilhouette(ratio, red, mask, silhouette, mask),
            0.0); // covered
}

} // namespace
} // namespace dewpoint::tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/background/background_model.h"
#include "core/observation/background/label_image.h"
#include "tests/observation/drawn_spheres.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

constexpr int kModelWidth = 80;
constexpr int kModelHeight = 60;
/// Far more frames than it takes to learn a pixel, or to replace it.
constexpr int kMany = 400;

cv::Mat plain(int blue, int green, int red) {
  return {kModelHeight, kModelWidth, CV_8UC3, cv::Scalar(blue, green, red)};
}

void learn(BackgroundModel& model, const cv::Mat& image, int frames = kMany,
           const std::vector<BackgroundModel::ExcludedCircle>& hidden = {}) {
  for (int frame = 0; frame < frames; ++frame) {
    model.learn(image, hidden);
  }
}

/// The labels of a whole image.
cv::Mat labelsOf(const BackgroundModel& model, const cv::Mat& image) {
  cv::Mat labels(image.size(), CV_8UC1);
  const std::vector<std::uint8_t> none(static_cast<std::size_t>(image.cols), 0); // no match
  for (int row = 0; row < image.rows; ++row) {
    model.labelRow(image, 0, row, image.cols, none.data(), labels.ptr<std::uint8_t>(row));
  }
  return labels;
}

int count(const cv::Mat& labels, PixelLabel label) {
  return cv::countNonZero(labels == static_cast<int>(label));
}
constexpr int kAll = kModelWidth * kModelHeight;

TEST(BackgroundModel, KnowsNothingAtFirstAndAfterReset) {
  BackgroundModel model;
  const cv::Mat image = plain(90, 100, 110);
  EXPECT_EQ(count(labelsOf(model, image), PixelLabel::Unlearned), kAll);
  model.learn(image, {});
  EXPECT_EQ(count(labelsOf(model, image), PixelLabel::Unlearned), kAll); // one look is not enough
  learn(model, image);
  EXPECT_EQ(count(labelsOf(model, image), PixelLabel::Background), kAll);
  model.reset();
  EXPECT_EQ(count(labelsOf(model, image), PixelLabel::Unlearned), kAll);
  EXPECT_EQ(model.novelPixelShare(), 0.0);
}

TEST(BackgroundModel, TellsTheUsualFromTheNew) {
  BackgroundModel model;
  cv::Mat image = plain(90, 100, 110);
  learn(model, image);
  const cv::Rect thing(20, 10, 30, 25);
  image(thing) = cv::Scalar(20, 160, 40);
  const cv::Mat labels = labelsOf(model, image);
  EXPECT_EQ(count(labels, PixelLabel::Unknown), thing.area());
  EXPECT_EQ(count(labels(thing), PixelLabel::Unknown), thing.area());
  EXPECT_EQ(count(labels, PixelLabel::Background), kAll - thing.area());
}

TEST(BackgroundModel, LabelsAnyPartOfARow) {
  BackgroundModel model;
  cv::Mat image = plain(90, 100, 110);
  learn(model, image);
  image.at<cv::Vec3b>(7, 33) = cv::Vec3b(0, 0, 0);
  std::vector<std::uint8_t> labels(5, 99);
  const std::vector<std::uint8_t> matched{0, 0, 0, 255};
  model.labelRow(image, 31, 7, 4, matched.data(), labels.data());
  const auto usual = static_cast<std::uint8_t>(PixelLabel::Background);
  const auto odd = static_cast<std::uint8_t>(PixelLabel::Unknown);
  const auto target = static_cast<std::uint8_t>(PixelLabel::Target);
  EXPECT_EQ(labels, (std::vector<std::uint8_t>{usual, usual, odd, target, 99}));
}

// Noise of 4 gray levels on three channels: five standard deviations stay within 20 levels. What
// the model calls usual must take nearly all of it.
TEST(BackgroundModel, ToleratesNoise) {
  BackgroundModel model;
  for (std::uint32_t frame = 0; frame < 200; ++frame) {
    cv::Mat image = plain(90, 100, 110);
    drawn::addNoise(image, 4.0, frame);
    model.learn(image, {});
  }
  cv::Mat image = plain(90, 100, 110);
  drawn::addNoise(image, 4.0, 1000);
  EXPECT_GT(count(labelsOf(model, image), PixelLabel::Background), 0.99 * kAll);
  EXPECT_LT(model.novelPixelShare(), 0.01);
}

TEST(BackgroundModel, FollowsLightThatChangesSlowly) {
  BackgroundModel model;
  learn(model, plain(90, 100, 110));
  for (int level = 0; level <= 60; ++level) {
    learn(model, plain(90 + level, 100 + level, 110 + level), 32);
    EXPECT_EQ(model.novelPixelShare(), 0.0) << level;
  }
  EXPECT_EQ(count(labelsOf(model, plain(150, 160, 170)), PixelLabel::Background), kAll);
}

TEST(BackgroundModel, WhatStaysReplacesTheOldAndWhatPassesDoesNot) {
  BackgroundModel model;
  const cv::Mat usual = plain(90, 100, 110);
  const cv::Mat other = plain(200, 30, 30);
  learn(model, usual);
  learn(model, other, 8); // two looks at every row
  EXPECT_EQ(count(labelsOf(model, other), PixelLabel::Unknown), kAll);
  EXPECT_EQ(count(labelsOf(model, usual), PixelLabel::Background), kAll);
  learn(model, other);
  EXPECT_EQ(count(labelsOf(model, other), PixelLabel::Background), kAll);
  EXPECT_EQ(count(labelsOf(model, usual), PixelLabel::Unknown), kAll);
}

/// Distance of the pixel from the rim of the nearest circle, negative inside of one.
double outsideOf(const std::vector<BackgroundModel::ExcludedCircle>& circles, int column, int row) {
  double nearest = 1e9;
  for (const auto& circle : circles) {
    nearest =
        std::min(nearest, (Eigen::Vector2d(column, row) - circle.center).norm() - circle.radius);
  }
  return nearest;
}

// Circles inside, overlapping, one within another, across every border and wholly outside.
TEST(BackgroundModel, HiddenCirclesAreNotLearned) {
  const std::vector<std::vector<BackgroundModel::ExcludedCircle>> cases{
      {{{40.3, 30.7}, 9.0}},
      {{{30.0, 30.0}, 12.0}, {{45.0, 32.0}, 12.0}, {{45.0, 32.0}, 4.0}},
      {{{-2.0, 20.0}, 8.0}, {{79.5, 50.0}, 6.5}, {{20.0, -3.0}, 9.0}, {{60.0, 62.0}, 10.0}},
      {{{60.0, 30.0}, 5.0}, {{20.0, 30.0}, 5.0}, {{40.0, 30.0}, 15.0}, {{200.0, 30.0}, 20.0}},
      {{{40.0, 30.0}, 0.0}},
  };
  for (std::size_t k = 0; k < cases.size(); ++k) {
    BackgroundModel model;
    const cv::Mat image = plain(90, 100, 110);
    learn(model, image, kMany, cases[k]);
    const cv::Mat labels = labelsOf(model, image);
    for (int row = 0; row < kModelHeight; ++row) {
      for (int column = 0; column < kModelWidth; ++column) {
        const double outside = outsideOf(cases[k], column, row);
        const auto label = static_cast<PixelLabel>(labels.at<std::uint8_t>(row, column));
        if (outside < -1e-9) {
          EXPECT_EQ(label, PixelLabel::Unlearned) << k << ": " << column << ", " << row;
        } else if (outside > 1.5) {
          EXPECT_EQ(label, PixelLabel::Background) << k << ": " << column << ", " << row;
        }
      }
    }
  }
}

/// The labels of a whole image that has the target's color everywhere.
cv::Mat labelsOfTargetColor(const BackgroundModel& model, const cv::Mat& image) {
  cv::Mat labels(image.size(), CV_8UC1);
  const std::vector<std::uint8_t> all(static_cast<std::size_t>(image.cols), 255);
  for (int row = 0; row < image.rows; ++row) {
    model.labelRow(image, 0, row, image.cols, all.data(), labels.ptr<std::uint8_t>(row));
  }
  return labels;
}

/// Frames in which all targets are inside the circles.
void learnElsewhere(BackgroundModel& model, const cv::Mat& image, int frames,
                    const std::vector<BackgroundModel::ExcludedCircle>& hidden = {}) {
  for (int frame = 0; frame < frames; ++frame) {
    model.learn(image, hidden, true);
  }
}

TEST(BackgroundModel, WhatHasTheColorWhileEveryTargetIsElsewhereIsNone) {
  BackgroundModel model;
  const cv::Mat poster = plain(200, 30, 180);
  learn(model, poster);
  EXPECT_EQ(count(labelsOfTargetColor(model, poster), PixelLabel::Target), kAll);
  learnElsewhere(model, poster, 8); // two looks at every row
  EXPECT_EQ(count(labelsOfTargetColor(model, poster), PixelLabel::Target), kAll);
  learnElsewhere(model, poster, 8);
  EXPECT_EQ(count(labelsOfTargetColor(model, poster), PixelLabel::Explained), kAll);
  // What is new there is the target.
  EXPECT_EQ(count(labelsOfTargetColor(model, plain(140, 30, 240)), PixelLabel::Target), kAll);
}

TEST(BackgroundModel, WhatHasTheColorIsTheTargetWhereItWasHidden) {
  BackgroundModel model;
  const cv::Mat poster = plain(200, 30, 180);
  learnElsewhere(model, poster, kMany, {{{40.0, 30.0}, 10.0}});
  const cv::Mat labels = labelsOfTargetColor(model, poster);
  EXPECT_EQ(labels.at<std::uint8_t>(30, 40), static_cast<int>(PixelLabel::Target));
  EXPECT_EQ(labels.at<std::uint8_t>(30, 20), static_cast<int>(PixelLabel::Explained));
}

TEST(BackgroundModel, EmptyPlacesAreForgottenEverywhereOrInsideACircle) {
  BackgroundModel model;
  const cv::Mat poster = plain(200, 30, 180);
  learnElsewhere(model, poster, kMany);
  model.forgetFamiliarPixels({{40.0, 30.0}, 10.0});
  const cv::Mat labels = labelsOfTargetColor(model, poster);
  EXPECT_EQ(labels.at<std::uint8_t>(30, 40), static_cast<int>(PixelLabel::Target));
  EXPECT_EQ(labels.at<std::uint8_t>(30, 20), static_cast<int>(PixelLabel::Explained));
  model.forgetFamiliarPixels();
  EXPECT_EQ(count(labelsOfTargetColor(model, poster), PixelLabel::Target), kAll);
}

TEST(BackgroundModel, ABackgroundImageIsNotForgotten) {
  BackgroundModel model;
  const cv::Mat poster = plain(200, 30, 180);
  model.setBackgroundImage(poster);
  model.reset();
  model.forgetFamiliarPixels();
  model.forgetFamiliarPixels({{40.0, 30.0}, 10.0});
  EXPECT_EQ(count(labelsOfTargetColor(model, poster), PixelLabel::Explained), kAll);
}

TEST(BackgroundModel, WhatReplacesAnEmptyPlaceIsNotEmpty) {
  BackgroundModel model;
  const cv::Mat poster = plain(200, 30, 180);
  const cv::Mat other = plain(20, 120, 20);
  learnElsewhere(model, poster, kMany);
  learn(model, other); // nobody says where the target is
  EXPECT_EQ(count(labelsOfTargetColor(model, other), PixelLabel::Target), kAll);
}

TEST(BackgroundModel, NovelShareIsNearOneOnABlackFrame) {
  BackgroundModel model;
  const cv::Mat usual = plain(90, 100, 110);
  EXPECT_EQ(model.novelPixelShare(), 0.0);
  learn(model, usual);
  EXPECT_EQ(model.novelPixelShare(), 0.0);
  model.learn(plain(0, 0, 0), {});
  EXPECT_GT(model.novelPixelShare(), 0.99);
  model.learn(usual, {});
  EXPECT_EQ(model.novelPixelShare(), 0.0);
}

TEST(BackgroundModel, NovelShareIsTheShareOfThePicture) {
  BackgroundModel model;
  cv::Mat image = plain(90, 100, 110);
  learn(model, image);
  image(cv::Rect(0, 0, kModelWidth / 4, kModelHeight)) = cv::Scalar(0, 0, 0);
  model.learn(image, {});
  EXPECT_NEAR(model.novelPixelShare(), 0.25, 1e-9);
}

TEST(BackgroundModel, ANewSizeStartsAnewAndNoImageChangesNothing) {
  BackgroundModel model;
  learn(model, plain(90, 100, 110));
  model.learn(cv::Mat(), {});
  EXPECT_EQ(count(labelsOf(model, plain(90, 100, 110)), PixelLabel::Background), kAll);
  const cv::Mat small(10, 12, CV_8UC3, cv::Scalar(1, 2, 3));
  EXPECT_EQ(count(labelsOf(model, small), PixelLabel::Unlearned), 120);
  learn(model, small);
  EXPECT_EQ(count(labelsOf(model, small), PixelLabel::Background), 120);
  EXPECT_EQ(count(labelsOf(model, plain(90, 100, 110)), PixelLabel::Unlearned), kAll);
}

/// A wall with a pattern, so that light and things can be told apart.
cv::Mat checkered() {
  cv::Mat image(kModelHeight, kModelWidth, CV_8UC3);
  for (int row = 0; row < kModelHeight; ++row) {
    for (int column = 0; column < kModelWidth; ++column) {
      const int shade = 60 + 20 * ((row / 10 + column / 10) % 5);
      image.at<cv::Vec3b>(row, column) =
          cv::Vec3b(static_cast<std::uint8_t>(shade - 10), static_cast<std::uint8_t>(shade),
                    static_cast<std::uint8_t>(shade + 10));
    }
  }
  return image;
}

cv::Mat lit(const cv::Mat& image, const cv::Scalar& gain) {
  cv::Mat result;
  cv::multiply(image, gain, result);
  return result;
}

TEST(BackgroundModel, FollowsLightThatFades) {
  BackgroundModel model;
  learn(model, checkered());
  double gain = 1.0;
  for (int frame = 0; frame < 60; ++frame) {
    gain *= 0.98; // 0.98^60 = 0.30
    const cv::Mat now = lit(checkered(), cv::Scalar::all(gain));
    model.adaptToLight(now);
    EXPECT_EQ(count(labelsOf(model, now), PixelLabel::Background), kAll) << frame;
    model.learn(now, {});
  }
  EXPECT_NEAR(model.relativeLight().minCoeff(), gain, 0.03); // noticed from a fortieth on
  EXPECT_NEAR(model.relativeLight().maxCoeff(), gain, 0.03);
}

TEST(BackgroundModel, FollowsALampAndATint) {
  BackgroundModel model;
  learn(model, checkered());
  const cv::Mat now = lit(checkered(), cv::Scalar(0.5, 0.6, 0.8)); // blue, green, red
  EXPECT_LT(count(labelsOf(model, now), PixelLabel::Background), kAll / 2);
  model.adaptToLight(now);
  EXPECT_EQ(count(labelsOf(model, now), PixelLabel::Background), kAll);
  EXPECT_NEAR(model.relativeLight()[0], 0.5, 0.02);
  EXPECT_NEAR(model.relativeLight()[1], 0.6, 0.02);
  EXPECT_NEAR(model.relativeLight()[2], 0.8, 0.02);
  model.resetReferenceLight();
  EXPECT_EQ(model.relativeLight().maxCoeff(), 1.0);
  EXPECT_EQ(count(labelsOf(model, now), PixelLabel::Background), kAll);
}

std::array<std::uint8_t, kModelWidth> matchedRow(const BackgroundModel& model, const cv::Mat& image,
                                                 int row) {
  std::array<std::uint8_t, kModelWidth> labels{};
  std::array<std::uint8_t, kModelWidth> matched{};
  matched.fill(255);
  model.labelRow(image, 0, row, kModelWidth, matched.data(), labels.data());
  return labels;
}
bool all(const std::array<std::uint8_t, kModelWidth>& labels, PixelLabel label) {
  return std::ranges::all_of(labels, [&](auto one) { return one == std::uint8_t(label); });
}

TEST(BackgroundModel, TheBackgroundImageIsKnownFromTheFirstFrame) {
  BackgroundModel model;
  model.setBackgroundImage(checkered());
  EXPECT_EQ(count(labelsOf(model, checkered()), PixelLabel::Unlearned), kAll) << "not yet";
  model.reset();
  const cv::Mat darker = lit(checkered(), cv::Scalar::all(0.7)); // the day it is used on
  model.adaptToLight(darker);
  EXPECT_EQ(count(labelsOf(model, darker), PixelLabel::Background), kAll);
  EXPECT_EQ(model.relativeLight().maxCoeff(), 1.0) << "the light of the run is the usual one";
  EXPECT_EQ(count(labelsOf(model, plain(0, 0, 255)), PixelLabel::Unknown), kAll);
  // What matches but did so in the background image is no target; anything else that matches is.
  EXPECT_TRUE(all(matchedRow(model, darker, 5), PixelLabel::Explained));
  EXPECT_TRUE(all(matchedRow(model, plain(0, 0, 255), 5), PixelLabel::Target));

  const BackgroundModel copy = model;
  EXPECT_TRUE(all(matchedRow(copy, darker, 5), PixelLabel::Explained));
  // What stays is usual in the end, but was not in the background image.
  for (int frame = 0; frame < 200; ++frame) {
    model.learn(plain(0, 0, 255), {});
  }
  EXPECT_EQ(count(labelsOf(model, plain(0, 0, 255)), PixelLabel::Background), kAll);
  EXPECT_TRUE(all(matchedRow(model, plain(0, 0, 255), 5), PixelLabel::Target));
  model.reset();
  EXPECT_TRUE(all(matchedRow(model, checkered(), 5), PixelLabel::Explained));
}

TEST(BackgroundModel, ABackgroundImageOfAnotherSizeIsForgotten) {
  BackgroundModel model;
  model.setBackgroundImage(cv::Mat(10, 12, CV_8UC3, cv::Scalar(1, 2, 3)));
  model.reset();
  learn(model, checkered());
  EXPECT_EQ(count(labelsOf(model, checkered()), PixelLabel::Background), kAll);
  EXPECT_TRUE(all(matchedRow(model, checkered(), 5), PixelLabel::Target));
}

TEST(BackgroundModel, IsNotMisledByWhatIsNoLight) {
  BackgroundModel model;
  learn(model, checkered());
  cv::Mat hand = checkered(); // a hand before half of the image
  hand(cv::Rect(0, 0, kModelWidth, kModelHeight / 2 + 5)) = cv::Scalar(120, 150, 200);
  cv::Mat moved; // a camera that was turned
  cv::flip(checkered(), moved, 1);
  moved = lit(moved, cv::Scalar(1.3, 0.8, 0.6));
  for (const cv::Mat& now : {plain(0, 0, 0), plain(3, 2, 4), plain(255, 255, 255), hand, moved,
                             cv::Mat(), cv::Mat(10, 12, CV_8UC3, cv::Scalar(1, 2, 3))}) {
    model.adaptToLight(now);
    EXPECT_EQ(model.relativeLight().maxCoeff(), 1.0);
    EXPECT_EQ(model.relativeLight().minCoeff(), 1.0);
    EXPECT_EQ(count(labelsOf(model, checkered()), PixelLabel::Background), kAll);
  }
}

TEST(BackgroundModel, LightFadesToBlackAndReturns) {
  BackgroundModel model;
  learn(model, checkered());
  for (int frame = 0; frame < 100; ++frame) {
    const cv::Mat now = lit(checkered(), cv::Scalar::all(std::pow(0.93, frame)));
    model.adaptToLight(now);
    model.learn(now, {});
  }
  EXPECT_GE(model.relativeLight().minCoeff(), 1.0 / 8.0); // what is darker says nothing any more
}

} // namespace
} // namespace dewpoint::tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/sphere_evidence.h"
#include "tests/observation/drawn_spheres.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace dewpoint::tests {
namespace {

constexpr int kEvidenceWidth = 160;
constexpr int kEvidenceHeight = 120;
const SphereImage kEvidenceOutline{{80.0, 60.0}, 20.0};

cv::Mat evidenceImage() {
  return {kEvidenceHeight, kEvidenceWidth, CV_8UC3, cv::Scalar(80, 80, 80)};
}

/// A gray image with a red disc; `shift` sixteenths of a pixel are OpenCV's fixed point.
cv::Mat discImage(const SphereImage& disc) {
  cv::Mat image = evidenceImage();
  cv::circle(image, {cvRound(disc.center.x() * 16), cvRound(disc.center.y() * 16)},
             cvRound(disc.radius * 16), cv::Scalar(0, 0, 230), cv::FILLED, cv::LINE_8, 4);
  return image;
}

/// Labels of an image before a known gray wall (or one not known yet).
class SphereEvidenceTest : public ::testing::Test {
protected:
  SphereEvidenceTest() {
    for (int frame = 0; frame < 100; ++frame) {
      wall_.learn(evidenceImage(), {});
    }
  }
  const LabelImage& labelsOf(const cv::Mat& image, bool wallIsKnown = true) {
    labels_.setImage(image, wallIsKnown ? wall_ : nothing_, classifier_);
    labels_.ensureAllLabels();
    return labels_;
  }
  double logLikelihoodRatio(const cv::Mat& image, const SphereImage& outline = kEvidenceOutline) {
    return SphereEvidence::logLikelihoodRatio(labelsOf(image), outline);
  }

  ColorClassifier classifier_{drawn::kRed};
  BackgroundModel wall_;
  BackgroundModel nothing_;
  LabelImage labels_;
};

TEST_F(SphereEvidenceTest, AColorThatGoesOnAroundDoesNotEnd) {
  EXPECT_EQ(SphereEvidence::rimShare(labelsOf(discImage(kEvidenceOutline)), kEvidenceOutline), 1.0);
  // A disc within a larger one, and in the corner of a poster, of which two sides end.
  EXPECT_EQ(SphereEvidence::rimShare(labelsOf(discImage({kEvidenceOutline.center, 40.0})),
                                     kEvidenceOutline),
            0.0);
  cv::Mat poster = evidenceImage();
  cv::rectangle(poster, {60, 40}, {150, 110}, cv::Scalar(0, 0, 230), cv::FILLED);
  EXPECT_LE(SphereEvidence::rimShare(labelsOf(poster), kEvidenceOutline), 0.5);
}

TEST_F(SphereEvidenceTest, WhatHidesTheRimDoesNotCount) {
  cv::Mat half = discImage(kEvidenceOutline);
  cv::rectangle(half, {80, 0}, {kEvidenceWidth - 1, kEvidenceHeight - 1}, cv::Scalar(200, 200, 30),
                cv::FILLED);
  EXPECT_GE(SphereEvidence::rimShare(labelsOf(half), kEvidenceOutline), 0.8);
  cv::Mat nearlyAll = discImage(kEvidenceOutline);
  cv::rectangle(nearlyAll, {64, 0}, {kEvidenceWidth - 1, kEvidenceHeight - 1},
                cv::Scalar(200, 200, 30), cv::FILLED);
  EXPECT_EQ(SphereEvidence::rimShare(labelsOf(nearlyAll), kEvidenceOutline), 0.0);
}

TEST_F(SphereEvidenceTest, AFullDiscIsTheBest) {
  EXPECT_GT(SphereEvidence::maxLogLikelihoodRatio(), 0.0);
  for (const double radius : {8.0, 20.0, 40.0}) {
    const SphereImage outline{{80.3, 59.6}, radius};
    EXPECT_NEAR(logLikelihoodRatio(discImage(outline), outline),
                SphereEvidence::maxLogLikelihoodRatio(), 1e-9)
        << radius;
    EXPECT_EQ(SphereEvidence::matchShare(labels_, outline), 1.0) << radius;
  }
}

TEST_F(SphereEvidenceTest, NothingThereSpeaksAgainst) {
  EXPECT_LT(logLikelihoodRatio(evidenceImage()), -0.5 * SphereEvidence::maxLogLikelihoodRatio());
  EXPECT_EQ(SphereEvidence::matchShare(labels_, kEvidenceOutline), 0.0);
  // A wall that is not known yet is no place to hide either.
  EXPECT_LT(SphereEvidence::logLikelihoodRatio(labelsOf(evidenceImage(), false), kEvidenceOutline),
            -0.5 * SphereEvidence::maxLogLikelihoodRatio());
}

// "A smaller or larger thing of the same color is told apart": next to nothing speaks for it.
TEST_F(SphereEvidenceTest, TooSmallSpeaksAgainst) {
  for (const double share : {0.1, 0.25, 0.4}) {
    EXPECT_LT(
        logLikelihoodRatio(discImage({kEvidenceOutline.center, share * kEvidenceOutline.radius})),
        0.0)
        << share;
  }
  EXPECT_LT(logLikelihoodRatio(discImage({kEvidenceOutline.center, 0.6 * kEvidenceOutline.radius})),
            0.1 * SphereEvidence::maxLogLikelihoodRatio());
}

TEST_F(SphereEvidenceTest, TooLargeHasNextToNoEvidence) {
  for (const double share : {1.5, 2.0, 5.0}) {
    EXPECT_LT(
        logLikelihoodRatio(discImage({kEvidenceOutline.center, share * kEvidenceOutline.radius})),
        0.1 * SphereEvidence::maxLogLikelihoodRatio())
        << share;
  }
}

TEST_F(SphereEvidenceTest, FallsWithTheDistanceFromTheDisc) {
  const cv::Mat image = discImage(kEvidenceOutline);
  double last = logLikelihoodRatio(image);
  for (double off = 0.25; off <= 2.0; off += 0.25) {
    const SphereImage moved{kEvidenceOutline.center +
                                Eigen::Vector2d(off * kEvidenceOutline.radius, 0.0),
                            kEvidenceOutline.radius};
    const double here = logLikelihoodRatio(image, moved);
    EXPECT_LE(here, last + 1e-9) << off;
    last = here;
  }
  EXPECT_LT(last, 0.0);
}

TEST_F(SphereEvidenceTest, UnknownCarriesNone) {
  const cv::Mat strange(kEvidenceHeight, kEvidenceWidth, CV_8UC3, cv::Scalar(230, 30, 30));
  EXPECT_EQ(logLikelihoodRatio(strange), 0.0);
}

// A half that something new hides costs what it would have added, no more: against half the disc
// missing before the known wall it is much better, and it still speaks for the target.
TEST_F(SphereEvidenceTest, AHiddenHalfIsNotEvidenceAgainst) {
  cv::Mat hidden = discImage(kEvidenceOutline);
  cv::Mat missing = hidden.clone();
  const cv::Rect left(0, 0, 80, kEvidenceHeight);
  hidden(left) = cv::Scalar(230, 30, 30);
  missing(left) = cv::Scalar(80, 80, 80);
  const double half = logLikelihoodRatio(hidden);
  EXPECT_NEAR(half, 0.5 * SphereEvidence::maxLogLikelihoodRatio(),
              0.1 * SphereEvidence::maxLogLikelihoodRatio());
  EXPECT_NEAR(SphereEvidence::matchShare(labels_, kEvidenceOutline), 0.5, 0.1);
  EXPECT_LT(logLikelihoodRatio(missing), 0.5 * half);
}

TEST_F(SphereEvidenceTest, WhatBelongsToAnotherTargetCarriesNone) {
  labelsOf(discImage(kEvidenceOutline));
  labels_.markExplained({kEvidenceOutline.center, 1.1 * kEvidenceOutline.radius}, {});
  EXPECT_EQ(SphereEvidence::logLikelihoodRatio(labels_, kEvidenceOutline), 0.0);
  EXPECT_EQ(SphereEvidence::matchShare(labels_, kEvidenceOutline), 0.0);
}

// A twin right beside it, known to be another target, does not count as a larger thing.
TEST_F(SphereEvidenceTest, AnExplainedTwinBesideDoesNotCountAsTooLarge) {
  cv::Mat image = discImage(kEvidenceOutline);
  const SphereImage twin{kEvidenceOutline.center + Eigen::Vector2d(41.0, 0.0), 20.0};
  cv::circle(image, {121, 60}, 20, cv::Scalar(0, 0, 230), cv::FILLED);
  labelsOf(image);
  labels_.markExplained({twin.center, 1.05 * twin.radius},
                        {kEvidenceOutline.center, 1.05 * kEvidenceOutline.radius});
  EXPECT_GT(SphereEvidence::logLikelihoodRatio(labels_, kEvidenceOutline),
            0.8 * SphereEvidence::maxLogLikelihoodRatio());
}

// The same twin, not marked: what it takes away in the ring is given back, to within what a clean
// ring would add at those samples; 1.2 each by the table, times 0.12.
TEST_F(SphereEvidenceTest, TheRingOfATwinBesideIsGivenBack) {
  cv::Mat image = discImage(kEvidenceOutline);
  const SphereImage twin{kEvidenceOutline.center + Eigen::Vector2d(41.0, 0.0), 20.0};
  cv::circle(image, {121, 60}, 20, cv::Scalar(0, 0, 230), cv::FILLED);
  const double alone = logLikelihoodRatio(image);
  const double ring = SphereEvidence::explainedRingGain(labels_, kEvidenceOutline, {twin});
  const double samples = ring / (0.12 * 9.0);
  EXPECT_GE(samples, 1.0);
  EXPECT_NEAR(samples, std::round(samples), 1e-9);
  EXPECT_NEAR(alone + ring, SphereEvidence::maxLogLikelihoodRatio() - 0.12 * 1.2 * samples, 1e-9);
}

TEST_F(SphereEvidenceTest, OnlyMatchingSamplesUnderOthersAreGivenBack) {
  labelsOf(discImage(kEvidenceOutline));
  const SphereImage twin{kEvidenceOutline.center + Eigen::Vector2d(41.0, 0.0), 20.0};
  EXPECT_EQ(SphereEvidence::explainedRingGain(labels_, kEvidenceOutline, {twin}),
            0.0); // it is not there
  labelsOf(discImage({kEvidenceOutline.center, 30.0}));
  EXPECT_EQ(SphereEvidence::explainedRingGain(labels_, kEvidenceOutline, {}), 0.0);
  EXPECT_EQ(
      SphereEvidence::explainedRingGain(labels_, kEvidenceOutline,
                                        {{kEvidenceOutline.center + Eigen::Vector2d(0, 80), 9.0}}),
      0.0);
}

TEST_F(SphereEvidenceTest, OutsideTheImageNone) {
  const cv::Mat image = evidenceImage();
  for (const Eigen::Vector2d& center :
       {Eigen::Vector2d(-100.0, 60.0), Eigen::Vector2d(400.0, 60.0), Eigen::Vector2d(80.0, -90.0),
        Eigen::Vector2d(80.0, 1e7), Eigen::Vector2d(-1e12, 1e12)}) {
    EXPECT_EQ(logLikelihoodRatio(image, {center, 20.0}), 0.0) << center.transpose();
  }
}

TEST_F(SphereEvidenceTest, AcrossTheBorderTheSeenPartCounts) {
  const SphereImage across{{0.0, 60.0}, 20.0};
  const double seen = logLikelihoodRatio(discImage(across), across);
  EXPECT_GT(seen, 0.4 * SphereEvidence::maxLogLikelihoodRatio());
  EXPECT_LT(seen, 0.7 * SphereEvidence::maxLogLikelihoodRatio());
  EXPECT_LT(logLikelihoodRatio(evidenceImage(), across), 0.0);
}

TEST_F(SphereEvidenceTest, FewPixelsCountLess) {
  double last = 0.0;
  for (const double radius : {0.8, 1.5, 2.5, 3.5}) {
    const SphereImage outline{{80.0, 60.0}, radius};
    const cv::Mat red(kEvidenceHeight, kEvidenceWidth, CV_8UC3, cv::Scalar(0, 0, 230));
    const double missing = -logLikelihoodRatio(evidenceImage(), outline);
    EXPECT_GT(missing, last) << radius;
    last = missing;
  }
  EXPECT_LT(last, -logLikelihoodRatio(evidenceImage()));
}

TEST_F(SphereEvidenceTest, AreaHoldsAllThatIsRead) {
  const cv::Rect area = areaOf(kEvidenceOutline, SphereEvidence::kSampleReach);
  LabelImage part;
  const cv::Mat image = discImage(kEvidenceOutline);
  part.setImage(image, wall_, classifier_);
  part.ensureLabels(area);
  EXPECT_EQ(SphereEvidence::logLikelihoodRatio(part, kEvidenceOutline), logLikelihoodRatio(image));
  // By hand: from 80 - 1.3 * 20 - 2 = 52 to 108, both included.
  EXPECT_EQ(area.x, 52);
  EXPECT_EQ(area.width, 57);
  EXPECT_EQ(area.y, 32);
  EXPECT_EQ(area.height, 57);
}

} // namespace
} // namespace dewpoint::tests

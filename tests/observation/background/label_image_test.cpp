// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/background/label_image.h"
#include "tests/observation/drawn_spheres.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <vector>

namespace dewpoint::tests {
namespace {

constexpr int kLabelWidth = 64;
constexpr int kLabelHeight = 48;
const cv::Scalar kGrayPaint(80, 80, 80);
const cv::Scalar kRedPixel(0, 0, 230);
const cv::Scalar kBluePixel(230, 0, 0);

cv::Mat grayImage() {
  return {kLabelHeight, kLabelWidth, CV_8UC3, kGrayPaint};
}

/// Gray with a red and a blue part, before a wall known to be gray.
class LabelImageTest : public ::testing::Test {
protected:
  LabelImageTest() {
    for (int frame = 0; frame < 100; ++frame) {
      background_.learn(grayImage(), {});
    }
    image_(red_) = kRedPixel;
    image_(blue_) = kBluePixel;
    labels_.setImage(image_, background_, classifier_);
  }

  cv::Rect red_{10, 8, 20, 16};
  cv::Rect blue_{40, 20, 12, 10};
  ColorClassifier classifier_{drawn::kRed};
  BackgroundModel background_;
  cv::Mat image_ = grayImage();
  LabelImage labels_;
};

TEST_F(LabelImageTest, LabelsAsDocumented) {
  labels_.ensureAllLabels();
  for (int row = 0; row < kLabelHeight; ++row) {
    for (int column = 0; column < kLabelWidth; ++column) {
      const cv::Point at(column, row);
      const PixelLabel expected = red_.contains(at)    ? PixelLabel::Target
                                  : blue_.contains(at) ? PixelLabel::Unknown
                                                       : PixelLabel::Background;
      EXPECT_EQ(labels_.at(column, row), expected) << column << ", " << row;
      EXPECT_EQ(labels_.labels().at<std::uint8_t>(row, column),
                static_cast<std::uint8_t>(expected));
    }
  }
}

TEST_F(LabelImageTest, WithoutABackgroundWhatDoesNotMatchIsUnlearned) {
  const BackgroundModel nothing;
  labels_.setImage(image_, nothing, classifier_);
  labels_.ensureAllLabels();
  EXPECT_EQ(labels_.at(12, 10), PixelLabel::Target);
  EXPECT_EQ(labels_.at(45, 25), PixelLabel::Unlearned);
  EXPECT_EQ(labels_.at(0, 0), PixelLabel::Unlearned);
}

TEST_F(LabelImageTest, OutsideWhatIsCoveredNothingIsEvidence) {
  EXPECT_EQ(labels_.at(12, 10), PixelLabel::Explained);
  labels_.ensureLabels({10, 8, 4, 4});
  EXPECT_EQ(labels_.at(12, 10), PixelLabel::Target);
  labels_.ensureAllLabels();
  for (const cv::Point& at : {cv::Point(-1, 10), cv::Point(10, -1), cv::Point(kLabelWidth, 10),
                              cv::Point(10, kLabelHeight), cv::Point(-1000000, 1000000)}) {
    EXPECT_EQ(labels_.at(at.x, at.y), PixelLabel::Explained);
  }
}

TEST_F(LabelImageTest, CoversWhatIsRequiredCutToTheImage) {
  EXPECT_TRUE(labels_.labeledArea().empty());
  labels_.ensureLabels({-50, -50, 10, 10}); // beside the image
  EXPECT_TRUE(labels_.labeledArea().empty());
  labels_.ensureLabels({-5, 40, 20, 100});
  EXPECT_EQ(labels_.labeledArea() & cv::Rect(0, 40, 15, 8), cv::Rect(0, 40, 15, 8));
  labels_.ensureLabels({30, 10, 5, 5});
  EXPECT_EQ(labels_.labeledArea() & cv::Rect(0, 40, 15, 8), cv::Rect(0, 40, 15, 8));
  EXPECT_EQ(labels_.labeledArea() & cv::Rect(30, 10, 5, 5), cv::Rect(30, 10, 5, 5));
  labels_.ensureAllLabels();
  EXPECT_EQ(labels_.labeledArea(), cv::Rect(0, 0, kLabelWidth, kLabelHeight));
}

TEST_F(LabelImageTest, PartsMadeLazilyEqualTheWhole) {
  const LabelImage::Circle other{{16.4, 12.2}, 6.3};
  const LabelImage::Circle except{{20.1, 14.0}, 3.0};
  LabelImage whole;
  whole.setImage(image_, background_, classifier_);
  whole.ensureAllLabels();
  whole.markExplained(other, except);
  // The explanation comes between the parts; it holds for labels made later as well.
  const std::vector<cv::Rect> parts{{12, 9, 5, 5}, {14, 4, 9, 7}, {0, 0, 3, 48}, {40, 22, 30, 30}};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (k == 1) {
      labels_.markExplained(other, except);
    }
    labels_.ensureLabels(parts[k]);
    if (k < 1) {
      continue;
    }
    const cv::Rect covered = labels_.labeledArea();
    EXPECT_EQ((covered & parts[k]), (cv::Rect(0, 0, kLabelWidth, kLabelHeight) & parts[k]));
    for (int row = covered.y; row < covered.y + covered.height; ++row) {
      for (int column = covered.x; column < covered.x + covered.width; ++column) {
        ASSERT_EQ(labels_.at(column, row), whole.at(column, row)) << column << ", " << row;
      }
    }
  }
}

TEST_F(LabelImageTest, ExplainsMatchingPixelsOfACircleButForTheException) {
  labels_.ensureAllLabels();
  const LabelImage::Circle other{{28.0, 16.0}, 7.0};
  const LabelImage::Circle except{{24.0, 16.0}, 3.5};
  labels_.markExplained(other, except);
  int explained = 0;
  int kept = 0;
  for (int row = 0; row < kLabelHeight; ++row) {
    for (int column = 0; column < kLabelWidth; ++column) {
      const Eigen::Vector2d at(column, row);
      const double toOther = (at - other.center).norm() - other.radius;
      const double toExcept = (at - except.center).norm() - except.radius;
      if (std::abs(toOther) < 1e-6 || std::abs(toExcept) < 1e-6) {
        continue; // on a rim: either
      }
      const bool matching = red_.contains({column, row});
      const bool isExplained = matching && toOther < 0.0 && toExcept > 0.0;
      EXPECT_EQ(labels_.at(column, row) == PixelLabel::Explained, isExplained)
          << column << ", " << row;
      EXPECT_EQ(labels_.at(column, row) == PixelLabel::Target, matching && !isExplained)
          << column << ", " << row;
      explained += isExplained ? 1 : 0;
      kept += matching && toOther < 0.0 && toExcept < 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(explained, 10);
  EXPECT_GT(kept, 10);
}

TEST_F(LabelImageTest, WithoutAnExceptionTheWholeCircleIsExplained) {
  labels_.ensureAllLabels();
  labels_.markExplained({{20.0, 16.0}, 100.0}, {});
  for (int row = 0; row < kLabelHeight; ++row) {
    for (int column = 0; column < kLabelWidth; ++column) {
      EXPECT_NE(labels_.at(column, row), PixelLabel::Target);
    }
  }
  EXPECT_EQ(labels_.at(45, 25), PixelLabel::Unknown); // blue was not the target's anyway
}

TEST_F(LabelImageTest, ANewImageForgetsExplanationsAndLabels) {
  labels_.markExplained({{20.0, 16.0}, 100.0}, {});
  labels_.ensureAllLabels();
  EXPECT_EQ(labels_.at(12, 10), PixelLabel::Explained);
  labels_.setImage(image_, background_, classifier_);
  EXPECT_TRUE(labels_.labeledArea().empty());
  labels_.ensureAllLabels();
  EXPECT_EQ(labels_.at(12, 10), PixelLabel::Target);
}

TEST_F(LabelImageTest, KnowsTheColorInOtherLight) {
  // In a fifth of the light the red (0, 0, 230) becomes (0, 0, 46): an intensity of 46 / 765 =
  // 0.06, below the range, which begins at 0.1. The wall is gray, 80 / 5 = 16.
  cv::Mat dark;
  cv::multiply(image_, cv::Scalar::all(0.2), dark);
  cv::Mat wall;
  cv::multiply(grayImage(), cv::Scalar::all(0.2), wall);
  labels_.setImage(dark, background_, classifier_);
  labels_.ensureAllLabels();
  EXPECT_EQ(labels_.at(12, 10), PixelLabel::Unknown);
  // Not at once: what is darker than a quarter could be a covered lens.
  for (const double gain : {0.45, 0.2}) {
    cv::Mat now;
    cv::multiply(image_, cv::Scalar::all(gain), now);
    background_.adaptToLight(now);
  }
  labels_.setImage(dark, background_, classifier_);
  labels_.ensureAllLabels();
  for (int row = 0; row < kLabelHeight; ++row) {
    for (int column = 0; column < kLabelWidth; ++column) {
      const cv::Point at(column, row);
      EXPECT_EQ(labels_.at(column, row), red_.contains(at)    ? PixelLabel::Target
                                         : blue_.contains(at) ? PixelLabel::Unknown
                                                              : PixelLabel::Background)
          << column << ", " << row;
    }
  }
}

TEST_F(LabelImageTest, ClearLeavesNoImage) {
  EXPECT_FALSE(labels_.empty());
  EXPECT_EQ(labels_.size(), cv::Size(kLabelWidth, kLabelHeight));
  labels_.ensureAllLabels();
  labels_.clear();
  EXPECT_TRUE(labels_.empty());
  labels_.ensureAllLabels();
  labels_.ensureLabels({0, 0, 10, 10});
  labels_.markExplained({{5.0, 5.0}, 10.0}, {});
  EXPECT_EQ(labels_.at(12, 10), PixelLabel::Explained);
}

TEST(LabelImage, HasNoImageAtFirst) {
  LabelImage labels;
  EXPECT_TRUE(labels.empty());
  labels.ensureAllLabels();
  EXPECT_EQ(labels.at(0, 0), PixelLabel::Explained);
}

} // namespace
} // namespace dewpoint::tests

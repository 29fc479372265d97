// SPDX-License-Identifier: GPL-3.0-or-later
// What a simulated camera does to light, step by step.
#include "core/simulation/sensor/optics.h"
#include "core/simulation/sensor/sensor_model.h"
#include "core/simulation/sensor/tone_curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::simulation;

const RandomStream kStream(7, 3, 1, RandomPurpose::Simulation);

double varianceOf(const cv::Mat& image) {
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(image, mean, deviation);
  return deviation[0] * deviation[0];
}

TEST(Optics, BlurKeepsAConstantAndSpreadsAPoint) {
  const cv::Mat constant(20, 30, CV_32FC3, cv::Scalar(0.1, 0.5, 0.9));
  EXPECT_LT(cv::norm(blurred(constant, 1.7), constant, cv::NORM_INF), 1e-5);
  cv::Mat point = cv::Mat::zeros(41, 41, CV_32FC1);
  point.at<float>(20, 20) = 1.0F;
  const cv::Mat spread = blurred(point, 1.5);
  double sum = 0.0;
  double squares = 0.0;
  for (int row = 0; row < 41; ++row) {
    for (int column = 0; column < 41; ++column) {
      sum += spread.at<float>(row, column);
      squares += spread.at<float>(row, column) * (column - 20.0) * (column - 20.0);
    }
  }
  EXPECT_NEAR(sum, 1.0, 1e-4);
  EXPECT_NEAR(squares, 1.5 * 1.5, 0.02) << "the variance of a Gaussian of 1.5 px";
  EXPECT_EQ(cv::norm(blurred(point, 0.0), point, cv::NORM_INF), 0.0);
}

TEST(ToneCurve, GoesThereAndBack) {
  // BT.709: 1.099 x 0.2^0.45 - 0.099 = 0.4335 with the exact constants.
  EXPECT_NEAR(encodedLevel(0.2), 0.4335, 2e-4);
  EXPECT_NEAR(encodedLevel(0.01), 0.045, 1e-12);
  EXPECT_NEAR(encodedLevel(1.0), 1.0, 1e-12);
  cv::Mat levels(1, 256, CV_32FC3);
  for (int level = 0; level < 256; ++level) {
    const auto value = static_cast<float>(level);
    levels.at<cv::Vec3f>(0, level) = {value, value, value};
    EXPECT_NEAR(encodedLevel(linearLevel(level / 255.0)), level / 255.0, 1e-9);
  }
  const cv::Mat again = applyToneCurve(linearImage(levels), Eigen::Vector3d::Ones(), 1.0);
  EXPECT_LT(cv::norm(again, levels, cv::NORM_INF), 0.02);
}

TEST(ToneCurve, WhiteBalanceComesBeforeTheCurve) {
  const cv::Mat gray(2, 2, CV_32FC3, cv::Scalar(0.2, 0.2, 0.2));
  const cv::Vec3f pixel = applyToneCurve(gray, {2.0, 1.0, 8.0}, 1.0).at<cv::Vec3f>(1, 1);
  EXPECT_NEAR(pixel[0], 255.0 * encodedLevel(0.4), 0.02) << "not twice the level";
  EXPECT_NEAR(pixel[1], 255.0 * encodedLevel(0.2), 0.02);
  EXPECT_NEAR(pixel[2], 255.0, 1e-3) << "cut at full scale";
  const cv::Vec3f harder = applyToneCurve(gray, Eigen::Vector3d::Ones(), 2.0).at<cv::Vec3f>(0, 0);
  EXPECT_NEAR(harder[1], 255.0 * encodedLevel(0.2) * encodedLevel(0.2), 0.02);
}

TEST(Bayer, AConstantColorStaysItself) {
  const cv::Mat color(24, 32, CV_32FC3, cv::Scalar(0.2, 0.5, 0.8));
  // Digits of 12 bits, then divided by 0.6: an error of at most 0.5 / 4095 / 0.6 = 2e-4.
  EXPECT_LT(cv::norm(demosaiced(bayerMosaic(color)), color, cv::NORM_INF), 3e-4);
}

TEST(Bayer, NoiseIsThatOfCountedElectrons) {
  const auto varianceAt = [](double light, const PixelNoise& noise, double gain) {
    cv::Mat raw(240, 320, CV_32FC1, cv::Scalar(light));
    addPixelNoise(raw, noise, gain, kStream);
    return varianceOf(raw);
  };
  // Light 0.5 of 1000 electrons: variance 500 / 1000^2. 76800 values: known to 0.5 %.
  const PixelNoise shot{1000.0, 0.0};
  EXPECT_NEAR(varianceAt(0.5, shot, 1.0), 5e-4, 1.5e-5);
  EXPECT_NEAR(varianceAt(0.1, shot, 1.0), 1e-4, 3e-6) << "proportional to the signal";
  EXPECT_NEAR(varianceAt(0.5, shot, 2.0), 1e-3, 3e-5) << "half as many electrons";
  EXPECT_NEAR(varianceAt(0.0, {1000.0, 5.0}, 1.0), 25e-6, 1e-6) << "read noise alone";
  EXPECT_EQ(varianceAt(0.0, shot, 1.0), 0.0);
}

TEST(Sharpening, OvershootsAtAnEdgeOnly) {
  cv::Mat edge(20, 40, CV_8UC3, cv::Scalar::all(80));
  edge.colRange(20, 40).setTo(cv::Scalar::all(160));
  const cv::Mat result = sharpened(edge, {0.8, 1.0});
  EXPECT_EQ(result.at<cv::Vec3b>(10, 3), cv::Vec3b(80, 80, 80));
  EXPECT_EQ(result.at<cv::Vec3b>(10, 36), cv::Vec3b(160, 160, 160));
  EXPECT_LT(result.at<cv::Vec3b>(10, 19)[0], 75);
  EXPECT_GT(result.at<cv::Vec3b>(10, 20)[0], 165);
}

TEST(Jpeg, HalvesTheResolutionOfColors) {
  // Two colors of equal luma (0.299 R + 0.587 G + 0.114 B = 137) in columns of one pixel.
  cv::Mat stripes(32, 32, CV_8UC3);
  for (int column = 0; column < 32; ++column) {
    stripes.col(column).setTo(column % 2 == 0 ? cv::Scalar(60, 120, 200)
                                              : cv::Scalar(200, 120, 147));
  }
  const cv::Mat image = jpegCompressed(stripes, 95);
  const int left = image.at<cv::Vec3b>(16, 14)[0];
  const int right = image.at<cv::Vec3b>(16, 15)[0];
  EXPECT_LT(std::abs(left - right), 25) << "4:4:4 would keep the difference of 140";
}

TEST(SensorModel, TheIdealOneOnlyAddsNoise) {
  const cv::Mat light(30, 40, CV_32FC3, cv::Scalar(60.25, 120.0, 180.0));
  EXPECT_EQ(cv::norm(sensorImage(light, {}, 0.0, 3.0, kStream), digitize(light, 3.0, kStream),
                     cv::NORM_INF),
            0.0);
}

TEST(SensorModel, AConstantImageStaysConstant) {
  const cv::Scalar color(60.0, 120.0, 180.0);
  const cv::Mat light(48, 64, CV_32FC3, color);
  SensorModel model;
  model.psfSigmaPx = 1.3;
  model.noise = {1e9, 0.0}; // no noise to speak of
  model.sharpening = {1.0, 1.0};
  model.jpegQuality = 90;
  const cv::Mat image = sensorImage(light, model, 0.0, 3.0, kStream);
  // JPEG rounds colors to about one level.
  const cv::Scalar mean = cv::mean(image);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(mean[channel], color[channel], 2.0) << channel;
  }
  EXPECT_LT(varianceOf(image), 1.0);
}

TEST(SensorModel, ExposureActsOnLinearLight) {
  const cv::Mat light(8, 8, CV_32FC3, cv::Scalar::all(255.0 * encodedLevel(0.2)));
  SensorModel model;
  model.gainCurve.gainPerFrame = {{2.0, {1.0, 1.0, 0.5}}};
  const cv::Vec3b pixel = sensorImage(light, model, 0.0, 0.0, kStream).at<cv::Vec3b>(4, 4);
  EXPECT_NEAR(pixel[1], 255.0 * encodedLevel(0.4), 0.6);
  EXPECT_NEAR(pixel[2], 255.0 * encodedLevel(0.2), 0.6);
}

} // namespace
} // namespace dewpoint::tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sensor/tone_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace dewpoint::simulation {
namespace {

// ITU-R BT.709-6, item 1.2, with the constants of BT.2020 that make the two pieces meet.
constexpr double kSlope = 4.5;              ///< of the straight piece near black
constexpr double kKnee = 0.018053968510807; ///< linear light where it ends
constexpr double kPower = kToneCurveExponent;
constexpr double kScale = 1.09929682680944;

/// Entries of a table per gray level: between two the curve is straight to 0.01 levels.
constexpr float kPerLevel = 4.0F;
/// Intervals of the table of the tone curve: the straight piece is 75 of them.
constexpr int kToneIntervals = 4096;

/// Values of a function at 0, 1, 2, ... and between them.
class Table {
public:
  explicit Table(std::vector<float> values) : values_(std::move(values)) {}
  float at(float position) const {
    const float last = static_cast<float>(values_.size() - 1);
    const float inside = std::clamp(position, 0.0F, last);
    const auto index = std::min(static_cast<std::size_t>(inside), values_.size() - 2);
    const float share = inside - static_cast<float>(index);
    return values_[index] + share * (values_[index + 1] - values_[index]);
  }

private:
  std::vector<float> values_;
};

const Table& linearTable() {
  static const Table table = [] {
    const auto count = static_cast<std::size_t>(kPerLevel * kMaxLevel) + 1;
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double level = static_cast<double>(i) / static_cast<double>(kPerLevel);
      values[i] = static_cast<float>(linearLevel(level / 255.0));
    }
    return Table(std::move(values));
  }();
  return table;
}

Table toneTable(double contrast) {
  std::vector<float> values(kToneIntervals + 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double level = encodedLevel(static_cast<double>(i) / kToneIntervals);
    values[i] = static_cast<float>(255.0 * (contrast == 1.0 ? level : std::pow(level, contrast)));
  }
  return Table(std::move(values));
}

} // namespace

double encodedLevel(double linear) {
  return linear < kKnee ? kSlope * linear : kScale * std::pow(linear, kPower) - (kScale - 1.0);
}

double linearLevel(double encoded) {
  return encoded < kSlope * kKnee ? encoded / kSlope
                                  : std::pow((encoded + kScale - 1.0) / kScale, 1.0 / kPower);
}

cv::Mat linearImage(const cv::Mat& image) {
  CV_Assert(image.type() == CV_32FC3);
  const Table& table = linearTable();
  cv::Mat result(image.size(), CV_32FC3);
  for (int row = 0; row < image.rows; ++row) {
    const auto* in = image.ptr<float>(row);
    auto* out = result.ptr<float>(row);
    for (int i = 0; i < 3 * image.cols; ++i) {
      out[i] = table.at(kPerLevel * in[i]);
    }
  }
  return result;
}

cv::Mat applyToneCurve(const cv::Mat& linear, const Eigen::Vector3d& whiteBalance,
                       double contrast) {
  CV_Assert(linear.type() == CV_32FC3);
  static const Table plain = toneTable(1.0);
  const Table bent = contrast == 1.0 ? plain : toneTable(contrast);
  const Eigen::Vector3f scale = (kToneIntervals * whiteBalance).cast<float>();
  cv::Mat result(linear.size(), CV_32FC3);
  for (int row = 0; row < linear.rows; ++row) {
    const auto* in = linear.ptr<cv::Vec3f>(row);
    auto* out = result.ptr<cv::Vec3f>(row);
    for (int column = 0; column < linear.cols; ++column) {
      for (int channel = 0; channel < 3; ++channel) {
        out[column][channel] = bent.at(scale[channel] * in[column][channel]);
      }
    }
  }
  return result;
}

} // namespace dewpoint::simulation

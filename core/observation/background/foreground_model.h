// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <memory>

namespace dewpoint::observation {

/// Algorithm that finds the moving regions of an image.
enum class BackgroundMethod {
  Running, ///< one Gaussian per pixel: RunningBackground, fast
  Mog2,    ///< OpenCV's mixture of Gaussians (Zivkovic 2004)
  Knn,     ///< OpenCV's K nearest neighbors (Zivkovic & van der Heijden 2006)
};

/// Parameters of a foreground model.
struct ForegroundSettings {
  BackgroundMethod method = BackgroundMethod::Running;
  /// Number of frames at the start that are only learned from.
  int learningFrames = 15;
  /// Number of frames after which a new object that stays is halfway to becoming background.
  double memoryFrames = 600.0;
  /// Lowest brightness, as a share of the usual brightness, at which a pixel still counts as a
  /// shadow.
  double darkestShadow = 0.5;
};

/// Finds the pixels of one camera that differ from its background: the binary motion mask M of
/// Mohedano et al. 2009, equation 5.
class ForegroundModel {
public:
  virtual ~ForegroundModel() = default;
  /// Learns from an image (CV_8UC3) of the scene without people. All images must have the same
  /// size.
  virtual void learn(const cv::Mat& image) = 0;
  /// Computes the mask of an image (CV_8UC1: 255 where something has moved in, otherwise 0; shadows
  /// are 0). Then it learns slowly from the image, except where `keep` (CV_8UC1, or empty) is
  /// nonzero.
  virtual void subtract(const cv::Mat& image, const cv::Mat& keep, cv::Mat& mask) = 0;
  /// Returns a new model with the same settings that has learned nothing.
  virtual std::unique_ptr<ForegroundModel> fresh() const = 0;
  /// Returns a copy that continues from here with bit-identical results and shares no writable
  /// data. Returns null if the model cannot be copied, because OpenCV does not give access to its
  /// state.
  virtual std::unique_ptr<ForegroundModel> clone() const { return nullptr; }
  /// Whether clone() returns a copy.
  virtual bool canBeCopied() const { return false; }
  /// Approximate size of a copy, bytes.
  virtual std::size_t memoryBytes() const { return 0; }
};

/// Makes the model that `settings` names.
std::unique_ptr<ForegroundModel> makeForegroundModel(const ForegroundSettings& settings);

} // namespace dewpoint::observation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <memory>

namespace dewpoint::observation {

/// Algorithm that finds the moving regions of an image.
enum class BackgroundMethod {
  Running, ///< one Gaussian per pixel (RunningBackground); fast
  Mog2,    ///< OpenCV's mixture of Gaussians (Zivkovic 2004)
  Knn,     ///< OpenCV's K nearest neighbors (Zivkovic & van der Heijden 2006)
};

/// Parameters of a foreground model.
struct ForegroundSettings {
  BackgroundMethod method = BackgroundMethod::Running;
  /// Number of frames at the start that are used only for learning.
  int learningFrameCount = 15;
  /// Number of frames after which the background color behind a new, motionless object has changed
  /// halfway to the color of the object.
  double memoryFrameCount = 600.0;
  /// Lowest brightness, as a fraction of the usual brightness, at which a pixel still counts as a
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
  /// Computes the motion mask of an image (CV_8UC3). `mask` becomes CV_8UC1: 255 where an object
  /// differs from the background, and 0 elsewhere. Shadows count as background. The model then
  /// adapts slowly to the image, except where `keep` (CV_8UC1, or empty) is nonzero.
  virtual void subtract(const cv::Mat& image, const cv::Mat& keep, cv::Mat& mask) = 0;
  /// Returns a new, untrained model with the same settings.
  virtual std::unique_ptr<ForegroundModel> makeUntrained() const = 0;
};

/// Foreground model that can be copied together with what it has learned. The models of OpenCV
/// cannot, because OpenCV does not give access to their state. copyableForeground() asks for this
/// interface.
class CopyableForeground {
public:
  virtual ~CopyableForeground() = default;
  /// Returns a copy that gives the same results as this model for the same further images, bit for
  /// bit. The copy shares no writable data with this model.
  virtual std::unique_ptr<ForegroundModel> clone() const = 0;
  /// Returns the approximate size of a copy, bytes.
  virtual std::size_t memoryBytes() const = 0;
};

/// Returns the model as one that can be copied. Returns null if it cannot be copied, and for a null
/// pointer.
inline const CopyableForeground* copyableForeground(const ForegroundModel* model) {
  return dynamic_cast<const CopyableForeground*>(model);
}

/// Creates the model selected by `settings`.
std::unique_ptr<ForegroundModel> makeForegroundModel(const ForegroundSettings& settings);

} // namespace dewpoint::observation

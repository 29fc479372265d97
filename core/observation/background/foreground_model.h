// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <memory>

namespace dewpoint::observation {

/// How the moving regions of an image are found.
enum class BackgroundMethod {
  Running, ///< one Gaussian per pixel: RunningBackground, fast
  Mog2,    ///< OpenCV's mixture of Gaussians (Zivkovic 2004)
  Knn,     ///< OpenCV's K nearest neighbors (Zivkovic & van der Heijden 2006)
};

struct ForegroundSettings {
  BackgroundMethod method = BackgroundMethod::Running;
  /// Frames that are only learned from, at first.
  int learningFrames = 15;
  /// Frames after which something new that stays is half way to being background.
  double memoryFrames = 600.0;
  /// Of its least brightness (share of what is usual) a pixel still counts as a shadow.
  double darkestShadow = 0.5;
};

/// What one camera shows that is not its background: the binary motion mask M of Mohedano et al.
/// 2009, equation 5.
class ForegroundModel {
public:
  virtual ~ForegroundModel() = default;
  /// Learns an image (CV_8UC3) of the scene without people; the same size every time.
  virtual void learn(const cv::Mat& image) = 0;
  /// The mask of an image (CV_8UC1: 255 where something moved in, else 0; shadows are 0), and
  /// learns slowly from it: not where `keep` (CV_8UC1, or empty) is nonzero.
  virtual void subtract(const cv::Mat& image, const cv::Mat& keep, cv::Mat& mask) = 0;
  virtual std::unique_ptr<ForegroundModel> fresh() const = 0;
  /// A copy that goes on from here with the same bits, and shares nothing that either writes; null
  /// when the model cannot be copied (OpenCV keeps its own to itself).
  virtual std::unique_ptr<ForegroundModel> clone() const { return nullptr; }
  virtual bool canBeCopied() const { return false; }
  /// About how many bytes a copy takes.
  virtual std::size_t memoryBytes() const { return 0; }
};

std::unique_ptr<ForegroundModel> makeForegroundModel(const ForegroundSettings& settings);

} // namespace dewpoint::observation

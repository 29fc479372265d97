// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"

#include <QImage>
#include <QSize>

#include <memory>
#include <optional>

namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;
class BirdsEyeView;

/// Bird's-eye view for an exported video, separate from the bird's-eye view of the window, which
/// may show another frame meanwhile. It is drawn in the GUI thread. On a slow computer, a smaller
/// image is drawn, so that drawing takes at most about kMaxDrawingMs milliseconds.
class VideoScene {
public:
  static constexpr double kMaxDrawingMs = 40.0;

  VideoScene();
  ~VideoScene();

  /// Copies the layers and the point of view of the bird's-eye view `shown`, for images of this
  /// size (pixels). `volume` is the volume of interest to draw, if there is one.
  void copyAppearance(const BirdsEyeView& shown, const std::optional<WorldBox>& volume,
                      const QSize& size);
  /// Returns the image of a frame; null without OpenGL.
  QImage draw(const TrackSnapshotPtr& snapshot);
  /// Returns the size in which images are drawn, which may be smaller than requested.
  const QSize& drawnSize() const { return drawn_; }
  bool isSizeReduced() const { return drawn_ != wanted_; }
  /// Returns how long drawing the last image took, in milliseconds.
  double lastDrawingMs() const { return lastMs_; }

private:
  QImage render(const QSize& size);
  void measure();

  std::unique_ptr<BirdsEyeView> view_;
  QSize wanted_;
  QSize drawn_;
  QSize measured_; ///< `wanted_` of the last measurement
  double lastMs_ = 0.0;
};

/// Returns the largest image size with the proportions of `wanted` that takes at most `maxMs`
/// milliseconds to draw, but at least a quarter of the width and height of `wanted`. The time is
/// estimated from two measurements: an image of `smallPixels` pixels took `smallMs`, and an image
/// of `largePixels` pixels took `largeMs`.
QSize largestSizeWithinTime(const QSize& wanted, double smallPixels, double smallMs,
                            double largePixels, double largeMs, double maxMs);

} // namespace dewpoint::ui

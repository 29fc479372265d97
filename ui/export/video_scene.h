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

/// Bird's-eye view of an exported video, drawn apart from that of the window, which may show
/// another frame meanwhile. Like all OpenGL of the window, it is drawn in the GUI thread. So that
/// this never takes longer than kMaxMs, a slow computer draws a smaller image.
class VideoScene {
public:
  static constexpr double kMaxMs = 40.0;

  VideoScene();
  ~VideoScene();

  /// Takes over the layers and the point of view of a view, for images of this size (pixels).
  void copyLook(const BirdsEyeView& shown, const std::optional<WorldBox>& volume,
                const QSize& size);
  /// Draws a frame; null without OpenGL. The first image of each size is also measured.
  QImage draw(const TrackSnapshotPtr& snapshot);
  /// Returns the size in which images are drawn, as far as it is known.
  const QSize& drawnSize() const { return drawn_; }
  bool isReduced() const { return drawn_ != wanted_; }
  /// Returns how long the last image took, milliseconds.
  double lastMs() const { return lastMs_; }

private:
  QImage render(const QSize& size);
  void measure();

  std::unique_ptr<BirdsEyeView> view_;
  QSize wanted_;
  QSize drawn_;
  QSize measured_; ///< `wanted_` of the last measurement
  double lastMs_ = 0.0;
};

/// Returns the largest size with the proportions of `wanted` that takes at most `maxMs` to draw, if
/// an image of `smallPixels` pixels took `smallMs` and one of `largePixels` `largeMs`. Not smaller
/// than a quarter of the width and height.
QSize affordableSize(const QSize& wanted, double smallPixels, double smallMs, double largePixels,
                     double largeMs, double maxMs);

} // namespace dewpoint::ui

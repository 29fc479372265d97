// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/overlay_painter.h"
#include "ui/style/theme.h"

#include <QImage>
#include <QWidget>
#include <opencv2/core/mat.hpp>

#include <memory>

namespace dewpoint::capture {
struct Frame;
} // namespace dewpoint::capture
namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

using FramePtr = std::shared_ptr<const Frame>;
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// What one camera sees, letterboxed, and what the filter believes, projected into it: particles,
/// estimate with 95 % ellipse, truth where known, the mask of the target color on demand.
class CameraView : public QWidget {
  Q_OBJECT
public:
  /// View of camera `camera` of the rig of the snapshots it is given.
  explicit CameraView(int camera, QWidget* parent = nullptr);

  /// What it shows; null: no images.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  void setMaskShown(bool shown);
  /// Likelihood maps and the places that were considered.
  void setEvidenceShown(bool shown);
  /// The selected person stands out; -1: none.
  void setChosenTarget(int target);
  HoldState state() const { return state_; }
  /// Where the image was drawn last, and its size in pixels; an empty size before there was one.
  const ImagePlacement& placement() const { return placement_; }
  const QSize& imageSize() const { return imageSize_; }

  QSize sizeHint() const override { return {400, 300}; }
  QSize minimumSizeHint() const override { return {120, 90}; }

Q_SIGNALS:
  /// The word in the title of this view changed.
  void stateChanged(HoldState state);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  HoldState stateNow() const;
  /// The image scaled to `devicePixels`, remade only when the frame, mask or size changed.
  const QImage& scaledImage(const QSize& devicePixels);

  int camera_;
  TrackSnapshotPtr snapshot_;
  bool maskShown_ = false;
  bool evidenceShown_ = false;
  int chosenTarget_ = -1;
  HoldState state_ = HoldState::NoImages;
  ImagePlacement placement_;
  QSize imageSize_;
  QImage scaled_;
  // Kept alive here: the address of a freed frame may come back as that of the next one.
  FramePtr scaledFrom_; ///< the frame in scaled_
  cv::Mat scaledMask_;  ///< the mask in scaled_
};

} // namespace dewpoint::ui

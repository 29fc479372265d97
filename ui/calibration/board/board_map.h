// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/board_guide.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

namespace dewpoint::ui {

/// Shows in which image regions of one camera, and at which tilts, the board has been captured.
/// Draws regions filled according to their number of corners, outlines of the captured views, the
/// board as currently seen, and the view to show next. A newly captured view is highlighted
/// briefly.
class BoardMap : public QWidget {
  Q_OBJECT
public:
  explicit BoardMap(QWidget* parent = nullptr);

  /// Shows the state of a camera. If `lens` is true, also draws the regions and tilts that are
  /// needed to calibrate the intrinsics.
  void setCamera(const BoardGuideState::PerCamera& camera, bool lens);

  QSize sizeHint() const override { return {148, 140}; }
  QSize minimumSizeHint() const override { return {112, 108}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  QRectF imageArea() const;
  void paintRegions(QPainter& painter, const QRectF& image) const;
  void paintOutlines(QPainter& painter, const QRectF& image) const;
  void paintTilts(QPainter& painter, const QRectF& image) const;

  BoardGuideState::PerCamera camera_;
  bool lens_ = true;
  QElapsedTimer sinceTaken_;
  QTimer dim_;
};

} // namespace dewpoint::ui

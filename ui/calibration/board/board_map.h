// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/board_guide.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

namespace dewpoint::ui {

/// Where in one camera's image, and at which tilts, the board was taken so far: regions filled by
/// how many corners they have, outlines of the views, the board as it is seen now, and what is
/// to be shown next. A view that is taken lights up briefly.
class BoardMap : public QWidget {
  Q_OBJECT
public:
  explicit BoardMap(QWidget* parent = nullptr);

  /// `lens`: regions and tilts count, besides the outlines.
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

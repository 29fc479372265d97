// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/wand_collector.h"

#include <QWidget>

namespace dewpoint::ui {

/// A small picture of a camera's image: how often something was seen in each of its regions.
class CoverageMap : public QWidget {
  Q_OBJECT
public:
  explicit CoverageMap(QWidget* parent = nullptr);

  /// `shape`: width over height of the image.
  void setCamera(const QString& camera, const CameraSightings& seen, double shape);
  QSize sizeHint() const override { return {112, 84}; }
  QSize minimumSizeHint() const override { return {72, 54}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  CameraSightings seen_;
  double shape_ = 4.0 / 3.0;
};

} // namespace dewpoint::ui

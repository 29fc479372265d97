// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

namespace dewpoint::ui {

/// What is drawn over the images, one thing in each small picture of the legend.
enum class LegendSign {
  Particles,
  Estimate, ///< the cross
  Belief,   ///< the unbroken ellipse
  Outline,  ///< the dashed ellipse
  Truth,    ///< the diamond
  Best,     ///< the triangle
  Ray,
  Mask
};

/// A small picture of one sign, drawn by the painters of the camera views.
class LegendPicture : public QWidget {
  Q_OBJECT
public:
  explicit LegendPicture(LegendSign sign, QWidget* parent = nullptr);

  /// What the sign means, one sentence in the user's language.
  static QString meaningOf(LegendSign sign);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  LegendSign sign_;
};

} // namespace dewpoint::ui

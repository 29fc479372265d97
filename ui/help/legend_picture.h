// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

namespace dewpoint::ui {

/// Signs that are drawn over the images and in the bird's-eye view. The legend shows a small image
/// of each.
enum class LegendSign {
  Particles,
  Estimate, ///< estimated position, drawn as a cross
  Belief,   ///< contains the target with 95 % probability; drawn as a solid ellipse
  Outline,  ///< size of a target that is not a ball; drawn as a dashed ellipse
  Truth,    ///< true position, drawn as a diamond
  Best,     ///< particle of highest weight, drawn as a triangle
  Ray,
  Mask,
  Inset, ///< enlarged particle cloud in a corner of a view
  Range  ///< selected part of a target's path
};

/// Small image of one sign, drawn by the painters of the camera views.
class LegendPicture : public QWidget {
  Q_OBJECT
public:
  explicit LegendPicture(LegendSign sign, QWidget* parent = nullptr);

  /// Returns the meaning of a sign as one translated sentence.
  static QString meaningOf(LegendSign sign);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  LegendSign sign_;
};

} // namespace dewpoint::ui

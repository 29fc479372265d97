// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QTimer>
#include <QWidget>

#include <array>

class QSpinBox;

namespace dewpoint::ui {

/// Fields for the margins that are cut off from the images of a camera, in pixels: left, top, right
/// and bottom.
class CropForm : public QWidget {
  Q_OBJECT
public:
  explicit CropForm(QWidget* parent = nullptr);

  /// Shows the margins of a camera whose images have this size before they are cropped. A change of
  /// the same camera that has not been reported yet stays.
  void show(int camera, const ImageMargins& margins, int width, int height);

Q_SIGNALS:
  /// Emitted when the user has changed margins: after a step, a little later.
  void changed(int camera, const dewpoint::geometry::ImageMargins& margins);

private:
  void report();
  ImageMargins entered() const;

  std::array<QSpinBox*, 4> fields_{}; ///< in the order of ImageMargins
  int camera_ = -1;
  ImageMargins shown_;
  QTimer settled_; ///< each report opens the cameras again
};

} // namespace dewpoint::ui

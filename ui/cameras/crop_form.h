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

  /// Shows the margins of a camera. `width` and `height` are the size of its images before
  /// cropping. The fields keep margins that the user has entered for this camera and that changed()
  /// has not reported yet.
  void setMargins(int camera, const ImageMargins& margins, int width, int height);

Q_SIGNALS:
  /// Emitted when the user has changed margins: immediately when the user leaves a field, otherwise
  /// half a second after the last change.
  void changed(int camera, const dewpoint::geometry::ImageMargins& margins);

private:
  void report();
  ImageMargins entered() const;

  std::array<QSpinBox*, 4> fields_{}; ///< left, top, right, bottom
  int camera_ = -1;
  ImageMargins shown_;
  QTimer settled_; ///< delays the report, because each report opens the cameras again
};

} // namespace dewpoint::ui

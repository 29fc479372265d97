// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"

#include <QString>
#include <QWidget>

#include <array>
#include <optional>
#include <string>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace dewpoint::ui {

class Document;

/// Fields for the volume of interest, a box given by two corners to which the search for targets is
/// limited. While the project has no volume of interest, the fields show the volume that the
/// cameras see, and editing a number starts from this volume. Every change is an undoable step of
/// the document. The texts keep the language in which the form was created.
class VolumeForm : public QWidget {
  Q_OBJECT
public:
  explicit VolumeForm(Document& document, QWidget* parent = nullptr);

private:
  void createWidgets();
  void connectFields();
  void refresh();
  /// Returns the project's box, or else the volume that its cameras see, or nothing if they see
  /// none.
  std::optional<WorldBox> shown() const;
  /// Sets a corner coordinate in meters. `corner`: 0 for the minimum, 1 for the maximum. `axis`: 0
  /// to 2.
  void setCoordinate(std::size_t corner, int axis, double meters);
  void set(const QString& step, const std::optional<WorldBox>& volume,
           const std::string& mergeKey = {});

  Document& document_;
  QLabel* state_;
  QPushButton* fromCameras_;
  QPushButton* none_;
  /// Fields for the minimum and maximum corners: x, y and z of each.
  std::array<std::array<QDoubleSpinBox*, 3>, 2> fields_{};
};

} // namespace dewpoint::ui

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

/// Fields of the volume of interest: the box in which targets are searched for, given by two
/// corners, or none. Without a box, the fields show the volume that the cameras see; editing a
/// number starts from it. Every change is a step of the document. The texts keep the language in
/// which the form was created.
class VolumeForm : public QWidget {
  Q_OBJECT
public:
  explicit VolumeForm(Document& document, QWidget* parent = nullptr);

private:
  void build();
  void connectFields();
  void refresh();
  /// Box of the project, else the volume that its cameras see; nothing if they see none.
  std::optional<WorldBox> shown() const;
  /// Sets a coordinate of a corner (`corner` 0: minimum, 1: maximum; `axis` 0 to 2), in meters.
  void setCoordinate(std::size_t corner, int axis, double meters);
  void set(const QString& step, const std::optional<WorldBox>& volume,
           const std::string& mergeKey = {});

  Document& document_;
  QLabel* state_;
  QPushButton* fromCameras_;
  QPushButton* none_;
  /// Fields of the corners minimum and maximum: x, y and z of each.
  std::array<std::array<QDoubleSpinBox*, 3>, 2> fields_{};
};

} // namespace dewpoint::ui

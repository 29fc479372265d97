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

/// The volume of interest: the box in which targets are searched for, by two of its corners, or
/// none. Without one the fields show what the cameras see, from which editing a number begins.
/// Every change is a step of the document; it speaks the language in which it was made.
class VolumeForm : public QWidget {
  Q_OBJECT
public:
  explicit VolumeForm(Document& document, QWidget* parent = nullptr);

private:
  void build();
  void connectFields();
  void refresh();
  /// The box of the project, or else what its cameras see; nothing when they see nothing.
  std::optional<WorldBox> shown() const;
  /// Sets a corner's coordinate (`corner` 0: min, 1: max).
  void setCoordinate(std::size_t corner, int axis, double meters);
  void set(const QString& step, const std::optional<WorldBox>& volume,
           const std::string& mergeKey = {});

  Document& document_;
  QLabel* state_;
  QPushButton* fromCameras_;
  QPushButton* none_;
  /// Of the corners min and max: x, y and z.
  std::array<std::array<QDoubleSpinBox*, 3>, 2> fields_{};
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QComboBox>

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

/// Selection of the method. Methods are grouped under headings by their use. Each has two lines
/// that describe what it tracks and how it differs, and shows its name in files and its paper.
/// Methods that do not work with the project are disabled and show why. The texts keep the language
/// in which the list was filled.
class MethodChoice : public QComboBox {
  Q_OBJECT
public:
  /// Data roles of an item. Qt::UserRole has the name used in files; a heading has none.
  enum Role { SentenceRole = Qt::UserRole + 1, PaperRole };

  explicit MethodChoice(QWidget* parent = nullptr);

  /// Lists all methods, enabled if they suit the project, and shows the method of the project.
  void showMethods(const Project& project);
};

} // namespace dewpoint::ui

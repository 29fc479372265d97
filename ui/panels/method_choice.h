// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QComboBox>

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

/// Combo box that selects the tracking method. Methods are grouped under headings by use. Two lines
/// describe what a method tracks and how it differs from others; its name in files and its paper
/// are also shown. Methods that do not work with the project are disabled and show the reason. The
/// texts keep the language in which the list was filled.
class MethodChoice : public QComboBox {
  Q_OBJECT
public:
  /// Data roles of an item. Qt::UserRole contains the name used in files; it is empty for a
  /// heading.
  enum Role { DescriptionRole = Qt::UserRole + 1, PaperRole };

  explicit MethodChoice(QWidget* parent = nullptr);

  /// Lists all methods, enables those that suit the project, and selects the project's method.
  void showMethods(const Project& project);
  /// Opens the list, wide enough for all texts.
  void showPopup() override;
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QComboBox>

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

/// The methods by their use, under headings: two lines each say what they follow and what sets them
/// apart, beside the name they have in files and the paper they are from. Those that cannot work
/// with the project are disabled and say why. It speaks the language in which it was filled.
class MethodChoice : public QComboBox {
  Q_OBJECT
public:
  /// Roles of an item. Qt::UserRole has the name in files; a heading has none.
  enum Role { SentenceRole = Qt::UserRole + 1, PaperRole };

  explicit MethodChoice(QWidget* parent = nullptr);

  /// Lists all methods, as they suit a project, and shows the project's own.
  void showMethods(const Project& project);
};

} // namespace dewpoint::ui

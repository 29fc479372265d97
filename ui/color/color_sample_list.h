// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

/// List of the samples from which a target's color was learned. Hidden while empty.
class ColorSampleList : public QWidget {
  Q_OBJECT
public:
  explicit ColorSampleList(QWidget* parent = nullptr);

  /// Lists the samples of a target in the project. The list is empty if there is no such target.
  void setSamples(const Project& project, int target);
  void retranslateUi();

Q_SIGNALS:
  void removeRequested(int sample);

private:
  void removeChosen();

  QLabel* title_;
  QListWidget* list_;
  QPushButton* remove_;
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace dewpoint::ui {

/// How an export went, where it was started: one sentence, and a button that shows the folder of
/// the file it wrote. Hidden while there is nothing to say.
class ExportOutcome : public QWidget {
  Q_OBJECT
public:
  explicit ExportOutcome(QWidget* parent = nullptr);

  /// `file`: what was written; empty: nothing.
  void show(const QString& sentence, const QString& file = {});
  void clear();
  void retranslate();

private:
  void openFolder();

  QLabel* sentence_;
  QPushButton* folder_;
  QString file_;
};

} // namespace dewpoint::ui

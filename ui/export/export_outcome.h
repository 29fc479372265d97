// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace dewpoint::ui {

/// Export result, shown in its dialog: one sentence, and a button that opens the folder of the
/// written file. Hidden while empty.
class ExportOutcome : public QWidget {
  Q_OBJECT
public:
  explicit ExportOutcome(QWidget* parent = nullptr);

  /// Shows a result. `file` is the file that was written, or empty if there is none.
  void showResult(const QString& sentence, const QString& file = {});
  void clear();
  void retranslateUi();

private:
  void openFolder();

  QLabel* sentence_;
  QPushButton* folder_;
  QString file_;
};

} // namespace dewpoint::ui

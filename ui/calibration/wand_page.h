// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;

namespace dewpoint {

class WandDesk;
class WandWaving;

/// The page of the calibration place for refining cameras with a waved ball or stick.
class WandPage : public QWidget {
  Q_OBJECT
public:
  explicit WandPage(WandDesk& desk, QWidget* parent = nullptr);

private:
  void say();

  WandDesk& desk_;
  QLabel* guide_;
  QLabel* momentsTitle_;
  QLabel* wavingTitle_;
  WandWaving* waving_;
  QLabel* outcomeTitle_;
};

} // namespace dewpoint

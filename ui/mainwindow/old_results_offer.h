// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

namespace dewpoint::ui {

/// Offers to track again those frames whose results are from earlier settings. Shows a message with
/// a button when the settings change, and provides an action that is enabled while such results
/// exist.
class OldResultsOffer : public QObject {
  Q_OBJECT
public:
  explicit OldResultsOffer(const Workbench& bench);

private:
  void offer(bool offers);

  Workbench bench_;
  QString shown_; ///< message currently shown
};

} // namespace dewpoint::ui

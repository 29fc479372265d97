// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

namespace dewpoint::ui {

/// Offers to track again what earlier settings gave: a message with one button when the settings
/// were changed, and an action for as long as there are such results.
class OldResultsOffer : public QObject {
  Q_OBJECT
public:
  explicit OldResultsOffer(const Workbench& bench);

private:
  void offer(bool offers);

  Workbench bench_;
  QString shown_; ///< the message, as it is shown
};

} // namespace dewpoint::ui

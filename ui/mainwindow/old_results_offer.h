// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

namespace dewpoint::ui {

/// Offers to track again the frames whose results are from earlier settings: a message with a
/// button when the settings change, and an action that is enabled while such results exist.
class OldResultsOffer : public QObject {
  Q_OBJECT
public:
  explicit OldResultsOffer(const Workbench& bench);

private:
  void offer(bool offers);

  Workbench bench_;
  QString shown_; ///< message, as shown
};

} // namespace dewpoint::ui

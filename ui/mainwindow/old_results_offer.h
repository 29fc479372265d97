// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

namespace dewpoint::ui {

/// Offers to track frames again whose results are from earlier settings. Shows a message with a
/// button when the settings change, and enables an action while such results exist. If tracking
/// began at a later frame because a target was learned there, the message offers to track from the
/// first frame. This offer stays until earlier frames are tracked or the user closes the message.
class OldResultsOffer : public QObject {
  Q_OBJECT
public:
  explicit OldResultsOffer(const Workbench& bench);

private:
  void offer(bool offers);
  void offerFirstFrame(qint64 started);
  void withdrawFirstFrame();
  /// Returns whether these records contain results for frames before the one at which tracking
  /// began.
  bool fills(const LoggedFrames& logged) const;

  Workbench bench_;
  QString shown_;      ///< message currently shown
  QString late_;       ///< message with the offer to track from the first frame; may be empty
  qint64 started_ = 0; ///< frame at which tracking began, while `late_` is not empty
};

} // namespace dewpoint::ui

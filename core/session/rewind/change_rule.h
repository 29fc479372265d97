// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/result_settings.h"

#include <cstdint>
#include <optional>

namespace dewpoint::session {

/// Rule that keeps the displayed results consistent with the current settings. If the settings
/// change while the run of a recording is paused, frames that were tracked with other settings are
/// tracked again immediately, provided that this is expected to be quick. Otherwise, their results
/// are marked as old, and the user can choose to track them again. While a run plays, changes apply
/// to new frames, and earlier results are marked.
class ChangeRule {
public:
  /// Longest expected duration, in seconds, for which frames are tracked again without asking the
  /// user.
  static constexpr double kQuickRerunSeconds = 2.0;

  /// State of the session when the rule is applied.
  struct SessionState {
    bool isLive = false; ///< the cameras are live; their earlier images cannot be tracked again
    /// The session plays: frames are being tracked or shown one after another.
    bool isPlaying = false;
    bool isRerunning = false;     ///< past frames are being tracked again
    bool settingsChanged = false; ///< settings have changed since the rule was last applied
    OldResults oldResults;
    double quickRerunLimitSeconds =
        kQuickRerunSeconds; ///< longest duration that counts as quick, seconds
  };
  enum class Action {
    Nothing,    ///< leave the results as they are
    Mark,       ///< mark old results without asking, because the run continues
    Offer,      ///< mark old results and offer to track again
    TrackAgain, ///< track again immediately, starting at `fromFrame`
  };
  struct Decision {
    Action action = Action::Nothing;
    std::int64_t fromFrame = 0; ///< first frame to track again; used by TrackAgain and Offer
    bool operator==(const Decision&) const = default;
  };

  /// Returns what to do about old results in this state of the session.
  static Decision decideOn(const SessionState& state);
  /// Returns the expected time, in seconds, to track again from the first old result to the newest
  /// frame; 0 if unknown.
  static double expectedSeconds(const OldResults& old);
};

} // namespace dewpoint::session

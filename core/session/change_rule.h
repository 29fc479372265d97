// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/result_settings.h"

#include <cstdint>
#include <optional>

namespace dewpoint::session {

/// The rule by which what is shown belongs to the settings shown: when the settings of a recording
/// are changed while its run waits, what was tracked with other settings is tracked again at once
/// if that is expected to be quick; else the results are marked as old, and tracking again is
/// offered. While a run plays, changes hold from there on, and what is before is marked.
class ChangeRule {
public:
  /// Tracking again that takes less is not worth a question, seconds.
  static constexpr double kQuick = 2.0;

  /// What goes on when the rule is applied.
  struct Situation {
    bool isLive = false;      ///< live cameras: what they showed is over
    bool isPlaying = false;   ///< new frames are tracked, or recorded ones shown, one after another
    bool isRerunning = false; ///< frames of the past are tracked again
    bool isEdited = false;    ///< settings were changed, and the rule was not applied since
    OldResults old;
    double quick = kQuick; ///< seconds
  };
  enum class Action {
    Nothing,    ///< all results are of the settings of now, or there is nothing to do about it
    Mark,       ///< they are marked; a run that goes on needs no question
    Offer,      ///< they are marked, and tracking again is offered
    TrackAgain, ///< at once, from `from` on
  };
  struct Decision {
    Action action = Action::Nothing;
    std::int64_t from = 0; ///< the first frame to be tracked again; of TrackAgain and Offer
    bool operator==(const Decision&) const = default;
  };

  static Decision decide(const Situation& situation);
  /// Seconds that it takes to track all again from the first old result on; 0 when unknown.
  static double expectedSeconds(const OldResults& old);
};

} // namespace dewpoint::session

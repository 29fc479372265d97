// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <cstdint>
#include <optional>
#include <variant>

namespace dewpoint::session {

/// State machine of a session. It determines which frame is shown, whether the session continues
/// without further commands, and which frame comes next. It has no thread, clock or image. The
/// *head* is the last frame that the run has taken. At the head, the run is Paused, Playing or
/// Ended. Viewing and Replaying show a frame other than the head. Rerunning tracks past frames
/// again, up to the former head; the last of these frames is the goal. Holding is a rerun on hold,
/// which can be resumed. The table gives the next state for each state (column) and event (row).
/// The event "return to head" is returnToNewestFrame(). The row "advance, head" applies if the next
/// frame is the head, the row "advance, none" if there is no next frame. A dash means no change:
///
/// |                | Paused  | Playing | Ended   | Viewing   | Replaying | Rerunning | Holding   |
/// | -------------- | ------- | ------- | ------- | --------- | --------- | --------- | --------- |
/// | play           | Playing | -       | -       | Replaying | -         | -         | Rerunning |
/// | pause          | -       | Paused  | -       | -         | Viewing   | Paused    | Paused    |
/// | hold           | -       | Paused  | -       | -         | Viewing   | Holding   | -         |
/// | show a frame   | Viewing | Viewing | Viewing | Viewing   | Viewing   | Viewing   | Viewing   |
/// | show the head  | -       | Paused  | -       | Paused*   | Paused*   | Paused    | Paused    |
/// | return to head | -       | -       | -       | Paused*   | Playing*  | -         | -         |
/// | advance        | -       | -       | -       | -         | -         | -         | -         |
/// | advance, head  | -       | -       | -       | Paused*   | Playing*  | -         | -         |
/// | advance, none  | -       | -       | -       | -         | Viewing   | -         | -         |
/// | restart        | -       | -       | Paused  | Paused    | Playing   | Playing   | Paused    |
/// | reach the goal | -       | -       | -       | -         | -         | before**  | before**  |
///
/// In every state, rerun() leads to Rerunning, continueTrackingAt() to Playing, and endInput() to
/// Ended. *: Ended if the input had ended before a frame other than the head was shown. **: Ended
/// if the input had ended before the rerun; Playing if the run was Playing; otherwise Paused. If a
/// rerun begins during another one, both end together, at the later of the two goals. The next
/// state is then the one that would have followed the first rerun.
class Playback {
public:
  struct Paused {};
  struct Playing {};
  struct Ended {};
  struct Viewing {
    std::int64_t frame = 0;
    bool hadInputEnded = false; ///< the input had ended before this frame was shown
  };
  struct Replaying {
    std::int64_t frame = 0;
    bool hadInputEnded = false;
  };
  struct Rerunning {
    RerunState range;
    PlayState stateAfterwards = PlayState::Paused;
    std::optional<std::int64_t> frameShownAfterwards; ///< frame to show after the rerun
  };
  struct Holding {
    Rerunning rerun;
  };
  using State = std::variant<Paused, Playing, Ended, Viewing, Replaying, Rerunning, Holding>;

  const State& state() const { return state_; }
  /// Returns the state in the form that snapshots contain.
  PlayState playState() const;
  /// Returns the frame that is shown instead of the head (the current frame of the run); nothing if
  /// the head is shown.
  std::optional<std::int64_t> viewedFrame() const;
  /// Returns the range of past frames that are being tracked again (rerun), including a rerun on
  /// hold; nothing if there is none.
  std::optional<RerunState> rerunRange() const;
  /// Returns whether the session is playing, replaying or rerunning.
  bool isRunning() const { return playState() == PlayState::Playing; }
  /// Returns whether the end of the input was reached.
  bool hasInputEnded() const;

  /// Starts playing if the head (the current frame of the run) is shown, and replaying if another
  /// frame is shown. Resumes a rerun that is on hold.
  void play();
  /// Pauses. The remaining frames of a rerun (past frames that are being tracked again) are not
  /// tracked.
  void pause();
  /// Pauses, but a rerun (past frames that are being tracked again) can be resumed.
  void hold();
  /// Shows a frame and stops playing. If `frame` is empty or equal to `head`, shows the head (the
  /// current frame of the run).
  void show(std::optional<std::int64_t> frame, std::int64_t head);
  /// Shows the head (the current frame of the run) instead of a past frame.
  void returnToNewestFrame();
  /// Shows the frame `next` while replaying. Replaying ends if `next` is `head` (the current frame
  /// of the run), or if `next` is empty because there is no further frame.
  void advance(std::optional<std::int64_t> next, std::int64_t head);
  /// Starts tracking the frames in `range` again (a rerun). If another rerun is in progress, the
  /// new one continues to the later of the two last frames. `frameShownAfterwards` is the frame to
  /// show after the rerun; if empty, the head (the current frame of the run) is shown.
  void rerun(const RerunState& range, std::optional<std::int64_t> frameShownAfterwards);
  /// Continues tracking at a frame that was not tracked before.
  void continueTrackingAt(std::int64_t frame);
  /// Notes that the input has ended.
  void endInput();
  /// Returns to the first frame. There is no head (current frame) until the first frame is taken.
  void restart();

  /// Progress of tracking the head (the current frame of the run).
  enum class HeadProgress {
    None,    ///< no frame yet
    Taken,   ///< the head is shown, but no iteration was made on it
    Tracked, ///< iterations were made on the head
    Recorded ///< the estimates of the head are in the log
  };
  HeadProgress headProgress() const { return headProgress_; }
  /// Returns the number of the next frame to take from the input.
  std::int64_t nextFrame() const { return nextFrame_; }
  /// Makes this frame the head (the current frame of the run).
  void setHead(std::int64_t frame);
  /// Notes that an iteration was made on the head (the current frame of the run).
  void noteIteration();
  /// Notes that the estimates of the head (the current frame of the run) are in the log.
  void noteRecorded() { headProgress_ = HeadProgress::Recorded; }
  /// Notes that the run has reached frame `head`. If this is the last frame of a rerun, ends the
  /// rerun and returns the frame to show afterward. Returns nothing if frame `head` stays shown.
  std::optional<std::int64_t> noteFrameReached(std::int64_t head);
  /// Notes that the head (the current frame of the run) is being tracked again from scratch.
  void forgetEstimates();

  /// Content that the last snapshot still lacks.
  enum class MissingContent {
    Nothing,
    Images, ///< images at full size, because a preview was shown
    Maps    ///< likelihood maps or motion masks of a past frame
  };
  MissingContent missingContent() const { return missingContent_; }
  /// Notes what a published snapshot lacks: full images if it is a preview, and maps or masks if
  /// `lacksMaps` is true.
  void notePublished(bool isPreview, bool lacksMaps);
  /// Notes that the content missing from the last snapshot was published.
  void noteMissingContentPublished() { missingContent_ = MissingContent::Nothing; }

private:
  /// Returns the current rerun, including one that is on hold; null if there is none.
  const Rerunning* currentRerun() const;
  void leaveHead(std::int64_t nextFrame);

  State state_;
  HeadProgress headProgress_ = HeadProgress::None;
  std::int64_t nextFrame_ = 0;
  MissingContent missingContent_ = MissingContent::Nothing;
};

} // namespace dewpoint::session

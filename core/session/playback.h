// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <cstdint>
#include <optional>
#include <variant>

namespace dewpoint::session {

/// Which frame is shown, what goes on by itself, and what comes next: the state machine of a
/// session, without a thread, a clock or an image. The *head* is the last frame that the run has
/// taken. At the head the run is Paused, Playing or Ended; Viewing and Replaying show another frame
/// than the head's; Rerunning tracks frames of the past again, up to where the head had been, and
/// Holding is a rerun that waits. Of every state (column) what an event (row) makes of it; a dash
/// stands for itself:
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
/// rerun() leads from everywhere to Rerunning, trackOnFrom() to Playing, endInput() to Ended.
/// *: Ended, if the input had ended before another frame than the head's was shown.
/// **: Ended, if the input had ended before the rerun; Playing, if the run was Playing; else
/// Paused. A rerun that begins during another one takes over its goal, if that is farther, and what
/// follows.
class Playback {
public:
  struct Paused {};
  struct Playing {};
  struct Ended {};
  struct Viewing {
    std::int64_t frame = 0;
    bool inputEnded = false; ///< before this frame was shown
  };
  struct Replaying {
    std::int64_t frame = 0;
    bool inputEnded = false;
  };
  struct Rerunning {
    RerunState range;
    PlayState afterwards = PlayState::Paused;
    std::optional<std::int64_t> thenView; ///< a frame to show when it is done
  };
  struct Holding {
    Rerunning rerun;
  };
  using State = std::variant<Paused, Playing, Ended, Viewing, Replaying, Rerunning, Holding>;

  const State& state() const { return state_; }
  /// As a snapshot says it.
  PlayState playState() const;
  /// The frame that is shown in place of the head's.
  std::optional<std::int64_t> viewed() const;
  /// Of the rerun under way, also of one that waits.
  std::optional<RerunState> rerunning() const;
  /// Something goes on by itself.
  bool goesOn() const { return playState() == PlayState::Playing; }
  bool hasInputEnded() const;

  void play();
  void pause(); ///< gives up what is left of a rerun
  void hold();  ///< as pause(), but a rerun can go on
  /// Shows this frame, or the head when there is none or it is the head's; what went on is over.
  void show(std::optional<std::int64_t> frame, std::int64_t head);
  void returnToHead();
  /// The frame after the one shown; nothing: there is none.
  void advance(std::optional<std::int64_t> next, std::int64_t head);
  /// Frames `range` are tracked again, and those up to the goal of a rerun under way.
  void rerun(const RerunState& range, std::optional<std::int64_t> thenView);
  /// Tracking begins at a frame that was not tracked yet.
  void trackOnFrom(std::int64_t frame);
  void endInput();
  void restart();

  /// What has become of the head's frame.
  enum class Head {
    None,    ///< there is none yet
    Taken,   ///< it is shown, but no iteration was made on it
    Tracked, ///< iterations were made
    Recorded ///< its estimates are in the log
  };
  Head head() const { return head_; }
  /// The next frame to take.
  std::int64_t nextFrame() const { return nextFrame_; }
  void take(std::int64_t frame);
  void track();
  void record() { head_ = Head::Recorded; }
  /// The head is there: a rerun that has reached its goal is over. Returns the frame that is to be
  /// shown then, if there is one.
  std::optional<std::int64_t> reach(std::int64_t head);
  /// New beliefs on the same frame.
  void forgetEstimates();

  /// What the last snapshot still lacks.
  enum class Missing {
    Nothing,
    Images, ///< a preview was shown
    Maps    ///< likelihood maps or motion masks of a frame of the past
  };
  Missing missing() const { return missing_; }
  void published(bool isPreview, bool lacksMaps);
  void complete() { missing_ = Missing::Nothing; }

private:
  /// Also one that waits; null: there is none.
  const Rerunning* rerunUnderWay() const;
  void leaveHead(std::int64_t nextFrame);

  State state_;
  Head head_ = Head::None;
  std::int64_t nextFrame_ = 0;
  Missing missing_ = Missing::Nothing;
};

} // namespace dewpoint::session

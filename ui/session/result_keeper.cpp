// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/result_keeper.h"

#include "core/session/session.h"

#include <QTimer>

#include <utility>

namespace dewpoint::ui {

namespace {
constexpr int kQuietMs = 300;    ///< settings have come to rest
constexpr int kTimeoutMs = 5000; ///< until a rerun that was requested has begun
} // namespace

ResultKeeper::ResultKeeper(QObject* parent)
    : QObject(parent), quiet_(new QTimer(this)), timeout_(new QTimer(this)) {
  quiet_->setSingleShot(true);
  quiet_->setInterval(kQuietMs);
  connect(quiet_, &QTimer::timeout, this, &ResultKeeper::apply);
  timeout_->setSingleShot(true);
  timeout_->setInterval(kTimeoutMs);
  connect(timeout_, &QTimer::timeout, this, &ResultKeeper::giveUp);
}

void ResultKeeper::giveUp() {
  if (renewing_ == Renewing::Requested) { // its images cannot be read: a notice says so
    renewing_ = Renewing::No;
    apply();
    Q_EMIT renewed();
  }
}

void ResultKeeper::watch(Session* session) {
  session_ = session;
  leaveAlone();
  isLive_ = true; // until a snapshot tells
  isPlaying_ = false;
  isRerunning_ = false;
  setOffered(false);
  setOld({});
}

void ResultKeeper::edited() {
  const bool goesOn = isPlaying_ && !isRerunning_; // then it holds from there on
  if (session_ != nullptr && !isLive_ && !goesOn) {
    isEdited_ = true;
    quiet_->start();
  }
}

void ResultKeeper::leaveAlone() {
  isEdited_ = false;
  renewing_ = Renewing::No;
  quiet_->stop();
}

void ResultKeeper::see(const TrackSnapshot& snapshot, bool wentBack) {
  isLive_ = !snapshot.frameCount.has_value();
  isPlaying_ = snapshot.state == PlayState::Playing;
  isRerunning_ = snapshot.rerun.has_value();
  if (renewing_ == Renewing::Requested && wentBack) {
    renewing_ = Renewing::UnderWay;
  }
  const bool isRenewed = renewing_ == Renewing::UnderWay && !isRerunning_;
  if (isRenewed) {
    renewing_ = Renewing::No;
  }
  setOld(isLive_ ? OldResults() : session_->oldResults());
  apply();
  if (isRenewed) {
    Q_EMIT renewed();
  }
}

void ResultKeeper::apply() {
  if (session_ == nullptr || quiet_->isActive() || (renewing_ != Renewing::No && !isEdited_)) {
    return;
  }
  const auto [action, from] =
      ChangeRule::decide({isLive_, isPlaying_, isRerunning_, isEdited_, old_, quickSeconds_});
  switch (action) {
  case ChangeRule::Action::Nothing:
  case ChangeRule::Action::Mark:
    setOffered(false);
    break;
  case ChangeRule::Action::Offer:
    setOffered(offers_ && !isEdited_); // after another change it is offered again
    setOffered(true);
    isEdited_ = false;
    break;
  case ChangeRule::Action::TrackAgain:
    trackAgain();
    break;
  }
}

void ResultKeeper::trackAgain() {
  if (session_ == nullptr || old_.frames.empty()) {
    return;
  }
  leaveAlone();
  setOffered(false);
  renewing_ = Renewing::Requested;
  timeout_->start();
  session_->renewFrom(old_.frames.front().first);
}

void ResultKeeper::setOld(OldResults old) {
  const bool same = old.frames == old_.frames;
  old_ = std::move(old);
  if (!same) {
    Q_EMIT oldResultsChanged();
  }
}

void ResultKeeper::setOffered(bool offers) {
  if (std::exchange(offers_, offers) != offers) {
    Q_EMIT offered(offers);
  }
}

} // namespace dewpoint::ui

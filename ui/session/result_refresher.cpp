// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/result_refresher.h"

#include "core/session/session.h"

#include <QTimer>

#include <utility>

namespace dewpoint::ui {

namespace {
constexpr int kQuietMs = 300;    ///< settings have come to rest
constexpr int kTimeoutMs = 5000; ///< until a rerun that was requested has begun
} // namespace

ResultRefresher::ResultRefresher(QObject* parent)
    : QObject(parent), quiet_(new QTimer(this)), timeout_(new QTimer(this)) {
  quiet_->setSingleShot(true);
  quiet_->setInterval(kQuietMs);
  connect(quiet_, &QTimer::timeout, this, &ResultRefresher::apply);
  timeout_->setSingleShot(true);
  timeout_->setInterval(kTimeoutMs);
  connect(timeout_, &QTimer::timeout, this, &ResultRefresher::giveUp);
}

void ResultRefresher::giveUp() {
  if (refreshing_ == Refreshing::Requested) { // its images cannot be read: a notice says so
    refreshing_ = Refreshing::No;
    apply();
    Q_EMIT refreshed();
  }
}

void ResultRefresher::watchSession(Session* session) {
  session_ = session;
  suspend();
  isLive_ = true; // until a snapshot tells
  isPlaying_ = false;
  isRerunning_ = false;
  setOffered(false);
  setOld({});
}

void ResultRefresher::onSettingEdited() {
  const bool goesOn = isPlaying_ && !isRerunning_; // then it holds from there on
  if (session_ != nullptr && !isLive_ && !goesOn) {
    isEdited_ = true;
    quiet_->start();
  }
}

void ResultRefresher::suspend() {
  isEdited_ = false;
  refreshing_ = Refreshing::No;
  quiet_->stop();
}

void ResultRefresher::processSnapshot(const TrackSnapshot& snapshot, bool wentBack) {
  isLive_ = !snapshot.frameCount.has_value();
  isPlaying_ = snapshot.state == PlayState::Playing;
  isRerunning_ = snapshot.rerun.has_value();
  if (refreshing_ == Refreshing::Requested && wentBack) {
    refreshing_ = Refreshing::UnderWay;
  }
  const bool isRenewed = refreshing_ == Refreshing::UnderWay && !isRerunning_;
  if (isRenewed) {
    refreshing_ = Refreshing::No;
  }
  setOld(isLive_ ? OldResults() : session_->oldResults());
  apply();
  if (isRenewed) {
    Q_EMIT refreshed();
  }
}

void ResultRefresher::apply() {
  if (session_ == nullptr || quiet_->isActive() || (refreshing_ != Refreshing::No && !isEdited_)) {
    return;
  }
  const auto [action, from] =
      ChangeRule::decideOn({isLive_, isPlaying_, isRerunning_, isEdited_, old_, quickSeconds_});
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

void ResultRefresher::trackAgain() {
  if (session_ == nullptr || old_.frameRanges.empty()) {
    return;
  }
  suspend();
  setOffered(false);
  refreshing_ = Refreshing::Requested;
  timeout_->start();
  session_->rerunKeepingView(old_.frameRanges.front().firstFrame);
}

void ResultRefresher::setOld(OldResults old) {
  const bool same = old.frameRanges == old_.frameRanges;
  old_ = std::move(old);
  if (!same) {
    Q_EMIT oldResultsChanged();
  }
}

void ResultRefresher::setOffered(bool offers) {
  if (std::exchange(offers_, offers) != offers) {
    Q_EMIT retrackOfferChanged(offers);
  }
}

} // namespace dewpoint::ui

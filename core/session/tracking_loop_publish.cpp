// SPDX-License-Identifier: GPL-3.0-or-later
// What the tracking thread shows of itself.
#include "core/base/statistics.h"
#include "core/color/match_image.h"
#include "core/session/tracking_loop.h"
#include "core/tracking/people/people_targets.h"

#include <algorithm>
#include <iterator>

namespace dewpoint::session {
namespace {

constexpr int kParticlesShown = 10000;
constexpr std::chrono::milliseconds kBetweenSnapshots(30);

constexpr std::size_t kMostInMask = 255; ///< targets that one byte tells apart

} // namespace

std::vector<cv::Mat> TrackingLoop::masks(const TrackSnapshot& snapshot) {
  std::vector<cv::Mat> masks;
  const auto& frames = snapshot.frames->frames;
  for (std::size_t camera = 0; camera < frames.size(); ++camera) {
    const FramePtr& frame = frames[camera];
    cv::Mat mask;
    for (std::size_t k = 0; k < std::min(snapshot.targets.size(), kMostInMask); ++k) {
      const auto& target = snapshot.targets[k];
      const auto& followed = target.estimate.colors; // empty: the range is as it was learned
      const ColorRange& range = camera < followed.size() ? followed[camera] : target.target.color;
      if (frame) {
        const cv::Mat matched = matchImage(frame->image, ColorClassifier(range));
        if (mask.empty()) {
          mask = matched;
        } else { // what matches several targets is the first one's
          mask.setTo(255 - static_cast<int>(k), matched & (mask == 0));
        }
      }
    }
    masks.push_back(mask);
  }
  return masks;
}

void TrackingLoop::showHead(TrackSnapshot& snapshot) {
  snapshot.frames = run_->frames();
  snapshot.frame = head();
  snapshot.iterations = run_->iterations();
  snapshot.targets = run_->snapshots(kParticlesShown);
  const TrackedFrame* moment = travel_ ? travel_->history().at(snapshot.frame) : nullptr;
  snapshot.tracked = moment != nullptr;
  if (run_->people() != nullptr) {
    snapshot.peopleCameras = run_->people()->tracker().cameraStates();
  }
  for (std::size_t k = 0; k < snapshot.targets.size(); ++k) {
    TargetSnapshot& target = snapshot.targets[k];
    if (k < tails_.size()) {
      target.tail.assign(tails_[k].begin(), tails_[k].end());
    }
    if (moment != nullptr && k < moment->targets.size()) {
      target.status = moment->targets[k].status;
      target.reasons = moment->targets[k].reasons;
      target.proposals = moment->targets[k].proposals;
    }
  }
  if (mapsWanted_ && snapshot.tracked) {
    TimeTravel::addMaps(*run_, snapshot);
  }
}

void TrackingLoop::addFigures(TrackSnapshot& snapshot) const {
  if (frameTimes_.size() > 1) {
    const std::chrono::duration<double> span = frameTimes_.back() - frameTimes_.front();
    snapshot.framesPerSecond =
        static_cast<double>(frameTimes_.size() - 1) / std::max(1e-9, span.count());
  }
  snapshot.microsecondsPerIteration = upperMedian({iterationTimes_.begin(), iterationTimes_.end()});
  snapshot.budget = budget_;
  snapshot.latency = log_.latency();
}

void TrackingLoop::addOthers(TrackSnapshot& snapshot) const {
  // Nothing is believed of them at that moment, but they are known; people are not there yet.
  if (snapshot.tracked && run_->people() == nullptr) {
    return;
  }
  for (std::size_t k = snapshot.targets.size(); k < run_->targets().size(); ++k) {
    TargetSnapshot& other = snapshot.targets.emplace_back();
    other.target = run_->targets()[k];
    if (run_->people() != nullptr) {
      other.estimate.gone = true;
      other.status = TargetStatus::Gone;
    }
  }
}

void TrackingLoop::addShapes(TrackSnapshot& snapshot) {
  for (TargetSnapshot& target : snapshot.targets) {
    if (target.person && target.particles.rows() > 0) {
      target.shape = std::make_shared<const PersonShape>(
          personShape(BodyCloud{target.particles, target.weights}));
    }
  }
}

void TrackingLoop::publish(bool quickly) {
  auto snapshot = std::make_shared<TrackSnapshot>();
  snapshot->rig = rig_;
  snapshot->family = methodFamily(project_.method);
  snapshot->emptyRooms = emptyRooms_;
  snapshot->seed = project_.seed;
  snapshot->state = state_;
  snapshot->past = view_.has_value();
  mapsDue_ = false;
  exactDue_ = false;
  if (rerun_) {
    snapshot->rerun = rerun_->range;
  }
  if (run_) {
    Status shown;
    if (view_ && travel_) {
      shown = travel_->show(*view_, quickly, *snapshot);
    }
    if (!shown) {
      errors_.push_back(shown.error());
      view_.reset();
      snapshot->past = false;
    }
    if (!view_) {
      showHead(*snapshot);
    } else {
      addOthers(*snapshot);
      showPresentBoxes(*snapshot);
      const bool wanted = run_->people() != nullptr ? masksWanted_ : mapsWanted_;
      mapsDue_ = snapshot->tracked && wanted && !snapshot->preview;
    }
    if (shapesWanted_ && snapshot->ofPeople()) {
      addShapes(*snapshot);
    }
  }
  exactDue_ = snapshot->preview;
  snapshot->notices = errors_;
  snapshot->bumps = bumps_.reports();
  if (source_) {
    const auto more = source_->notices();
    snapshot->notices.insert(snapshot->notices.end(), more.begin(), more.end());
    snapshot->frameCount = source_->frameCount();
    snapshot->droppedFrames = source_->droppedFrames();
    snapshot->history = travel_->state();
  }
  std::ranges::move(bumps_.notices(), std::back_inserter(snapshot->notices));
  if (snapshot->frames) {
    for (auto& target : snapshot->targets) {
      if (snapshot->ofPeople()) {
        break; // which of the true people it is, nobody knows
      }
      target.truth = truth_.at(target.target.name, snapshot->frame);
    }
    // A target without a color has no mask.
    if (masksWanted_ && !snapshot->preview && snapshot->family == MethodFamily::Targets) {
      snapshot->masks = masks(*snapshot);
    } else if (masksWanted_ && snapshot->ofPeople() && !view_) {
      snapshot->masks = motionMasks(*run_);
    }
  }
  addFigures(*snapshot);
  log_.setFinished(atEnd_);
  published_ = Clock::now();
  publisher_.publish(std::move(snapshot));
}

void TrackingLoop::publishNowAndThen() {
  if (Clock::now() - published_ >= kBetweenSnapshots) {
    publish();
  }
}

void TrackingLoop::addMaps(const std::stop_token& stop) {
  mapsDue_ = false;
  auto snapshot = std::make_shared<TrackSnapshot>(*publisher_.newest());
  const auto goOn = [&] { return !stop.stop_requested() && commands_.empty(); };
  travel_->addMaps(project_, *view_, masksWanted_, *snapshot, goOn);
  publisher_.publish(std::move(snapshot));
}

} // namespace dewpoint::session

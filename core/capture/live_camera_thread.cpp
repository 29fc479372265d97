// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/live_camera_thread.h"

#include "core/base/thread_priority.h"
#include "core/capture/image_rate.h"
#include "core/capture/redacted_location.h"

#include <algorithm>
#include <utility>

namespace dewpoint::capture {

using namespace std::chrono_literals;

namespace {

constexpr auto kFirstPause = 250ms; ///< before the first new attempt; doubles up to the longest
/// Between two attempts.
constexpr auto kLongestPause = 4000ms;
/// A connected camera that has not sent an image for so long is called lost, though its read still
/// waits: four intervals between its images, within these limits. Chosen: the shorter one, so that
/// it is seen within a second.
constexpr auto kShortestSilence = 800ms;
constexpr auto kLongestSilence = 2s;
constexpr double kMissedImages = 4.0;
constexpr auto kReadTimeout = 1s; ///< with a read that does not return, when the thread has to end
/// By which share the longest latency of late is forgotten with each image. A judgment.
constexpr double kLatencyDecay = 0.02;

} // namespace

void WakeSignal::notify() {
  {
    std::scoped_lock lock(mutex_);
    ++notifyCount_;
  }
  notified_.notify_all();
}

std::uint64_t WakeSignal::notificationCount() const {
  std::scoped_lock lock(mutex_);
  return notifyCount_;
}

void WakeSignal::waitForNewNotification(std::uint64_t known, Clock::time_point deadline) {
  std::unique_lock lock(mutex_);
  notified_.wait_until(lock, deadline, [&] { return notifyCount_ > known; });
}

/// What the camera's thread alone knows.
struct LiveCameraThread::Progress {
  std::int64_t frames = 0;
  ImageRate rate;
  Clock::duration pause = kFirstPause;
};

LiveCameraThread::LiveCameraThread(const LiveCamera& camera, LiveStreamFactory factory,
                                   std::shared_ptr<WakeSignal> wakeSignal,
                                   Clock::time_point zeroTime)
    : shared_(std::make_shared<Shared>()) {
  shared_->camera = camera;
  shared_->shape = {camera.name,   camera.rotateDegrees, camera.width,
                    camera.height, camera.isMirrored,    camera.crop};
  shared_->health = ImageHealth(camera.device.format.frameRate, camera.delaySeconds);
  shared_->factory = std::move(factory);
  shared_->wakeSignal = std::move(wakeSignal);
  shared_->zeroTime = zeroTime;
  shared_->openingStartTime = Clock::now();
  thread_ = std::jthread([shared = shared_](const std::stop_token& stop) {
    setThreadPriority(ThreadPriority::Prompt); // frames are stamped here
    run(stop, *shared);
    std::scoped_lock lock(shared->mutex);
    shared->hasFinished = true;
    shared->stateChanged.notify_all();
  });
}

LiveCameraThread::~LiveCameraThread() {
  if (thread_.joinable()) {
    requestStop();
    joinUntil(Clock::now() + kReadTimeout);
  }
}

void LiveCameraThread::requestStop() {
  thread_.request_stop();
}

void LiveCameraThread::joinUntil(Clock::time_point deadline) {
  if (!thread_.joinable()) {
    return;
  }
  std::unique_lock lock(shared_->mutex);
  const bool ended =
      shared_->stateChanged.wait_until(lock, deadline, [&] { return shared_->hasFinished; });
  lock.unlock();
  if (ended) {
    thread_.join();
  } else {
    thread_.detach();
  }
}

bool LiveCameraThread::isDelivering() const {
  std::scoped_lock lock(shared_->mutex);
  return shared_->isConnected && !shared_->problem &&
         Clock::now() - shared_->lastGrabTime < silenceTimeout(*shared_);
}

/// The first image of a connection may take longer than the others.
LiveCameraThread::Clock::duration LiveCameraThread::silenceTimeout(const Shared& shared) {
  const double rate = shared.framesPerSecond;
  if (!shared.isConnected || !shared.hasGrabbed || rate <= 0.0) {
    return kLongestSilence;
  }
  const auto missed = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(kMissedImages / rate));
  return std::clamp<Clock::duration>(missed, kShortestSilence, kLongestSilence);
}

std::optional<Error> LiveCameraThread::problem() const {
  std::scoped_lock lock(shared_->mutex);
  if (shared_->problem) {
    return shared_->problem;
  }
  const auto silentSince = shared_->isConnected ? shared_->lastGrabTime : shared_->openingStartTime;
  if (Clock::now() - silentSince < silenceTimeout(*shared_)) {
    return std::nullopt;
  }
  // A pipeline without a sender opens for as long as nothing comes.
  return Error{shared_->isConnected ? ErrorCode::ConnectionLost : ErrorCode::DeviceUnavailable,
               redactedLocation(shared_->camera.location), quotedCameraName(shared_->camera.name),
               shared_->isConnected ? "connected, but it sends no images"
                                    : "no answer for two seconds; still waiting"};
}

std::optional<Error> LiveCameraThread::warning() const {
  std::scoped_lock lock(shared_->mutex);
  return shared_->warning.empty()
             ? std::nullopt
             : std::optional(Error{ErrorCode::BadValue, redactedLocation(shared_->camera.location),
                                   quotedCameraName(shared_->camera.name), shared_->warning});
}

std::optional<Error> LiveCameraThread::imageFault() const {
  std::scoped_lock lock(shared_->mutex);
  const auto fault = shared_->isConnected ? shared_->health.fault(Clock::now()) : std::nullopt;
  return fault ? std::optional(Error{fault->code, redactedLocation(shared_->camera.location),
                                     quotedCameraName(shared_->camera.name), fault->detail})
               : std::nullopt;
}

void LiveCameraThread::setProblem(Shared& shared, Error problem) {
  {
    std::scoped_lock lock(shared.mutex);
    shared.problem = std::move(problem);
  }
  shared.wakeSignal->notify();
}

/// Without a connection: never had one, or lost it.
void LiveCameraThread::setDisconnected(Shared& shared, const std::string& detail) {
  {
    std::scoped_lock lock(shared.mutex);
    shared.isConnected = false;
    shared.warning.clear();
    const auto code =
        shared.hasDelivered ? ErrorCode::ConnectionLost : ErrorCode::DeviceUnavailable;
    shared.problem = Error{code, redactedLocation(shared.camera.location),
                           quotedCameraName(shared.camera.name), detail};
  }
  shared.wakeSignal->notify();
}

void LiveCameraThread::run(const std::stop_token& stop, Shared& shared) {
  Progress progress;
  while (!stop.stop_requested()) {
    try {
      const LiveStreamPtr stream = shared.factory(shared.camera);
      if (const auto opened = stream->open(); !opened) {
        setDisconnected(shared, opened.error() + "; trying again");
      } else {
        readAll(stop, shared, *stream, progress);
        const std::string reason = stream->lostReason();
        const bool ended = stream->hasEnded();
        setDisconnected(shared, ended            ? reason
                                : reason.empty() ? "trying to connect again"
                                                 : reason + "; trying to connect again");
        if (ended) {
          return;
        }
      }
    } catch (const std::exception& problem) {
      setDisconnected(shared, problem.what());
    }
    std::unique_lock lock(shared.mutex);
    shared.stateChanged.wait_for(lock, stop, progress.pause, [] { return false; });
    progress.pause = std::min<Clock::duration>(progress.pause * 2, kLongestPause);
  }
}

void LiveCameraThread::readAll(const std::stop_token& stop, Shared& shared, LiveStream& stream,
                               Progress& progress) {
  {
    std::scoped_lock lock(shared.mutex);
    shared.isConnected = true;
    shared.warning = stream.warning();
    shared.lastGrabTime = Clock::now();
    shared.hasGrabbed = false;
    shared.health.restart(shared.lastGrabTime);
  }
  progress.rate.restart();
  while (!stop.stop_requested() && stream.grab()) {
    const auto grabbed = Clock::now();
    const cv::Mat picture = stream.retrieve();
    if (!picture.empty() && !stop.stop_requested()) {
      publish(shared, picture,
              {grabbed, stream.arrivalTime().value_or(grabbed),
               stream.captureTime().value_or(CaptureInstant{grabbed, TimeOrigin::Arrival})},
              progress);
    }
  }
}

void LiveCameraThread::publish(Shared& shared, const cv::Mat& picture, const Grabbed& when,
                               Progress& progress) {
  const Clock::time_point grabbed = when.grabTime;
  const CaptureInstant& captured = when.captureInstant;
  progress.pause = kFirstPause;
  progress.rate.add(captured.time); // images that were held up may arrive all at once
  shared.framesPerSecond = progress.rate.imagesPerSecond();
  const double latency = std::chrono::duration<double>(grabbed - captured.time).count();
  shared.latencySeconds =
      std::max(latency, shared.latencySeconds + kLatencyDecay * (latency - shared.latencySeconds));
  {
    std::scoped_lock lock(shared.mutex);
    shared.lastGrabTime = grabbed;
    shared.hasGrabbed = true;
    shared.hasDelivered = true;
  }
  auto image = prepareImage(picture, shared.shape, redactedLocation(shared.camera.location));
  if (!image) {
    setProblem(shared, image.error());
    return;
  }
  // Where any size will do, all that follow have that of the first one.
  shared.shape.width = image->cols;
  shared.shape.height = image->rows;
  {
    std::scoped_lock lock(shared.mutex); // first, so that nobody sees the frame and an old problem
    shared.problem.reset();
    shared.health.add(*image, grabbed,
                      captured.origin == TimeOrigin::Arrival ? std::nullopt
                                                             : std::optional(captured.time));
  }
  shared.frames.put(std::make_shared<Frame>(
      Frame{progress.frames++,
            std::chrono::duration_cast<TimeStamp>(captured.time - shared.zeroTime),
            std::move(*image),
            captured.origin,
            {captured.time, when.arrivalTime, Clock::now(), captured.imageId}}));
  shared.wakeSignal->notify();
}

} // namespace dewpoint::capture

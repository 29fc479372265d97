// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/integration/fake_desk.h"

#include "core/simulation/scene/scene_renderer.h"
#include "tests/integration/image_tag.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <fcntl.h>
#include <stdexcept>
#include <unistd.h>
#include <utility>

namespace dewpoint::tests {
namespace {

Scene sceneOnDesk() {
  Scene scene = demoScene();
  scene.name = "fake desk";
  scene.framesPerSecond = FakeDesk::kTicksPerSecond;
  scene.frameCount = 2 * FakeDesk::kRoundTicks;
  scene.balls.front().motion = Motion::Smooth;
  scene.balls.front().stillSeconds = 0.0;
  scene.balls.front().period =
      static_cast<double>(FakeDesk::kRoundTicks) / FakeDesk::kTicksPerSecond;
  scene.cameras.clear();
  for (int k = 0; k < FakeDesk::kCameras; ++k) {
    const double angle = 0.4 + 1.57 * k;
    Camera camera;
    camera.name = fmt::format("camera {}", k + 1);
    camera.intrinsics = {FakeDesk::kWidth, FakeDesk::kHeight, kDeskFocal, kDeskFocal, 159.5, 119.5};
    camera.cameraFromWorld =
        lookAt({0.5 + 1.1 * std::cos(angle), 0.5 + 1.1 * std::sin(angle), 0.7}, kDeskCenter);
    scene.cameras.push_back(camera);
  }
  return scene;
}

} // namespace

void FakeCamera::clear() {
  isFrozen = false;
  spoiled.clear();
  duplicates = reorders = held = 0;
}

FakeDesk::FakeDesk() : scene(sceneOnDesk()) {
  const SceneRenderer renderer(scene);
  for (int camera = 0; camera < kCameras; ++camera) {
    for (std::int64_t tick = 0; tick < kRoundTicks; ++tick) {
      film[static_cast<std::size_t>(camera)].push_back(renderer.render(camera, kRoundTicks + tick));
    }
  }
  begin = Clock::now();
}

FakeDesk::Clock::time_point FakeDesk::timeOf(std::int64_t tick) const {
  return begin + std::chrono::duration_cast<Clock::duration>(
                     std::chrono::duration<double>(static_cast<double>(tick) / kTicksPerSecond));
}

std::int64_t FakeDesk::now() const {
  const std::chrono::duration<double> since = Clock::now() - begin;
  return static_cast<std::int64_t>(std::floor(since.count() * kTicksPerSecond));
}

Eigen::Vector3d FakeDesk::ballAt(std::int64_t tick) const {
  return ballPosition(scene, 0,
                      static_cast<double>(kRoundTicks + tick % kRoundTicks) / kTicksPerSecond);
}

FakeCamera* FakeDesk::at(const std::string& path) {
  const auto found = std::ranges::find_if(cameras, [&](const FakeCamera& one) {
    return one.isPlugged() && path == fmt::format("/dev/video{}", one.node);
  });
  return found == cameras.end() ? nullptr : &*found;
}

FakeDeskStream::FakeDeskStream(std::shared_ptr<FakeDesk> desk, std::string path)
    : desk_(std::move(desk)), path_(std::move(path)) {
  ++desk_->connections;
}

FakeDeskStream::~FakeDeskStream() {
  if (handle_ >= 0) {
    ::close(handle_);
  }
  --desk_->connections;
}

tl::expected<void, std::string> FakeDeskStream::open() {
  std::scoped_lock lock(desk_->mutex);
  camera_ = desk_->at(path_);
  if (camera_ == nullptr) {
    return tl::make_unexpected(std::string("no such device is plugged in"));
  }
  number_ = camera_->number;
  plugin_ = camera_->plugins;
  next_ = desk_->now() + 1;
  handle_ = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  return {};
}

bool FakeDeskStream::grab() {
  std::unique_lock lock(desk_->mutex);
  if (waiting_.empty() && !collect(lock)) {
    return false;
  }
  shot_ = waiting_.front();
  waiting_.pop_front();
  captured_ =
      clock_.nextCaptureInstant(desk_->timeOf(shot_.tick) + shot_.stampOff, FakeDesk::Clock::now());
  return true;
}

cv::Mat FakeDeskStream::retrieve() {
  const auto& film = desk_->film[static_cast<std::size_t>(number_)];
  cv::Mat image = film[static_cast<std::size_t>(shot_.tick % FakeDesk::kRoundTicks)].clone();
  spoil(image);
  return image;
}

bool FakeDeskStream::waitFor(std::unique_lock<std::mutex>& lock, std::int64_t tick) {
  desk_->changed.wait_until(lock, desk_->timeOf(tick), [&] { return isLost(); });
  desk_->changed.wait(lock, [&] { return isLost() || !camera_->isFrozen; });
  return !isLost();
}

bool FakeDeskStream::collect(std::unique_lock<std::mutex>& lock) {
  if (!waitFor(lock, next_)) {
    return false;
  }
  next_ = std::max(next_, desk_->now()); // like a device, it has only its newest image
  std::int64_t count = 1 + std::exchange(camera_->held, 0);
  const bool swaps = camera_->reorders > 0;
  if (swaps) {
    --camera_->reorders;
    count = std::max<std::int64_t>(count, 2);
  }
  const std::int64_t first = next_;
  next_ += count;
  if (count > 1 && !waitFor(lock, next_ - 1)) {
    return false;
  }
  for (std::int64_t tick = first; tick < next_; ++tick) {
    Shot shot;
    if (!camera_->spoiled.empty()) {
      shot = camera_->spoiled.front();
      camera_->spoiled.pop_front();
    }
    shot.tick = tick;
    waiting_.push_back(shot);
  }
  if (swaps) {
    std::swap(waiting_[0], waiting_[1]);
  }
  for (; camera_->duplicates > 0; --camera_->duplicates) {
    waiting_.push_back(waiting_.back());
  }
  return true;
}

void FakeDeskStream::spoil(cv::Mat& image) const {
  switch (shot_.spoiled) {
  case Spoiled::Empty:
    image = cv::Mat();
    return;
  case Spoiled::Undecodable:
    throw std::runtime_error("the image cannot be decoded");
  case Spoiled::OtherSize:
    cv::resize(image, image, {}, 2.0, 2.0);
    break;
  case Spoiled::Noise:
    cv::RNG(static_cast<std::uint64_t>(shot_.tick)).fill(image, cv::RNG::UNIFORM, 0, 256);
    break;
  case Spoiled::Torn:
    image.rowRange(FakeDesk::kHeight / 4, FakeDesk::kHeight).setTo(cv::Scalar::all(128));
    break;
  case Spoiled::Gray:
  case Spoiled::Deep:
  case Spoiled::No:
    break;
  }
  drawTag(image, {number_, shot_.tick, shot_.spoiled == Spoiled::No});
  if (shot_.spoiled == Spoiled::Gray) {
    cv::cvtColor(image, image, cv::COLOR_BGR2GRAY);
  } else if (shot_.spoiled == Spoiled::Deep) {
    image.convertTo(image, CV_16UC3, 256.0);
  }
}

} // namespace dewpoint::tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/integration/disturbed_cameras.h"

#include "app/wiring/open_project.h"
#include "core/capture/devices/device_stream.h"
#include "core/capture/live_frame_source.h"
#include "tests/capture/devices/fake_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace dewpoint::tests {
namespace {

constexpr int kNodes = 8;       ///< numbers that a device may get
constexpr int kMostSpoiled = 8; ///< images in a row

} // namespace

DisturbedCameras::DisturbedCameras(std::uint64_t seed)
    : desk_(std::make_shared<FakeDesk>()), machine_(std::make_shared<FakeMachine>()),
      access_(accessTo(machine_)), random_(seed) {
  for (int number = 0; number < FakeDesk::kCameras; ++number) {
    FakeCamera& camera = desk_->cameras[static_cast<std::size_t>(number)];
    camera.number = number;
    camera.port = std::to_string(3 + number);
    camera.serial = number < 2 ? "" : fmt::format("A{}", number);
    plug(camera, number);
  }
  for (const CameraDevice& device : access_->listDevices()) {
    identities_.push_back(device.identity);
  }
}

DisturbedCameras::~DisturbedCameras() {
  mend();
}

void DisturbedCameras::plug(FakeCamera& camera, int node) {
  FakeNode plugged;
  plugged.name = fmt::format("video{}", node);
  plugged.port = camera.port;
  plugged.serial = camera.serial;
  plugged.formats = {fakeMjpg(), fakeYuyv()};
  machine_->plug(plugged);
  camera.node = node;
  ++camera.plugins;
  desk_->changed.notify_all();
}

void DisturbedCameras::unplug(FakeCamera& camera) {
  machine_->unplug(fmt::format("video{}", camera.node));
  camera.clear();
  camera.node = -1;
  ++camera.plugins;
  desk_->changed.notify_all();
}

int DisturbedCameras::freeNode() {
  for (;;) {
    const int node = static_cast<int>(below(kNodes));
    if (std::ranges::none_of(desk_->cameras,
                             [&](const FakeCamera& one) { return one.node == node; })) {
      return node;
    }
  }
}

Project DisturbedCameras::project() const {
  Project project = makeSceneProject(desk_->scene, "");
  for (std::size_t k = 0; k < FakeDesk::kCameras; ++k) {
    project.cameras[k].source = SourceKind::Device;
    project.cameras[k].location = fmt::format("/dev/video{}", k);
    project.cameras[k].device.identity = identities_[k];
  }
  return project;
}

Result<std::unique_ptr<FrameSetSource>> DisturbedCameras::open() {
  const std::vector<LiveCamera> cameras = liveCamerasOf(project());
  return openLive(cameras, [cameras, identities = identities_, access = access_,
                            desk = desk_](const LiveCamera& camera) {
    const auto found = std::ranges::find(cameras, camera.name, &LiveCamera::name);
    return makeDeviceStream(camera,
                            {access, identities, static_cast<std::size_t>(found - cameras.begin())},
                            [desk](const LiveCamera& at) {
                              return std::make_unique<FakeDeskStream>(desk, at.location);
                            });
  });
}

std::string DisturbedCameras::happen(Disturbance what, FakeCamera& camera) {
  const int count = 1 + static_cast<int>(below(kMostSpoiled));
  const auto spoil = [&](Shot shot) {
    camera.spoiled.insert(camera.spoiled.end(), static_cast<std::size_t>(count), shot);
  };
  switch (what) {
  case Disturbance::Plug:
    plug(camera, freeNode());
    return fmt::format("plugged in as video{}", camera.node);
  case Disturbance::Unplug:
    unplug(camera);
    return "unplugged";
  case Disturbance::Exchange: {
    FakeCamera& first = desk_->cameras[0];
    FakeCamera& second = desk_->cameras[1];
    const int a = first.node;
    const int b = second.node;
    for (FakeCamera* one : {&first, &second}) {
      if (one->isPlugged()) {
        unplug(*one);
      }
    }
    plug(first, b >= 0 ? b : freeNode());
    plug(second, a >= 0 && a != first.node ? a : freeNode());
    return fmt::format("the twins exchanged: video{} and video{}", first.node, second.node);
  }
  case Disturbance::Freeze:
    camera.isFrozen = true;
    return "frozen";
  case Disturbance::Thaw:
    camera.isFrozen = false;
    desk_->changed.notify_all();
    return "thawed";
  case Disturbance::Duplicate:
    camera.duplicates += count;
    return fmt::format("an image comes {} times", count + 1);
  case Disturbance::Reorder:
    camera.reorders += count;
    return fmt::format("{} pairs of images in the wrong order", count);
  case Disturbance::Burst:
    camera.held += count;
    return fmt::format("{} images late and at once", count + 1);
  case Disturbance::Resize:
    spoil({0, Spoiled::OtherSize});
    return fmt::format("{} images of another size", count);
  case Disturbance::Corrupt: {
    constexpr std::array kKinds{std::pair(Spoiled::Empty, "empty"),
                                std::pair(Spoiled::Noise, "of noise"),
                                std::pair(Spoiled::Torn, "torn"),
                                std::pair(Spoiled::Gray, "gray"),
                                std::pair(Spoiled::Deep, "of 16 bits"),
                                std::pair(Spoiled::Undecodable, "that cannot be decoded")};
    const auto& [kind, name] = kKinds[below(kKinds.size())];
    spoil({0, kind});
    return fmt::format("{} images {}", count, name);
  }
  case Disturbance::WrongTime: {
    const bool isFuture = below(2) == 0;
    spoil({0, Spoiled::No, std::chrono::hours(isFuture ? 1 : -1)});
    return fmt::format("{} time stamps an hour too {}", count, isFuture ? "late" : "early");
  }
  }
  return {};
}

std::string DisturbedCameras::disturb() {
  constexpr std::array kOthers{Disturbance::Unplug,    Disturbance::Exchange, Disturbance::Freeze,
                               Disturbance::Duplicate, Disturbance::Reorder,  Disturbance::Burst,
                               Disturbance::Resize,    Disturbance::Corrupt,  Disturbance::Corrupt,
                               Disturbance::WrongTime};
  std::scoped_lock lock(desk_->mutex);
  FakeCamera& camera = desk_->cameras[below(FakeDesk::kCameras)];
  Disturbance what = kOthers[below(kOthers.size())];
  if (!camera.isPlugged()) {
    what = Disturbance::Plug;
  } else if (camera.isFrozen && what != Disturbance::Unplug) {
    what = Disturbance::Thaw;
  }
  const std::string words = happen(what, camera);
  return fmt::format("tick {}, camera {}: {}", desk_->now(), camera.number + 1, words);
}

void DisturbedCameras::mend() {
  std::scoped_lock lock(desk_->mutex);
  for (FakeCamera& camera : desk_->cameras) {
    camera.clear();
    if (!camera.isPlugged()) {
      plug(camera, freeNode());
    }
  }
  desk_->changed.notify_all();
}

int DisturbedCameras::connections() const {
  return desk_->connections;
}

} // namespace dewpoint::tests

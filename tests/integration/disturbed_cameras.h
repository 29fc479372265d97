// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/device_access.h"
#include "core/capture/frame_source.h"
#include "core/project/project.h"
#include "tests/integration/fake_desk.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace dewpoint::tests {

class FakeMachine;

/// What can happen to a camera.
enum class Disturbance {
  Unplug,
  Plug,      ///< at the camera's connector; it gets any free node number
  Exchange,  ///< two equal cameras are unplugged, and come back with each other's numbers
  Freeze,    ///< reading waits for an image that does not come
  Thaw,      ///< a frozen camera sends images again
  Duplicate, ///< an image comes twice
  Reorder,   ///< two images come in the wrong order
  Burst,     ///< some images come late, and all at once
  Resize,    ///< some images have another size
  Corrupt,   ///< some images are empty, noise, torn, gray, of 16 bits, or cannot be decoded
  WrongTime, ///< some time stamps are an hour off
};

/// The cameras of a FakeDesk, which are plugged into a fake computer. Dewpoint finds them with the
/// same code as real devices. Two of them are equal and have no serial numbers.
class DisturbedCameras {
public:
  /// `seed`: seed of the random events. Renders the film.
  explicit DisturbedCameras(std::uint64_t seed);
  ~DisturbedCameras();

  /// Returns a project that tracks the ball with these cameras.
  Project project() const;
  /// Opens the cameras.
  Result<std::unique_ptr<FrameSetSource>> open();
  /// Returns the true position of the ball at a tick, meters.
  Eigen::Vector3d truth(std::int64_t tick) const { return desk_->ballAt(tick); }

  /// Causes the next random event, and returns a text that describes it.
  std::string disturb();
  /// Ends all disturbances.
  void mend();
  /// Returns the number of existing connections to the cameras.
  int connections() const;

private:
  void plug(FakeCamera& camera, int node);
  void unplug(FakeCamera& camera);
  int freeNode();
  std::uint64_t below(std::uint64_t count) { return random_() % count; }
  std::string happen(Disturbance what, FakeCamera& camera);

  std::shared_ptr<FakeDesk> desk_; ///< shared with streams whose thread was abandoned
  std::shared_ptr<FakeMachine> machine_;
  DeviceAccessPtr access_;
  std::vector<DeviceIdentity> identities_;
  std::mt19937_64 random_;
};

} // namespace dewpoint::tests

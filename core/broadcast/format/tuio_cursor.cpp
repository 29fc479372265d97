// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/format/tuio_cursor.h"

#include "core/broadcast/format/osc_bundle.h"

#include <utility>

namespace dewpoint::broadcast {
namespace {

constexpr std::string_view kCursorAddress = "/tuio/3Dcur";
constexpr double kSmallestVolume = 1e-9; ///< a flat volume must not divide by zero

OscMessage tuioSet(const TargetMessage& target, const WorldBox& volume) {
  const Eigen::Array3d size = (volume.max - volume.min).array().max(kSmallestVolume);
  const Eigen::Array3d position = (*target.position - volume.min).array() / size;
  const Eigen::Array3d velocity =
      target.velocity.value_or(Eigen::Vector3d(Eigen::Vector3d::Zero())).array() / size;
  const double speed = velocity.matrix().norm();
  const Eigen::Array3d change = target.acceleration.array() / size;
  OscMessage set{kCursorAddress, {std::string("set"), target.id}};
  set.addVector(position);
  set.addVector(velocity);
  set.arguments.emplace_back(
      static_cast<float>(speed > 0.0 ? (velocity * change).sum() / speed : 0.0));
  return set;
}

} // namespace

std::vector<std::string> tuioFrameBundles(const FrameMessage& frame) {
  OscMessage alive{kCursorAddress, {std::string("alive")}};
  for (const TargetMessage& target : frame.targets) {
    if (target.position) {
      alive.arguments.emplace_back(target.id);
    }
  }
  const std::vector<OscMessage> head{std::move(alive)};
  const std::vector<OscMessage> tail{
      {kCursorAddress, {std::string("fseq"), static_cast<std::int32_t>(frame.sequenceNumber)}}};
  const std::size_t tailBytes = OscBundle::byteCountOf(tail);
  std::vector<std::string> bundles;
  OscBundle bundle;
  bundle.add(head);
  const std::size_t empty = bundle.byteCount();
  const auto finish = [&] {
    bundle.add(tail);
    bundles.push_back(std::exchange(bundle, OscBundle()).bytes());
  };
  for (const TargetMessage& target : frame.targets) {
    if (!target.position) {
      continue;
    }
    const std::vector<OscMessage> set{tuioSet(target, frame.rig->volume)};
    if (bundle.byteCount() > empty &&
        bundle.byteCount() + OscBundle::byteCountOf(set) + tailBytes > kMaxDatagram) {
      finish();
      bundle.add(head);
    }
    bundle.add(set);
  }
  finish();
  return bundles;
}

} // namespace dewpoint::broadcast

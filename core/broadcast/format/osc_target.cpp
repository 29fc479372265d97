// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/format/osc_target.h"

#include "core/broadcast/format/osc_bundle.h"

#include <utility>

namespace dewpoint::broadcast {
namespace {

std::vector<OscMessage> oscTarget(const TargetMessage& target, const RigMessage& rig) {
  if (!target.position) {
    return {
        {"/dewpoint/absent",
         {target.id, target.name, target.state, static_cast<float>(target.existenceProbability)}}};
  }
  OscMessage main{"/dewpoint/target", {target.id, target.name, target.state}};
  main.addVector(*target.position);
  main.addVector(target.velocity.value_or(Eigen::Vector3d(Eigen::Vector3d::Zero())));
  main.arguments.emplace_back(static_cast<float>(target.existenceProbability));
  OscMessage covariance{"/dewpoint/covariance", {target.id}};
  const Eigen::Matrix3d& c = target.covariance;
  covariance.addVector(Eigen::Vector3d(c(0, 0), c(0, 1), c(0, 2)));
  covariance.addVector(Eigen::Vector3d(c(1, 1), c(1, 2), c(2, 2)));
  OscMessage cameras{"/dewpoint/cameras", {target.id}};
  for (const int camera : target.seeingCameras) {
    cameras.arguments.emplace_back(rig.cameras.at(static_cast<std::size_t>(camera)).name);
  }
  return {std::move(main), std::move(covariance), std::move(cameras)};
}

} // namespace

std::vector<std::string> oscFrameBundles(const FrameMessage& frame) {
  const std::vector<OscMessage> head{
      {"/dewpoint/frame",
       {static_cast<std::int32_t>(frame.frame), static_cast<std::int32_t>(frame.sequenceNumber),
        static_cast<float>(frame.time), static_cast<std::int32_t>(frame.targets.size())}}};
  std::vector<std::string> bundles;
  OscBundle bundle;
  bundle.add(head);
  const std::size_t empty = bundle.byteCount();
  for (const TargetMessage& target : frame.targets) {
    const std::vector<OscMessage> messages = oscTarget(target, *frame.rig);
    if (bundle.byteCount() > empty &&
        bundle.byteCount() + OscBundle::byteCountOf(messages) > kMaxDatagram) {
      bundles.push_back(std::exchange(bundle, OscBundle()).bytes());
      bundle.add(head);
    }
    bundle.add(messages);
  }
  bundles.push_back(bundle.bytes());
  return bundles;
}

} // namespace dewpoint::broadcast

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/format/csv_row.h"

#include "core/project/project_output.h"
#include "core/trajectory/csv_text.h"

#include <fmt/format.h>

#include <optional>

namespace dewpoint::broadcast {
namespace {

std::string csvVector(const std::optional<Eigen::Vector3d>& vector) {
  return vector ? fmt::format("{:.9g},{:.9g},{:.9g}", vector->x(), vector->y(), vector->z())
                : std::string(",,");
}

std::string csvTargetRow(const FrameMessage& frame, const TargetMessage& target) {
  std::string cameras;
  for (const int camera : target.seeingCameras) {
    const CameraMessage& one = frame.rig->cameras.at(static_cast<std::size_t>(camera));
    cameras += (cameras.empty() ? "" : ";") + one.name;
  }
  const Eigen::Matrix3d& c = target.covariance;
  const std::string covariance =
      target.position ? fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}", c(0, 0), c(0, 1),
                                    c(0, 2), c(1, 1), c(1, 2), c(2, 2))
                      : std::string(5, ',');
  return fmt::format("{:.9g},{},{},{},{},{},{},{},{:.6g},{}\n", frame.time, frame.frame, target.id,
                     trajectory::csvCell(target.name), target.state, csvVector(target.position),
                     csvVector(target.velocity), covariance, target.existenceProbability,
                     trajectory::csvCell(cameras));
}

} // namespace

std::string csvHeaderRow(const RigMessage& rig) {
  return fmt::format("time_s,frame,id,target,state,x_{0},y_{0},z_{0},vx_{0}_s,vy_{0}_s,vz_{0}_s,"
                     "cov_xx_{0}2,cov_xy_{0}2,cov_xz_{0}2,cov_yy_{0}2,cov_yz_{0}2,cov_zz_{0}2,"
                     "existence,cameras\n",
                     nameOf(rig.coordinates.unit));
}

std::vector<std::string> csvFrameRows(const FrameMessage& frame) {
  std::vector<std::string> rows;
  rows.reserve(frame.targets.size());
  for (const TargetMessage& target : frame.targets) {
    rows.push_back(csvTargetRow(frame, target));
  }
  return rows;
}

} // namespace dewpoint::broadcast

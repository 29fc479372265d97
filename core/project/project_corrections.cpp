// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_corrections.h"

#include "core/base/limits.h"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace dewpoint::project {
namespace {

// Chosen: far beyond what any rig sees, so that only files with a mistake are refused.
constexpr double kMostMeters = 1e4;      ///< of a coordinate
constexpr double kLeastVariance = 1e-12; ///< m², along any axis: it has to be inverted
constexpr double kMostPixels = 1e6;      ///< of any image

PositionCorrection readCorrection(const toml::table& table, const std::string& file,
                                  std::size_t index, std::optional<Error>& error) {
  const std::string prefix = fmt::format("correction {}.", index + 1);
  TableReader reader(table, file, prefix);
  PositionCorrection correction;
  reader.require("frame");
  reader.readInteger("frame", correction.frame, 0, limits::kMaxFrames);
  int target = 1;
  reader.require("target");
  reader.readInteger("target", target, 1, limits::kMaxTargets);
  correction.target = target - 1;
  reader.require("position");
  reader.readNumbers("position", correction.position.data(), 3, -kMostMeters, kMostMeters);
  reader.require("covariance");
  std::array<double, 6> c{};
  if (reader.readNumbers("covariance", c.data(), c.size())) {
    correction.covariance << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
  }
  std::int64_t from = -1;
  reader.readInteger("tracked_from", from, 0, limits::kMaxFrames);
  if (from >= 0) {
    correction.trackedFrom = from;
  }
  for (const toml::table* one : reader.findTables("click")) {
    TableReader click(*one, file, fmt::format("{}click {}.", prefix, correction.clicks.size() + 1));
    int camera = 1;
    click.require("camera");
    click.readInteger("camera", camera, 1, limits::kMaxCameras);
    PointClick& read = correction.clicks.emplace_back();
    read.camera = camera - 1;
    click.require("pixel");
    click.readNumbers("pixel", read.pixel.data(), 2, -kMostPixels, kMostPixels);
    reader.recordError(click.finish());
  }
  error = reader.finish();
  return correction;
}

bool isCovariance(const Eigen::Matrix3d& matrix) {
  return matrix.allFinite() && matrix == matrix.transpose() &&
         Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly)
                 .eigenvalues()[0] >= kLeastVariance;
}

Status checkCorrection(const PositionCorrection& correction, const std::string& field,
                       const Project& project) {
  const auto wrong = [&](const std::string& key, const std::string& detail) {
    return Status(failure(ErrorCode::BadValue, "", field + key, detail));
  };
  if (correction.frame < 0) {
    return wrong(".frame", "frames are counted from 0");
  }
  if (correction.target < 0 || correction.target >= static_cast<int>(project.targets.size())) {
    return wrong(".target", fmt::format("there is no target {}", correction.target + 1));
  }
  if (!correction.position.allFinite() || correction.position.cwiseAbs().maxCoeff() > kMostMeters) {
    return wrong(".position", fmt::format("numbers up to {} m are expected", kMostMeters));
  }
  if (!isCovariance(correction.covariance)) {
    return wrong(".covariance",
                 "xx, xy, xz, yy, yz, zz of a matrix with positive eigenvalues are expected");
  }
  if (correction.trackedFrom && *correction.trackedFrom <= correction.frame) {
    return wrong(".tracked_from", "a later frame than that of the correction is expected");
  }
  // The cameras of a scene come later, when it is opened.
  const bool areKnown = project.scene.empty() ||
                        (!project.cameras.empty() &&
                         std::ranges::none_of(project.cameras, &ProjectCamera::hasOwnCalibration));
  std::set<int> seen;
  for (std::size_t k = 0; k < correction.clicks.size(); ++k) {
    const PointClick& click = correction.clicks[k];
    const std::string key = fmt::format(".click {}", k + 1);
    if (click.camera < 0 ||
        (areKnown && click.camera >= static_cast<int>(project.cameras.size()))) {
      return wrong(key + ".camera", fmt::format("there is no camera {}", click.camera + 1));
    }
    if (!seen.insert(click.camera).second) {
      return wrong(key + ".camera", fmt::format("two clicks in camera {}", click.camera + 1));
    }
    if (!click.pixel.allFinite()) {
      return wrong(key + ".pixel", "finite numbers are expected");
    }
  }
  return {};
}

} // namespace

void readCorrections(TableReader& reader, const std::string& file, Project& project) {
  std::optional<Error> error;
  for (const toml::table* table : reader.findTables("correction")) {
    project.corrections.push_back(readCorrection(*table, file, project.corrections.size(), error));
    // Checked before they are sorted: the error counts them as the file does.
    if (const auto good =
            checkCorrection(project.corrections.back(),
                            fmt::format("correction {}", project.corrections.size()), project);
        !good && !error) {
      error = Error{good.error().code, file, good.error().field, good.error().detail};
    }
    reader.recordError(error);
  }
  std::ranges::stable_sort(project.corrections, {}, &PositionCorrection::frame);
}

std::string correctionsText(const Project& project) {
  std::string text;
  for (const PositionCorrection& one : project.corrections) {
    const Eigen::Vector3d& p = one.position;
    const Eigen::Matrix3d& c = one.covariance;
    text += fmt::format("\n[[correction]]\nframe = {}\ntarget = {}\nposition = [{}, {}, {}]\n"
                        "covariance = [{}, {}, {}, {}, {}, {}]\n",
                        one.frame, one.target + 1, p.x(), p.y(), p.z(), c(0, 0), c(0, 1), c(0, 2),
                        c(1, 1), c(1, 2), c(2, 2));
    if (one.trackedFrom) {
      text += fmt::format("tracked_from = {}\n", *one.trackedFrom);
    }
    for (const PointClick& click : one.clicks) {
      text += fmt::format("[[correction.click]]\ncamera = {}\npixel = [{}, {}]\n", click.camera + 1,
                          click.pixel.x(), click.pixel.y());
    }
  }
  return text;
}

Status checkCorrections(const Project& project) {
  for (std::size_t k = 0; k < project.corrections.size(); ++k) {
    if (auto good =
            checkCorrection(project.corrections[k], fmt::format("correction {}", k + 1), project);
        !good) {
      return good;
    }
  }
  return {};
}

} // namespace dewpoint::project

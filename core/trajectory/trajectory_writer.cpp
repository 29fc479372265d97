// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/trajectory_writer.h"

#include "core/base/text_file.h"
#include "core/trajectory/csv_text.h"

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace dewpoint::trajectory {
namespace {

constexpr std::string_view kColumns =
    "time_s,frame,target,x_m,y_m,z_m,cov_xx_m2,cov_xy_m2,cov_xz_m2,cov_yy_m2,cov_yz_m2,cov_zz_m2,"
    "ess,cameras,valid";
constexpr std::string_view kSeenColumns =
    ",seen_x_m,seen_y_m,seen_z_m,seen_cov_xx_m2,seen_cov_xy_m2,seen_cov_xz_m2,seen_cov_yy_m2,"
    "seen_cov_yz_m2,seen_cov_zz_m2";
constexpr std::string_view kBestColumns = ",best_x_m,best_y_m,best_z_m";
constexpr std::string_view kCorrectedColumn = ",corrected";
constexpr std::string_view kAmbiguousColumn = ",ambiguous";
constexpr std::string_view kExtentColumns =
    ",extent_xx_m2,extent_xy_m2,extent_xz_m2,extent_yy_m2,extent_yz_m2,extent_zz_m2";

std::string headerText(const TrajectoryHeader& header) {
  std::string text = "# dewpoint trajectory\n# units: time s, position m, covariance m^2\n";
  for (const auto& [key, value] : header.entries)
    text += fmt::format("# {}: {}\n", withoutLineBreaks(key), withoutLineBreaks(value));
  for (const TrajectoryCamera& camera : header.cameras) {
    const auto& c = camera.center;
    const auto& a = camera.opticalAxis;
    text += fmt::format("# camera: {} center {} {} {} axis {} {} {}\n", quotedCsv(camera.name),
                        c.x(), c.y(), c.z(), a.x(), a.y(), a.z());
  }
  text.append(kColumns).append(header.hasMeasurements ? kSeenColumns : "");
  text.append(header.hasBestParticles ? kBestColumns : "");
  text.append(header.hasCorrectedColumn ? kCorrectedColumn : "");
  text.append(header.hasAmbiguousColumn ? kAmbiguousColumn : "");
  text.append(header.hasExtent ? kExtentColumns : "");
  return text + '\n';
}

std::string symmetricText(const Eigen::Matrix3d& c) {
  return fmt::format("{},{},{},{},{},{}", c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2));
}

std::string numbersText(const Eigen::Vector3d& p, const Eigen::Matrix3d& c) {
  return fmt::format("{},{},{},{}", p.x(), p.y(), p.z(), symmetricText(c));
}

std::string rowText(const TrajectorySample& sample, const TrajectoryHeader& header) {
  std::string text =
      fmt::format("{},{},{},{},{},{},{}", sample.time, sample.frame, csvCell(sample.target),
                  numbersText(sample.position, sample.covariance), sample.effectiveSampleSize,
                  sample.cameraCount, sample.isValid ? 1 : 0);
  if (header.hasMeasurements) {
    text += sample.measurement
                ? ',' + numbersText(sample.measurement->position, sample.measurement->covariance)
                : std::string(9, ',');
  }
  if (header.hasBestParticles) {
    text += sample.bestParticle ? fmt::format(",{},{},{}", sample.bestParticle->x(),
                                              sample.bestParticle->y(), sample.bestParticle->z())
                                : std::string(3, ',');
  }
  if (header.hasCorrectedColumn) {
    text += sample.isCorrected ? ",1" : ",0";
  }
  if (header.hasAmbiguousColumn) {
    text += sample.isAmbiguous ? ",1" : ",0";
  }
  if (header.hasExtent) {
    text += sample.extent ? ',' + symmetricText(*sample.extent) : std::string(6, ',');
  }
  return text + '\n';
}

} // namespace

Result<TrajectoryWriter> TrajectoryWriter::create(const std::filesystem::path& path,
                                                  const TrajectoryHeader& header) {
  auto file = GrowingFile::create(path);
  if (!file) {
    return tl::make_unexpected(file.error());
  }
  if (const Status written = file->append(headerText(header)); !written) {
    return tl::make_unexpected(written.error());
  }
  return TrajectoryWriter(std::move(*file), header);
}

Status TrajectoryWriter::write(const TrajectorySample& sample) {
  return file_.append(rowText(sample, header_));
}

Status TrajectoryWriter::finish() {
  return file_.close();
}

Status writeTrajectory(const Trajectory& trajectory, const std::filesystem::path& path) {
  std::string text = headerText(trajectory.header);
  for (const auto& sample : trajectory.samples) {
    text += rowText(sample, trajectory.header);
  }
  return writeTextFile(path, text);
}

} // namespace dewpoint::trajectory

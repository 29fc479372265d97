// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_room.h"

#include "core/base/limits.h"

#include <array>
#include <set>

namespace dewpoint::project {
namespace {

constexpr std::array<std::pair<const char*, GridKind>, 3> kGridKeys{
    {{"floor", GridKind::Floor}, {"wall", GridKind::Wall}, {"box", GridKind::Box}}};
constexpr double kLargest = 1e4; ///< meters

ReferenceGrid readGrid(const toml::table& table, const std::string& file,
                       std::optional<Error>& error) {
  TableReader reader(table, file, "grid.");
  ReferenceGrid grid;
  std::string kind = kGridKeys.front().first;
  reader.readText("kind", kind);
  const auto known =
      std::ranges::find_if(kGridKeys, [&](const auto& entry) { return kind == entry.first; });
  if (known == kGridKeys.end()) {
    reader.fail(ErrorCode::BadValue, "kind", "floor, wall or box is expected");
  } else {
    grid.kind = known->second;
  }
  reader.readNumbers("size", grid.size.data(), 3, 0.0, kLargest);
  reader.readNumber("step", grid.step, 0.0, kLargest);
  reader.readNumbers("origin", grid.origin.data(), 3, -kLargest, kLargest);
  reader.readNumber("turn", grid.rotationAngle, -100.0, 100.0);
  error = reader.finish();
  return grid;
}

WorldBox readVolume(const toml::table& table, const std::string& file,
                    std::optional<Error>& error) {
  TableReader reader(table, file, "volume_of_interest.");
  WorldBox volume;
  reader.require("min");
  reader.readNumbers("min", volume.min.data(), 3, -kLargest, kLargest);
  reader.require("max");
  reader.readNumbers("max", volume.max.data(), 3, -kLargest, kLargest);
  error = reader.finish();
  return volume;
}

Status checkVolume(const WorldBox& volume) {
  for (const auto& [key, corner] : {std::pair("min", volume.min), std::pair("max", volume.max)}) {
    if (!corner.allFinite() || corner.cwiseAbs().maxCoeff() > kLargest) {
      return failure(ErrorCode::BadValue, "", fmt::format("volume_of_interest.{}", key),
                     fmt::format("numbers up to {} m are expected", kLargest));
    }
  }
  constexpr std::array<char, 3> kAxisNames{'x', 'y', 'z'};
  for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    if (!(volume.min[at] < volume.max[at])) {
      return failure(ErrorCode::BadValue, "", "volume_of_interest.max",
                     fmt::format("along {} it begins at {} m and ends at {} m", kAxisNames[axis],
                                 volume.min[at], volume.max[at]));
    }
  }
  return {};
}

MeasuredPoint readPoint(const toml::table& table, const std::string& file, std::size_t index,
                        std::optional<Error>& error) {
  const std::string prefix = fmt::format("point {}.", index + 1);
  TableReader reader(table, file, prefix);
  MeasuredPoint point;
  reader.require("name");
  reader.readText("name", point.name);
  reader.require("world");
  reader.readNumbers("world", point.world.data(), 3, -kLargest, kLargest);
  for (const toml::table* one : reader.findTables("click")) {
    TableReader click(*one, file, fmt::format("{}click {}.", prefix, point.clicks.size() + 1));
    int camera = 1;
    click.require("camera");
    click.readInteger("camera", camera, 1, limits::kMaxCameras);
    PointClick& read = point.clicks.emplace_back();
    read.camera = camera - 1;
    click.require("pixel");
    click.readNumbers("pixel", read.pixel.data(), 2);
    std::int64_t frame = -1;
    click.readInteger("frame", frame, 0, limits::kMaxFrames);
    if (frame >= 0) {
      read.frame = frame;
    }
    reader.recordError(click.finish());
  }
  error = reader.finish();
  return point;
}

Status checkPoint(const MeasuredPoint& point, std::size_t index, const Project& project) {
  const std::string field = fmt::format("point {}", index + 1);
  if (!point.world.allFinite() || point.world.cwiseAbs().maxCoeff() > kLargest) {
    return failure(ErrorCode::BadValue, "", field + ".world",
                   fmt::format("numbers up to {} m are expected", kLargest));
  }
  // The cameras of a scene come later, when it is opened.
  const int cameras =
      project.cameras.empty() ? int{limits::kMaxCameras} : static_cast<int>(project.cameras.size());
  const bool sceneOpen = project.scene.empty() ||
                         std::ranges::none_of(project.cameras, &ProjectCamera::hasOwnCalibration);
  std::set<int> seen;
  for (const PointClick& click : point.clicks) {
    if (click.camera < 0 || (sceneOpen && click.camera >= cameras)) {
      return failure(ErrorCode::BadValue, "", field + ".click",
                     fmt::format("there is no camera {}", click.camera + 1));
    }
    if (!seen.insert(click.camera).second) {
      return failure(ErrorCode::BadValue, "", field + ".click",
                     fmt::format("two clicks in camera {}", click.camera + 1));
    }
    if (!click.pixel.allFinite()) {
      return failure(ErrorCode::BadValue, "", field + ".click", "a pixel is not finite");
    }
  }
  return {};
}

} // namespace

void readRoom(TableReader& reader, const std::string& file, Project& project) {
  std::optional<Error> error;
  if (const toml::table* table = reader.findTable("volume_of_interest")) {
    project.volumeOfInterest = readVolume(*table, file, error);
    reader.recordError(error);
  }
  if (const toml::table* table = reader.findTable("grid")) {
    project.grid = readGrid(*table, file, error);
    reader.recordError(error);
  }
  for (const toml::table* table : reader.findTables("point")) {
    project.measuredPoints.push_back(readPoint(*table, file, project.measuredPoints.size(), error));
    reader.recordError(error);
  }
}

std::string roomText(const Project& project) {
  std::string text;
  if (project.volumeOfInterest) {
    const auto& [min, max] = *project.volumeOfInterest;
    text += fmt::format("\n[volume_of_interest]   # meters\nmin = [{}, {}, {}]\n"
                        "max = [{}, {}, {}]\n",
                        min.x(), min.y(), min.z(), max.x(), max.y(), max.z());
  }
  if (project.grid) {
    const ReferenceGrid& grid = *project.grid;
    const auto kind = std::ranges::find(kGridKeys, grid.kind, [](auto& one) { return one.second; });
    text += fmt::format("\n[grid]   # meters, radians\nkind = \"{}\"\nsize = [{}, {}, {}]\n"
                        "step = {}\norigin = [{}, {}, {}]\nturn = {}\n",
                        kind->first, grid.size.x(), grid.size.y(), grid.size.z(), grid.step,
                        grid.origin.x(), grid.origin.y(), grid.origin.z(), grid.rotationAngle);
  }
  for (const MeasuredPoint& point : project.measuredPoints) {
    text += fmt::format("\n[[point]]\nname = {}\nworld = [{}, {}, {}]\n", tomlQuoted(point.name),
                        point.world.x(), point.world.y(), point.world.z());
    for (const PointClick& click : point.clicks) {
      text += fmt::format("[[point.click]]\ncamera = {}\npixel = [{}, {}]\n", click.camera + 1,
                          click.pixel.x(), click.pixel.y());
      if (click.frame) {
        text += fmt::format("frame = {}\n", *click.frame);
      }
    }
  }
  return text;
}

Status checkRoom(const Project& project) {
  if (project.volumeOfInterest) {
    if (auto good = checkVolume(*project.volumeOfInterest); !good) {
      return good;
    }
  }
  if (project.grid) {
    if (auto good = checkGrid(*project.grid); !good) {
      return failure(good.error().code, "", "grid." + good.error().field, good.error().detail);
    }
  }
  std::set<std::string> names;
  for (std::size_t k = 0; k < project.measuredPoints.size(); ++k) {
    const MeasuredPoint& point = project.measuredPoints[k];
    if (point.name.empty() || !names.insert(point.name).second) {
      return failure(ErrorCode::BadValue, "", fmt::format("point {}.name", k + 1),
                     point.name.empty() ? "the name is empty"
                                        : "the name '" + point.name + "' is used twice");
    }
    if (auto good = checkPoint(point, k, project); !good) {
      return good;
    }
  }
  return {};
}

} // namespace dewpoint::project

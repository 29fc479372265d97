// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_people.h"

#include "core/base/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::project {
namespace {

constexpr double kFarthest = 1e4;     ///< meters from the origin
constexpr double kLargestPixel = 1e6; ///< of any image

PersonCorrection readPerson(const toml::table& table, const std::string& file, std::size_t index,
                            std::optional<Error>& error) {
  TableReader reader(table, file, fmt::format("person {}.", index + 1));
  PersonCorrection person;
  reader.require("frame");
  reader.readInteger("frame", person.frame, 0, limits::kMaxFrames);
  reader.require(reader.has("camera") ? "pixel" : "place");
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  if (reader.readNumbers("place", position.data(), 2, -kFarthest, kFarthest)) {
    person.position = position;
  }
  int camera = 1;
  PersonCorrection::Click click;
  reader.readInteger("camera", camera, 1, limits::kMaxCameras);
  if (reader.readNumbers("pixel", click.pixel.data(), 2, -kLargestPixel, kLargestPixel)) {
    click.camera = camera - 1;
    person.click = click;
  }
  reader.readBoolean("present", person.isPresent);
  error = reader.finish();
  return person;
}

Status checkPerson(const PersonCorrection& person, const std::string& field,
                   const Project& project) {
  const auto wrong = [&](const char* key, const std::string& detail) {
    return Status(failure(ErrorCode::BadValue, "", field + key, detail));
  };
  if (person.frame < 0) {
    return wrong(".frame", "frames are counted from 0");
  }
  if (person.position.has_value() == person.click.has_value()) {
    return wrong("", "expected either a position, or a camera and a pixel");
  }
  if (person.position && !(person.position->cwiseAbs().maxCoeff() <= kFarthest)) {
    return wrong(".place", fmt::format("numbers up to {} m are expected", kFarthest));
  }
  if (person.click) {
    // The cameras of a scene come later, when it is opened.
    const auto cameras = static_cast<int>(project.cameras.size());
    if (person.click->camera < 0 || (cameras > 0 && person.click->camera >= cameras)) {
      return wrong(".camera", fmt::format("the project has only {} cameras", cameras));
    }
    if (!person.click->pixel.allFinite()) {
      return wrong(".pixel", "finite numbers are expected");
    }
    if (!person.isPresent) {
      return wrong(".present", "a removed person needs a position, not a pixel");
    }
  }
  return {};
}

} // namespace

void readPeople(TableReader& reader, const std::string& file, Project& project) {
  std::optional<Error> error;
  for (const toml::table* table : reader.findTables("person")) {
    project.personCorrections.push_back(
        readPerson(*table, file, project.personCorrections.size(), error));
    reader.recordError(error);
  }
  std::ranges::stable_sort(project.personCorrections, {}, &PersonCorrection::frame);
}

std::string peopleText(const Project& project) {
  std::string text;
  for (const PersonCorrection& person : project.personCorrections) {
    text += fmt::format("\n[[person]]\nframe = {}\n", person.frame);
    if (person.position) {
      text += fmt::format("place = [{}, {}]\n", person.position->x(), person.position->y());
    }
    if (person.click) {
      text += fmt::format("camera = {}\npixel = [{}, {}]\n", person.click->camera + 1,
                          person.click->pixel.x(), person.click->pixel.y());
    }
    text += person.isPresent ? "" : "present = false\n";
  }
  return text;
}

Status checkPeople(const Project& project) {
  for (std::size_t k = 0; k < project.personCorrections.size(); ++k) {
    if (auto good =
            checkPerson(project.personCorrections[k], fmt::format("person {}", k + 1), project);
        !good) {
      return good;
    }
  }
  return {};
}

} // namespace dewpoint::project

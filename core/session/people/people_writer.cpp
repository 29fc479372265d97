// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/people/people_writer.h"

#include "core/session/people/person_shape.h"
#include "core/tracking/people/people_volume.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace dewpoint::session {
namespace {

std::string volumeRow(const PersonEstimate& person, const ConvexHull& hull, std::int64_t frame,
                      double time) {
  const auto optional = [](bool known, double value) {
    return known ? fmt::format("{}", value) : std::string();
  };
  const bool colored = person.hueAndSaturation.has_value();
  return fmt::format("{},{},{},{},{},{},{},{},{}\n", frame, time, person.identity, hull.volume(),
                     hull.vertices.size(), person.isInteracting ? 1 : 0,
                     optional(colored, colored ? person.hueAndSaturation->x() : 0.0),
                     optional(colored, colored ? person.hueAndSaturation->y() : 0.0),
                     optional(person.height > 0.0, person.height));
}

std::string hullRows(const PersonEstimate& person, const ConvexHull& hull, std::int64_t frame) {
  std::string text;
  int vertex = 0;
  for (const auto& position : hull.vertices) {
    text += fmt::format("{},{},{},{},{},{}\n", frame, person.identity, vertex++, position.x(),
                        position.y(), position.z());
  }
  return text;
}

std::string groundRows(const PersonEstimate& person, const GroundGrid& density,
                       std::int64_t frame) {
  std::string text;
  for (const double share : kGroundProbabilities) {
    int curve = 0;
    for (const LevelCurve& line : levelCurves(density, levelForProbability(density, share))) {
      int point = 0;
      for (const auto& position : line) {
        text += fmt::format("{},{},{},{},{},{:.4f},{:.4f}\n", frame, person.identity, share, curve,
                            point++, position.x(), position.y());
      }
      ++curve;
    }
  }
  return text;
}

Result<GrowingFile> table(const std::filesystem::path& path, std::string_view header) {
  auto file = GrowingFile::create(path);
  if (file) {
    if (const Status written = file->append(header); !written) {
      return tl::make_unexpected(written.error());
    }
  }
  return file;
}

} // namespace

TrajectorySample sampleOf(const PersonEstimate& person, std::int64_t frame, double time) {
  TrajectorySample sample;
  sample.time = time;
  sample.frame = frame;
  sample.target = personName(person.identity);
  sample.position = person.position;
  sample.covariance = person.covariance;
  sample.effectiveSampleSize = person.effectiveSampleSize;
  sample.cameraCount = person.seeingCameraCount;
  sample.existenceProbability = person.existenceProbability;
  return sample;
}

PeopleWriter::PeopleWriter(TrajectoryWriter trajectory, GrowingFile volumes, GrowingFile hulls,
                           GrowingFile ground)
    : trajectory_(std::move(trajectory)), volumes_(std::move(volumes)), hulls_(std::move(hulls)),
      ground_(std::move(ground)) {}

Result<PeopleWriter> PeopleWriter::create(const std::filesystem::path& folder,
                                          const TrajectoryHeader& header) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return failure(ErrorCode::FileUnwritable, folder.string(), "", problem.message());
  }
  auto trajectory = TrajectoryWriter::create(folder / "trajectory.csv", header);
  if (!trajectory) {
    return tl::make_unexpected(trajectory.error());
  }
  auto volumes =
      table(folder / "volumes.csv",
            "frame,time_s,person,volume_m3,vertices,interacting,hue,saturation,height_m\n");
  if (!volumes) {
    return tl::make_unexpected(volumes.error());
  }
  auto hulls = table(folder / "hulls.csv", "frame,person,vertex,x_m,y_m,z_m\n");
  if (!hulls) {
    return tl::make_unexpected(hulls.error());
  }
  auto ground = table(folder / "ground.csv", "frame,person,probability,curve,point,x_m,y_m\n");
  if (!ground) {
    return tl::make_unexpected(ground.error());
  }
  return PeopleWriter(std::move(*trajectory), std::move(*volumes), std::move(*hulls),
                      std::move(*ground));
}

Status PeopleWriter::writePerson(const PersonEstimate& person, const BodyCloud& body,
                                 std::int64_t frame, double time) {
  const ConvexHull hull = bodyHull(body);
  if (const auto written = trajectory_.write(sampleOf(person, frame, time)); !written) {
    return written;
  }
  if (const auto written = volumes_.append(volumeRow(person, hull, frame, time)); !written) {
    return written;
  }
  if (const auto written = hulls_.append(hullRows(person, hull, frame)); !written) {
    return written;
  }
  return ground_.append(groundRows(person, groundDensity(body), frame));
}

Status PeopleWriter::write(const PeopleFinding& people, std::int64_t frame, double time) {
  for (const PersonEstimate& person : people.people()) {
    const auto written = writePerson(person, people.bodyOf(person.identity), frame, time);
    if (!written) {
      return written;
    }
  }
  return {};
}

Status PeopleWriter::finish() {
  // All are closed, whatever is said of one of them.
  Status finished = trajectory_.finish();
  for (GrowingFile* file : {&volumes_, &hulls_, &ground_}) {
    if (const Status closed = file->close(); finished && !closed) {
      finished = closed;
    }
  }
  return finished;
}

} // namespace dewpoint::session

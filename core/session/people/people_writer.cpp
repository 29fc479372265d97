// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/people/people_writer.h"

#include "core/session/people/person_shape.h"
#include "core/tracking/people/people_volume.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace dewpoint::session {
namespace {

std::string volumeRow(const PersonEstimate& person, const ConvexHull& hull, std::int64_t frame,
                      double time) {
  const auto optional = [](bool known, double value) {
    return known ? fmt::format("{}", value) : std::string();
  };
  const bool colored = person.color.has_value();
  return fmt::format("{},{},{},{},{},{},{},{},{}\n", frame, time, person.identity, hull.volume(),
                     hull.vertices.size(), person.interacting ? 1 : 0,
                     optional(colored, colored ? person.color->x() : 0.0),
                     optional(colored, colored ? person.color->y() : 0.0),
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
  for (const double share : kGroundShares) {
    int curve = 0;
    for (const LevelCurve& line : levelCurves(density, levelHolding(density, share))) {
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

} // namespace

TrajectorySample sampleOf(const PersonEstimate& person, std::int64_t frame, double time) {
  TrajectorySample sample;
  sample.time = time;
  sample.frame = frame;
  sample.target = personName(person.identity);
  sample.position = person.position;
  sample.covariance = person.covariance;
  sample.effectiveSampleSize = person.effectiveSampleSize;
  sample.cameras = person.camerasSeeing;
  sample.existence = person.existence;
  return sample;
}

Status PeopleWriter::Table::put(const std::string& text) const {
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0) {
    return failure(ErrorCode::FileUnwritable, name, "", std::strerror(errno));
  }
  return {};
}

Result<PeopleWriter::Table> PeopleWriter::open(const std::filesystem::path& file,
                                               const std::string& columns) {
  Table table{file.string(), std::unique_ptr<std::FILE, Close>(std::fopen(file.c_str(), "w"))};
  if (!table.file) {
    return failure(ErrorCode::FileUnwritable, table.name, "", std::strerror(errno));
  }
  if (const auto written = table.put(columns + "\n"); !written) {
    return tl::make_unexpected(written.error());
  }
  return table;
}

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
  PeopleWriter writer(std::move(*trajectory));
  const std::array<std::pair<Table*, std::pair<const char*, const char*>>, 3> tables{
      {{&writer.volumes_,
        {"volumes.csv", "frame,time_s,person,volume_m3,vertices,interacting,hue,saturation,"
                        "height_m"}},
       {&writer.hulls_, {"hulls.csv", "frame,person,vertex,x_m,y_m,z_m"}},
       {&writer.ground_, {"ground.csv", "frame,person,probability,curve,point,x_m,y_m"}}}};
  for (const auto& [table, what] : tables) {
    auto opened = open(folder / what.first, what.second);
    if (!opened) {
      return tl::make_unexpected(opened.error());
    }
    *table = std::move(*opened);
  }
  return writer;
}

Status PeopleWriter::writePerson(const PersonEstimate& person, const BodyCloud& body,
                                 std::int64_t frame, double time) {
  const ConvexHull hull = bodyHull(body);
  if (const auto written = trajectory_.write(sampleOf(person, frame, time)); !written) {
    return written;
  }
  if (const auto written = volumes_.put(volumeRow(person, hull, frame, time)); !written) {
    return written;
  }
  if (const auto written = hulls_.put(hullRows(person, hull, frame)); !written) {
    return written;
  }
  return ground_.put(groundRows(person, groundDensity(body), frame));
}

Status PeopleWriter::write(const PeopleFinding& people, std::int64_t frame, double time) {
  for (const PersonEstimate& person : people.people()) {
    const auto written = writePerson(person, people.body(person.identity), frame, time);
    if (!written) {
      return written;
    }
  }
  return {};
}

Status PeopleWriter::finish() {
  return trajectory_.finish();
}

} // namespace dewpoint::session

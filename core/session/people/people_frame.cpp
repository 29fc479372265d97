// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/people/people_frame.h"

#include "core/session/people/people_writer.h"
#include "core/trajectory/trajectory_writer.h"

namespace dewpoint::session {

PeopleFramePtr peopleFrame(const TrackedFrame& trackedFrame) {
  auto frame = std::make_shared<PeopleFrame>();
  frame->frame = trackedFrame.frame;
  frame->time = trackedFrame.time;
  for (const TrackedTarget& target : trackedFrame.targets) {
    if (const auto* person = std::get_if<PersonEstimate>(&target.estimate)) {
      frame->people.push_back({*person, target.particles, target.weights});
    }
  }
  return frame;
}

Result<std::size_t> savePeople(const PeopleRecord& record, const std::filesystem::path& folder,
                               const std::function<bool(double)>& shouldContinue) {
  auto writer = PeopleWriter::create(folder, record.trajectory.header);
  if (!writer) {
    return tl::make_unexpected(writer.error());
  }
  const auto total = static_cast<double>(record.frames.size());
  std::size_t done = 0;
  for (const PeopleFramePtr& frame : record.frames) {
    if (!shouldContinue(static_cast<double>(done) / total)) {
      break;
    }
    for (const PeopleFrame::Person& person : frame->people) {
      const auto written =
          writer->writePerson(person.estimate, person.bodyCloud(), frame->frame, frame->time);
      if (!written) {
        return tl::make_unexpected(written.error());
      }
    }
    ++done;
  }
  if (const auto finished = writer->finish(); !finished) {
    return tl::make_unexpected(finished.error());
  }
  // The whole trajectory in place of that of the frames whose bodies are still known.
  return writeTrajectory(record.trajectory, folder / "trajectory.csv").map([done] { return done; });
}

} // namespace dewpoint::session

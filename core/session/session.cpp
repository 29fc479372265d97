// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session.h"

#include "core/base/text_file.h"
#include "core/session/tracking_loop.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/trajectory/trajectory_writer.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace dewpoint::session {

class Session::Impl {
public:
  explicit Impl(SessionInputs inputs) : loop(std::move(inputs)) {
    thread = std::jthread([this](const std::stop_token& stop) { loop.run(stop); });
  }
  TrackingLoop loop;
  std::jthread thread; // last: joined before the loop goes
};

Session::Session(SessionInputs inputs) : impl_(std::make_unique<Impl>(std::move(inputs))) {}
Session::~Session() = default;

void Session::onSnapshot(std::function<void()> wake) {
  impl_->loop.publisher().onSnapshot(std::move(wake));
}
TrackSnapshotPtr Session::newest() const {
  return impl_->loop.publisher().newestSnapshot();
}
LogUpdate<IterationRecord> Session::iterationsSince(std::uint64_t& generation,
                                                    std::size_t& position) const {
  return impl_->loop.log().iterationsSince(generation, position);
}
LogUpdate<FrameRecord> Session::framesSince(std::uint64_t& generation,
                                            std::size_t& position) const {
  return impl_->loop.log().framesSince(generation, position);
}
LogUpdate<TrajectorySample> Session::samplesSince(std::uint64_t& generation,
                                                  std::size_t& position) const {
  return impl_->loop.log().samplesSince(generation, position);
}
LogUpdate<BoxSample> Session::boxesSince(std::uint64_t& generation, std::size_t& position) const {
  return impl_->loop.log().boxesSince(generation, position);
}
BoxTrack Session::boxTrack() const {
  return impl_->loop.log().boxTrack();
}
OldResults Session::oldResults() const {
  return impl_->loop.log().oldResults();
}
Trajectory Session::trajectory() const {
  return impl_->loop.log().trajectory();
}
Result<std::size_t> Session::saveTrajectory(const std::filesystem::path& file) const {
  const Trajectory found = trajectory();
  return writeTrajectory(found, file).map([&] { return found.samples.size(); });
}

RunRecord Session::record() const {
  auto [project, figures] = impl_->loop.log().runReportData();
  const TrackSnapshotPtr last = newest();
  figures.droppedFrameCount = last->droppedFrameCount;
  figures.clockEstimates = last->clocks;
  const auto add = [&notices = figures.notices](std::string text) {
    if (std::ranges::find(notices, text) == notices.end()) {
      notices.push_back(std::move(text));
    }
  };
  for (const NoticePeriod& period : figures.noticeLog.periods()) {
    add(period.text);
  }
  for (const Error& notice : last->notices) {
    add(errorSentence(notice));
  }
  return {std::move(project), std::move(figures), peopleRecord(), boxTrack()};
}

std::vector<LiveFrameRecord> Session::liveFrameRecords() const {
  return impl_->loop.log().liveFrameRecords();
}

Status Session::saveRun(const std::filesystem::path& folder) const {
  return record().save(folder);
}

Status RunRecord::save(const std::filesystem::path& folder) const {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return failure(ErrorCode::FileUnwritable, folder.string(), "", problem.message());
  }
  if (const Status saved = saveTables(folder); !saved) {
    return saved;
  }
  return writeTextFile(folder / "run.json", runReport(project, statistics));
}

Status RunRecord::saveTables(const std::filesystem::path& folder) const {
  switch (methodFamily(project.method).tableKind) {
  case RunTableKind::Trajectory:
    return writeTrajectory(people.trajectory, folder / "trajectory.csv");
  case RunTableKind::Boxes:
    return writeBoxTrack(boxes, folder);
  case RunTableKind::People:
    break;
  }
  return savePeople(people, folder, [](double) { return true; }).map([](std::size_t) {});
}

PeopleRecord Session::peopleRecord() const {
  return {trajectory(), impl_->loop.log().peopleFrames()};
}

void Session::addDrawingTime(double seconds) {
  impl_->loop.addDrawingTime(seconds);
}

void Session::setFrameTap(FrameTap tap) {
  impl_->loop.frameTap().set(std::move(tap));
}

void Session::send(Command command) {
  impl_->loop.commands().push(std::move(command));
}

} // namespace dewpoint::session

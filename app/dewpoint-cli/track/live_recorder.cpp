// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/track/live_recorder.h"

#include <fmt/format.h>

#include <utility>

namespace dewpoint::app {

LiveRecorder::LiveRecorder(const Session& session, std::filesystem::path folder)
    : session_(session), folder_(std::move(folder)) {}

Status LiveRecorder::begin() {
  const std::lock_guard lock(mutex_);
  if (const Status saved = session_.saveRun(folder_); !saved) {
    return saved;
  }
  header_ = session_.trajectory().header;
  return writeAgain();
}

/// From the first sample on: at the beginning, and after a restart.
Status LiveRecorder::writeAgain() {
  auto writer = TrajectoryWriter::create(folder_ / "trajectory.csv", header_);
  if (!writer) {
    return tl::make_unexpected(writer.error());
  }
  writer_.emplace(std::move(*writer));
  generation_ = 0;
  position_ = 0;
  written_ = 0;
  return {};
}

Status LiveRecorder::writeNew() {
  auto update = session_.samplesSince(generation_, position_);
  if (update.restarted && written_ > 0) {
    if (const Status again = writeAgain(); !again) {
      return again;
    }
    update = session_.samplesSince(generation_, position_);
  }
  // The last frame comes again the next time, since its samples may still change.
  update.records.resize(position_ - update.first);
  for (const TrajectorySample& sample : update.records) {
    if (const Status done = writer_->write(sample); !done) {
      return done;
    }
    if (takeWriter_) {
      if (const Status done = takeWriter_->write(sample); !done) {
        return done;
      }
    }
  }
  written_ += update.records.size();
  return {};
}

Status LiveRecorder::update() {
  const std::lock_guard lock(mutex_);
  return writeNew();
}

Status LiveRecorder::finish() {
  const std::lock_guard lock(mutex_);
  Status done = writeNew();
  if (takeWriter_) {
    const Status closed = std::exchange(takeWriter_, std::nullopt)->finish();
    done = done ? closed : done;
  }
  // The whole again, with the last frame.
  const Status saved = session_.saveRun(folder_);
  return done ? saved : done;
}

Status LiveRecorder::startTake(const std::string& name) {
  const std::lock_guard lock(mutex_);
  if (takeWriter_) {
    return failure(ErrorCode::BadValue, "", "record", "'" + take_ + "' is being recorded");
  }
  std::error_code problem;
  const auto fileOf = [&](const std::string& take) { return folder_ / (take + ".csv"); };
  std::string take = name;
  for (int k = 1; take.empty(); ++k) {
    const std::string next = fmt::format("take-{}", k);
    take = std::filesystem::exists(fileOf(next), problem) ? "" : next;
  }
  if (std::filesystem::exists(fileOf(take), problem)) {
    return failure(ErrorCode::BadValue, "", "name", "'" + take + "' exists already");
  }
  // What was tracked before belongs to no take.
  if (const Status done = writeNew(); !done) {
    return done;
  }
  auto writer = TrajectoryWriter::create(fileOf(take), header_);
  if (!writer) {
    return tl::make_unexpected(writer.error());
  }
  takeWriter_.emplace(std::move(*writer));
  take_ = take;
  return {};
}

Status LiveRecorder::stopTake() {
  const std::lock_guard lock(mutex_);
  if (!takeWriter_) {
    return failure(ErrorCode::BadValue, "", "stop-recording", "nothing is being recorded");
  }
  const Status done = writeNew();
  const Status closed = std::exchange(takeWriter_, std::nullopt)->finish();
  take_.clear();
  return done ? closed : done;
}

std::string LiveRecorder::takeName() const {
  const std::lock_guard lock(mutex_);
  return take_;
}

} // namespace dewpoint::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/broadcaster.h"

#include "core/broadcast/transport/datagram_sender.h"
#include "core/broadcast/transport/line_file.h"
#include "core/broadcast/transport/line_server.h"
#include "core/broadcast/transport/web_server.h"
#include "core/project/project_output.h"
#include "core/project/project_paths.h"

#include <map>
#include <string>
#include <utility>

namespace dewpoint::broadcast {
namespace {

/// The same error, with the key of the project file that it is about.
tl::unexpected<Error> about(const char* key, Error error) {
  error.field = key;
  return tl::make_unexpected(std::move(error));
}

Result<std::string> tokenOf(const OutputSettings& settings) {
  auto token = expandVariables(settings.token);
  if (!token) {
    return about("output.token", token.error());
  }
  OutputSettings expanded;
  expanded.token = *token;
  if (!settings.token.empty() && token->empty()) {
    return failure(ErrorCode::BadValue, "", "output.token", "it is empty");
  }
  if (const auto good = checkOutput(expanded); !good) {
    return tl::make_unexpected(good.error());
  }
  return token;
}

} // namespace

Result<std::unique_ptr<Broadcaster>> Broadcaster::open(const BroadcastInputs& inputs) {
  const OutputSettings& settings = inputs.settings;
  if (const auto good = checkOutput(settings); !good) {
    return tl::make_unexpected(good.error());
  }
  const auto token = tokenOf(settings);
  if (!token) {
    return tl::make_unexpected(token.error());
  }
  const auto gate = std::make_shared<RemoteCommandFilter>(*token, inputs.receiver);
  std::vector<Line> lines;
  WebServer* web = nullptr;
  std::optional<Error> problem;
  const auto add = [&](const char* key, const StreamFormat& format, auto outlet) {
    if (outlet) {
      lines.push_back({&format, std::move(*outlet)});
    } else if (!problem) {
      problem = about(key, outlet.error()).value();
    }
  };
  if (settings.tcpPort) {
    add("output.tcp", jsonLinesFormat(),
        LineServer::open(settings.listenAddress, *settings.tcpPort, gate));
  }
  if (settings.webSocketPort) {
    auto server =
        WebServer::open(settings.listenAddress, *settings.webSocketPort, gate, inputs.texts);
    web = server ? server->get() : nullptr;
    add("output.websocket", jsonLinesFormat(), std::move(server));
  }
  if (!settings.oscReceiver.empty()) {
    add("output.osc", oscMessagesFormat(),
        DatagramSender::open(settings.oscReceiver, OutletKind::OscMessages));
  }
  if (!settings.tuioReceiver.empty()) {
    add("output.tuio", tuioCursorsFormat(),
        DatagramSender::open(settings.tuioReceiver, OutletKind::TuioCursors));
  }
  if (!settings.csvFile.empty()) {
    const std::filesystem::path file = settings.csvFile;
    add("output.csv", csvRowsFormat(), LineFile::open(file == "-" ? file : inputs.folder / file));
  }
  if (problem) {
    return tl::make_unexpected(std::move(*problem));
  }
  return std::unique_ptr<Broadcaster>(new Broadcaster(inputs, std::move(lines), web));
}

Broadcaster::Broadcaster(const BroadcastInputs& inputs, std::vector<Line> lines, WebServer* web)
    : coordinates_{inputs.settings.axes, inputs.settings.unit}, volume_(inputs.volume),
      lines_(std::move(lines)), web_(web), limit_(inputs.settings.framesPerSecond),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

Broadcaster::~Broadcaster() = default;

void Broadcaster::enqueue(TrackSnapshotPtr snapshot) {
  if (!snapshot || !snapshot->rig || !snapshot->frames || !snapshot->isTracked ||
      snapshot->isPast) {
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    if (queue_.size() >= kQueueLength) {
      queue_.pop_front();
      ++dropped_;
    }
    queue_.push_back(std::move(snapshot));
  }
  arrived_.notify_one();
}

void Broadcaster::setPageTexts(const PageTexts& texts) {
  if (web_ != nullptr) {
    web_->setPageTexts(texts);
  }
}

void Broadcaster::run(const std::stop_token& stop) {
  while (true) {
    TrackSnapshotPtr snapshot;
    {
      std::unique_lock lock(mutex_);
      if (!arrived_.wait(lock, stop, [this] { return !queue_.empty(); })) {
        return;
      }
      snapshot = std::move(queue_.front());
      queue_.pop_front();
    }
    // Published again after a change of the view: nothing new was tracked.
    const bool isKnown = snapshot->frame == frame_ && snapshot->iterationCount == iterations_;
    frame_ = snapshot->frame;
    iterations_ = snapshot->iterationCount;
    if (!isKnown) {
      send(*snapshot);
    }
  }
}

void Broadcaster::updateRig(const TrackSnapshot& snapshot) {
  if (seenRig_ == snapshot.rig) {
    return;
  }
  seenRig_ = snapshot.rig;
  auto now = std::make_shared<const RigMessage>(rigMessageOf(snapshot, coordinates_, volume_));
  if (rig_ && *rig_ == *now) {
    return;
  }
  rig_ = std::move(now);
  for (Line& line : lines_) {
    if (auto* const outlet = dynamic_cast<PreambleOutlet*>(line.outlet.get())) {
      outlet->setPreamble(line.format->preamble(*rig_));
    }
  }
}

void Broadcaster::send(const TrackSnapshot& snapshot) {
  recent_.add(snapshot);
  updateRig(snapshot);
  if (!limit_.isDue(RateLimit::Clock::now())) {
    return;
  }
  FrameMessage message = frameMessageOf(snapshot, recent_, rig_);
  message.sequenceNumber = ++sent_;
  std::map<const StreamFormat*, std::vector<std::string>> encoded; // each format once
  for (Line& line : lines_) {
    auto [found, isNew] = encoded.try_emplace(line.format);
    if (isNew) {
      found->second = line.format->encode(message);
    }
    line.outlet->send(found->second);
  }
}

std::vector<OutletReport> Broadcaster::reports() const {
  std::vector<OutletReport> reports;
  reports.reserve(lines_.size());
  for (const Line& line : lines_) {
    reports.push_back(line.outlet->report());
  }
  return reports;
}

} // namespace dewpoint::broadcast

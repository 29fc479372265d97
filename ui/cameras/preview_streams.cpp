// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/preview_streams.h"

#include "core/setup/new_project/live_preview.h"
#include "ui/style/image.h"
#include "ui/text/error_sentence.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace dewpoint::ui {

namespace {

/// Seconds between two images. Chosen: a hand before the camera is seen at once, and the previews
/// of several cameras leave the processor to the tracking.
constexpr double kBetweenImages = 0.3;
constexpr std::chrono::seconds kBetweenAttempts(2);

/// Waits before the next attempt; ends at once when it is not wanted any more.
void waitForNextAttempt(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any stopped;
  std::unique_lock lock(mutex);
  stopped.wait_for(lock, stop, kBetweenAttempts, [] { return false; });
}

} // namespace

PreviewStreams::PreviewStreams(QObject* parent) : QObject(parent) {}

PreviewStreams::~PreviewStreams() {
  for (auto& [location, stream] : streams_) {
    stream.stopSource.request_stop();
  }
}

void PreviewStreams::setLocations(const QSet<QString>& locations) {
  std::erase_if(streams_, [&](auto& one) {
    if (locations.contains(one.first)) {
      return false;
    }
    one.second.stopSource.request_stop();
    return true;
  });
  for (const QString& location : locations) {
    if (!streams_.contains(location)) {
      open(location);
    }
  }
}

const PreviewState* PreviewStreams::previewState(const QString& location) const {
  const auto found = streams_.find(location);
  return found == streams_.end() ? nullptr : &found->second.state;
}

void PreviewStreams::open(const QString& location) {
  const std::stop_source source = streams_[location].stopSource;
  const auto deliver = [this, location, mailbox = mailbox_.sender(), source](PreviewState state) {
    mailbox.post([this, location, source, state = std::move(state)] {
      const auto found = streams_.find(location);
      if (found != streams_.end() && found->second.stopSource == source) { // not closed meanwhile
        found->second.state = state;
        Q_EMIT changed(location);
      }
    });
  };
  runDetached([location, deliver, stop = source.get_token()] {
    capture::LiveCamera camera;
    camera.location = location.toStdString();
    while (!stop.stop_requested()) {
      const auto watched = previewLive(camera, kBetweenImages, [&](const LivePreview& preview) {
        if (!preview.image.empty()) {
          deliver({toQImage(preview.image),
                   QSize(preview.size.width, preview.size.height),
                   preview.framesPerSecond,
                   {}});
        }
        return !stop.stop_requested();
      });
      if (!watched) {
        Error reason = watched.error();
        reason.file.clear(); // it stands beside it
        deliver({{}, {}, 0.0, errorText(reason)});
      }
      waitForNextAttempt(stop);
    }
  });
}

} // namespace dewpoint::ui

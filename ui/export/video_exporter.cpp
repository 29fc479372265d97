// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/video_exporter.h"

#include "ui/text/error_sentence.h"

#include <system_error>
#include <utility>

namespace dewpoint::ui {

namespace {

/// Frames that are fetched ahead of the encoder; each may be large.
constexpr int kMaxWaitingFrameSets = 3;

cv::Mat colorsOfPicture(QImage& image) {
  // RGB32 lies in memory as blue, green, red, unused on the machines we support (toQImage()).
  return cv::Mat(image.height(), image.width(), CV_8UC4, image.bits(),
                 static_cast<std::size_t>(image.bytesPerLine()));
}

} // namespace

VideoExporter::VideoExporter(QObject* parent) : QObject(parent), drawer_(new VideoDrawer(this)) {
  connect(drawer_, &VideoDrawer::ready, this, &VideoExporter::requestNext);
}

VideoExporter::~VideoExporter() {
  if (state_) {
    state_->isCanceled = true;
    drawer_->enqueue([state = std::move(state_)]() -> std::function<void()> {
      state->encoder.reset(); // in that thread: to end an encoder takes a while
      return {};
    });
  }
}

void VideoExporter::start(VideoRequest request, Session* session, const BirdsEyeView* scene) {
  if (isRunning()) {
    return;
  }
  state_ = std::make_shared<State>();
  state_->request = std::move(request);
  next_ = written_ = 0;
  waiting_ = 0;
  closing_ = false;
  drawer_->beginVideo(session, state_->request.layout, scene);
  open();
}

void VideoExporter::open() {
  drawer_->enqueue([this, state = state_]() -> std::function<void()> {
    const VideoRequest& request = state->request;
    std::error_code ignored;
    if (!request.replacesFile && std::filesystem::exists(request.file, ignored)) {
      return [this, state] {
        if (state_ == state) {
          state_.reset();
          drawer_->stop();
          Q_EMIT fileExists(QString::fromStdString(state->request.file.string()));
        }
      };
    }
    VideoOutput output;
    output.file = request.file;
    output.encoding = request.encoding;
    output.framesPerSecond = request.framesPerSecond;
    output.width = request.layout->size.width();
    output.height = request.layout->size.height();
    if (auto encoder = VideoEncoder::create(output)) {
      state->encoder.emplace(std::move(*encoder));
    } else {
      state->error = encoder.error();
      state->isCanceled = true;
    }
    return [this, state] {
      if (state_ == state) {
        requestNext();
      }
    };
  });
}

void VideoExporter::requestNext() {
  if (!state_ || closing_) {
    return;
  }
  const std::vector<std::int64_t>& frames = state_->request.frames;
  if (state_->isCanceled || next_ == frames.size()) {
    if (waiting_ == 0) {
      close();
    }
    return;
  }
  if (!drawer_->isReady() || waiting_ >= kMaxWaitingFrameSets) {
    return; // comes back
  }
  const std::int64_t frame = frames[next_];
  std::size_t repeats = 0;
  for (; next_ < frames.size() && frames[next_] == frame; ++next_) {
    ++repeats;
  }
  ++waiting_;
  const auto consume = [this, state = state_,
                        repeats](Result<QImage> image) -> std::function<void()> {
    if (!image) {
      state->error = state->isCanceled ? state->error : image.error();
      state->isCanceled = true;
    }
    for (std::size_t k = 0; k < repeats && !state->isCanceled; ++k) {
      if (const Status written = state->encoder->write(colorsOfPicture(*image)); !written) {
        state->error = written.error();
        state->isCanceled = true;
      }
    }
    return [this, state, repeats] { count(state, repeats); };
  };
  drawer_->draw(frame, consume, [state = state_] { return !state->isCanceled; });
}

void VideoExporter::count(const StatePtr& state, std::size_t images) {
  if (state_ != state) {
    return;
  }
  --waiting_;
  written_ += images;
  Q_EMIT progressChanged(static_cast<int>(100 * written_ / state->request.frames.size()));
  requestNext();
}

void VideoExporter::close() {
  closing_ = true;
  drawer_->enqueue([this, state = state_]() -> std::function<void()> {
    Status closed;
    if (state->isCanceled) {
      state->encoder.reset(); // its file goes with it
    } else {
      closed = state->encoder->finish();
      state->encoder.reset();
    }
    return [this, state, closed] { end(state, closed); };
  });
}

void VideoExporter::end(const StatePtr& state, const Status& closed) {
  if (state_ != state) {
    return;
  }
  state_.reset();
  drawer_->stop();
  if (state->error) {
    Q_EMIT failed(errorText(*state->error));
  } else if (state->isCanceled) {
    Q_EMIT canceled();
  } else if (!closed) {
    Q_EMIT failed(errorText(closed.error()));
  } else {
    Q_EMIT finished(QString::fromStdString(state->request.file.string()));
  }
}

void VideoExporter::cancel() {
  if (state_) {
    state_->isCanceled = true;
    requestNext(); // or nobody would close it while nothing is under way
  }
}

void VideoExporter::abandon(const QString& sentence) {
  if (!state_) {
    return;
  }
  state_->isCanceled = true;
  drawer_->stop();
  drawer_->enqueue([state = std::exchange(state_, nullptr)]() -> std::function<void()> {
    state->encoder.reset();
    return {};
  });
  Q_EMIT failed(sentence);
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/open_live.h"

#include "core/capture/devices/device_stream.h"
#include "core/capture/gstreamer/gst_image.h"
#include "core/capture/gstreamer/gst_library.h"
#include "core/capture/gstreamer/gst_stream.h"
#include "core/capture/gstreamer/pipeline_text.h"
#include "core/capture/live_frame_source.h"

#include <algorithm>
#include <gst/gst.h>
#include <utility>

namespace dewpoint::capture {
namespace {

/// A connection through FFmpeg that passes on its decoded images, too.
class FedVideoStream final : public LiveStream {
public:
  FedVideoStream(LiveStreamPtr stream, EncodedFeedPtr feed)
      : stream_(std::move(stream)), feed_(std::move(feed)) {}

  tl::expected<void, std::string> open() override { return stream_->open(); }
  bool grab() override {
    const bool grabbed = stream_->grab();
    captured_ = {std::chrono::steady_clock::now(), TimeOrigin::Arrival};
    if (!grabbed) {
      feed_->markEnded();
    }
    return grabbed;
  }
  cv::Mat retrieve() override {
    cv::Mat image = stream_->retrieve();
    if (image.type() == CV_8UC3 && !image.empty()) {
      feed_->put({std::shared_ptr<GstSample>(sampleOf(image), gst_sample_unref), captured_});
    }
    return image;
  }
  std::optional<CaptureInstant> captureTime() const override { return captured_; }

private:
  LiveStreamPtr stream_;
  EncodedFeedPtr feed_;
  CaptureInstant captured_;
};

bool isAddress(const LiveCamera& camera) {
  return !camera.location.starts_with("gst:") && camera.location.find("://") != std::string::npos;
}

/// Whether an address needs an element that this computer does not have.
bool isForFfmpeg(const LiveCamera& camera, const PipelineText& pipeline) {
  return isAddress(camera) && !std::ranges::all_of(pipeline.elements, hasGstElement);
}

LiveStreamPtr makeFfmpegStream(const LiveCamera& camera, EncodedFeedPtr feed) {
  LiveStreamPtr stream = makeVideoStream(camera);
  // The feed passes samples of GStreamer.
  return feed && startGStreamer()
             ? std::make_unique<FedVideoStream>(std::move(stream), std::move(feed))
             : std::move(stream);
}

/// The connection to a location that does not change.
LiveStreamPtr makeLocatedStream(const LiveCamera& camera, EncodedFeedPtr feed) {
  if (!isOnlyForFfmpeg(camera.location)) {
    auto pipeline = pipelineText(camera);
    if (pipeline && !isForFfmpeg(camera, *pipeline)) {
      return std::make_unique<GstStream>(std::move(*pipeline), std::move(feed));
    }
  }
  return makeFfmpegStream(camera, std::move(feed));
}

/// `lookup` is that of the camera.
LiveStreamPtr makeFoundStream(const LiveCamera& camera, EncodedFeedPtr feed, DeviceLookup lookup) {
  if (camera.device == DeviceSettings{}) {
    return makeLocatedStream(camera, std::move(feed));
  }
  return makeDeviceStream(
      camera, std::move(lookup),
      [feed = std::move(feed)](const LiveCamera& found) { return makeLocatedStream(found, feed); });
}

std::vector<DeviceIdentity> identitiesOf(const std::vector<LiveCamera>& cameras) {
  std::vector<DeviceIdentity> identities;
  identities.reserve(cameras.size());
  for (const LiveCamera& camera : cameras) {
    identities.push_back(camera.device.identity);
  }
  return identities;
}

} // namespace

Status checkLocation(const LiveCamera& camera) {
  return isOnlyForFfmpeg(camera.location) ? Status()
                                          : pipelineText(camera).map([](const PipelineText&) {});
}

LiveStreamPtr makeLiveStream(const LiveCamera& camera, EncodedFeedPtr feed) {
  return makeFoundStream(camera, std::move(feed), {systemDevices(), {camera.device.identity}, 0});
}

Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras) {
  return openLive(cameras, std::vector<EncodedFeedPtr>(cameras.size()));
}

Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras,
                                                 const std::vector<EncodedFeedPtr>& feeds,
                                                 DeviceAccessPtr devices) {
  for (const LiveCamera& camera : cameras) {
    if (auto known = checkLocation(camera); !known) {
      return tl::make_unexpected(known.error());
    }
  }
  // Each connection's thread asks with a copy of its camera; names are different in a rig.
  const LiveStreamFactory factory = [cameras, feeds, identities = identitiesOf(cameras),
                                     devices = std::move(devices)](const LiveCamera& camera) {
    const auto found = std::ranges::find(cameras, camera.name, &LiveCamera::name);
    const auto index = static_cast<std::size_t>(found - cameras.begin());
    return makeFoundStream(camera, index < feeds.size() ? feeds[index] : nullptr,
                           {devices, identities, index});
  };
  return openLive(cameras, factory);
}

} // namespace dewpoint::capture

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/pipeline_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dewpoint::tests {
namespace {

LiveCamera cameraAt(const std::string& location) {
  LiveCamera camera;
  camera.name = "left";
  camera.location = location;
  return camera;
}

PipelineText pipelineAt(const std::string& location) {
  const auto pipeline = pipelineText(cameraAt(location));
  EXPECT_TRUE(pipeline) << location << ": " << errorSentence(pipeline.error());
  return pipeline.value_or(PipelineText{});
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(PipelineText, KnowsDevices) {
  for (const auto& [location, device] : std::vector<std::pair<std::string, std::string>>{
           {"2", "/dev/video2"},
           {"/dev/video11", "/dev/video11"},
           {"/dev/v4l/by-id/usb-A_B-video-index0", "/dev/v4l/by-id/usb-A_B-video-index0"},
           {"/dev/v4l/by-path/pci-0:1.0-video-index0",
            "/dev/v4l/by-path/pci-0:1.0-video-index0"}}) {
    const PipelineText pipeline = pipelineAt(location);
    EXPECT_EQ(pipeline.devicePath, device);
    EXPECT_TRUE(has(pipeline.text, "v4l2src device=\"" + device + "\"")) << pipeline.text;
    EXPECT_EQ(pipeline.origin, TimeOrigin::Driver);
    EXPECT_FALSE(pipeline.hasOwnSink);
    EXPECT_FALSE(has(pipeline.text, "width=")) << pipeline.text;
  }
}

TEST(PipelineText, RequestsTheSizeBeforeTheRotation) {
  LiveCamera camera = cameraAt("0");
  camera.width = 480;
  camera.height = 640;
  camera.rotateDegrees = 90;
  const auto pipeline = pipelineText(camera);
  ASSERT_TRUE(pipeline);
  EXPECT_TRUE(has(pipeline->text, "image/jpeg,width=640,height=480")) << pipeline->text;
  EXPECT_TRUE(has(pipeline->text, "video/x-raw,width=640,height=480")) << pipeline->text;
}

TEST(PipelineText, RequestsTheSizeBeforeCropping) {
  LiveCamera camera = cameraAt("0");
  camera.width = 400;
  camera.height = 600;
  camera.rotateDegrees = 90;
  camera.crop = {50, 10, 30, 30}; // of images of 480 x 640, after the rotation
  const auto pipeline = pipelineText(camera);
  ASSERT_TRUE(pipeline);
  EXPECT_TRUE(has(pipeline->text, "image/jpeg,width=640,height=480")) << pipeline->text;
}

TEST(PipelineText, RequestsTheFormatOfTheDevice) {
  LiveCamera camera = cameraAt("0");
  camera.width = 480; // of the calibration
  camera.height = 640;
  camera.device.format = {"YUYV", 1280, 720, 30000.0 / 1001.0};
  const auto raw = pipelineText(camera);
  ASSERT_TRUE(raw);
  EXPECT_TRUE(has(raw->text, "capsfilter caps=\"video/x-raw,format=YUY2,width=1280,height=720,"
                             "framerate=30000/1001;video/x-raw,format=YUY2,width=1280,height=720,"
                             "framerate=[29670/1000,30270/1000]\""))
      << raw->text;
  camera.device.format = {"MJPG", 0, 0, 7.5};
  const auto jpeg = pipelineText(camera);
  ASSERT_TRUE(jpeg);
  EXPECT_TRUE(has(jpeg->text, "image/jpeg,width=480,height=640,framerate=15/2;")) << jpeg->text;
  EXPECT_FALSE(has(jpeg->text, "video/x-raw,width"));
  camera.device.format = {"", 320, 240, 0.0};
  const auto any = pipelineText(camera);
  ASSERT_TRUE(any);
  EXPECT_TRUE(has(any->text, "image/jpeg,width=320,height=240;video/x-raw,width=320,height=240"))
      << any->text;
  camera.device.format = {"H264", 0, 0, 0.0};
  EXPECT_TRUE(has(pipelineText(camera)->text, "max-size-buffers=30")); // images need each other
  camera.device.format = {"XYZ1", 0, 0, 0.0};
  const auto unknown = pipelineText(camera);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::BadValue);
  EXPECT_EQ(unknown.error().field, "camera 'left'");
  EXPECT_TRUE(has(unknown.error().detail, "'XYZ1'"));
}

TEST(PipelineText, KnowsAddresses) {
  const PipelineText http = pipelineAt("http://anna:s\"cret@host:80/v");
  EXPECT_TRUE(has(http.text, "souphttpsrc location=\"http://host:80/v\"")) << http.text;
  EXPECT_TRUE(has(http.text, "user-id=\"anna\" user-pw=\"s\\\"cret\"")) << http.text;
  EXPECT_EQ(http.origin, TimeOrigin::Arrival);
  EXPECT_NE(std::ranges::find(http.elements, "souphttpsrc"), http.elements.end());

  const PipelineText rtsp = pipelineAt("rtsp://host/a b");
  EXPECT_TRUE(has(rtsp.text, "rtspsrc location=\"rtsp://host/a b\"")) << rtsp.text;
  EXPECT_EQ(rtsp.origin, TimeOrigin::Sender);
  EXPECT_TRUE(has(pipelineAt("srt://host:9000?mode=caller").text,
                  "srtsrc uri=\"srt://host:9000?mode=caller\""));
  EXPECT_TRUE(
      has(pipelineAt("udp://239.1.1.1:5600").text, "udpsrc address=\"239.1.1.1\" port=5600"));
}

TEST(PipelineText, KnowsPayloadsOfRtp) {
  EXPECT_TRUE(has(pipelineAt("rtp://0.0.0.0:5600").text, "encoding-name=MP2T,payload=33"));
  EXPECT_TRUE(has(pipelineAt("rtp://:5600?encoding=JPEG").text, "! rtpjpegdepay ! parsebin"));
  EXPECT_TRUE(has(pipelineAt("rtp://:5600?encoding=H264&payload=97").text, "payload=97"));
  for (const char* wrong : {"rtp://:5600?encoding=theora", "rtp://:5600?payload=x", "rtp://host"}) {
    const auto pipeline = pipelineText(cameraAt(wrong));
    ASSERT_FALSE(pipeline) << wrong;
    EXPECT_EQ(pipeline.error().code, ErrorCode::BadValue);
  }
}

TEST(PipelineText, KeepsTheUsersPipeline) {
  const PipelineText own = pipelineAt("gst:videotestsrc ! videoconvert ! appsink drop=true");
  EXPECT_TRUE(own.hasOwnSink);
  EXPECT_EQ(own.text, "videotestsrc ! videoconvert ! appsink drop=true");
  const PipelineText open = pipelineAt("gst:videotestsrc name=\"a ! appsink\" ! jpegenc");
  EXPECT_FALSE(open.hasOwnSink); // the sink is in a name
  EXPECT_TRUE(open.text.starts_with("videotestsrc name=\"a ! appsink\" ! jpegenc ! parsebin"))
      << open.text;
  EXPECT_EQ(pipelineAt("gst:udpsrc port=1 ! rtpjitterbuffer ! rtpjpegdepay").origin,
            TimeOrigin::Sender);
  EXPECT_EQ(pipelineAt("gst:udpsrc port=1 ! tsdemux ! appsink").origin, TimeOrigin::Arrival);
}

TEST(PipelineText, KnowsTestPatterns) {
  EXPECT_TRUE(has(pipelineAt("test:").text, "pattern=smpte ! video/x-raw,format=I420,width=640,"
                                            "height=480,framerate=30/1"));
  const PipelineText ball =
      pipelineAt("test:ball?width=320&height=240&rate=15&encoding=mjpeg&frames=9");
  EXPECT_TRUE(has(ball.text, "pattern=ball num-buffers=9")) << ball.text;
  EXPECT_TRUE(has(ball.text, "width=320,height=240,framerate=15/1 ! jpegenc !")) << ball.text;
  EXPECT_TRUE(ball.isFinite);
  for (const char* wrong : {"test:ball ! filesink location=/tmp/x", "test:ball?size=3",
                            "test:ball?width=0", "test:ball?rate=fast", "test:ball?encoding=gif"}) {
    EXPECT_FALSE(pipelineText(cameraAt(wrong))) << wrong;
  }
}

TEST(PipelineText, RefusesOtherLocationsWithoutTheirPassword) {
  for (const char* wrong : {"", "gst:", "gst:  ", "video.mp4", "-1", "/dev/", "/dev/videoX",
                            "ftp://u:s3cret@host/a", "udp://u:s3cret@host"}) {
    const auto pipeline = pipelineText(cameraAt(wrong));
    ASSERT_FALSE(pipeline) << wrong;
    EXPECT_EQ(pipeline.error().code, ErrorCode::BadValue);
    EXPECT_EQ(pipeline.error().field, "camera 'left'");
    EXPECT_FALSE(has(errorSentence(pipeline.error()), "s3cret"));
  }
}

TEST(PipelineText, StoresEncodedImagesUnchanged) {
  const std::string jpeg = recordingPipelineText("image/jpeg", false, "/a \"b\".mkv");
  EXPECT_FALSE(has(jpeg, "jpegenc"));
  EXPECT_TRUE(has(jpeg, "location=\"/a \\\"b\\\".mkv\"")) << jpeg;
  EXPECT_TRUE(has(recordingPipelineText("video/x-h264", false, "a"), "h264parse"));
  EXPECT_TRUE(has(recordingPipelineText("video/x-raw", false, "a"), "jpegenc quality=95"));
  EXPECT_FALSE(has(recordingPipelineText("video/x-raw", true, "a"), "jpegenc"));
}

} // namespace
} // namespace dewpoint::tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/pipeline_text.h"

#include "core/base/text_number.h"
#include "core/capture/gstreamer/address_parts.h"
#include "core/capture/gstreamer/device_caps.h"
#include "core/capture/gstreamer/test_patterns.h"
#include "core/capture/image_shape.h"
#include "core/capture/redacted_location.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

namespace dewpoint::capture {
namespace {

constexpr std::string_view kPipelinePrefix = "gst:";
constexpr std::string_view kTestPrefix = "test:";
// Judgments.
constexpr int kJitterMilliseconds = 100;  ///< how long a late packet is waited for
constexpr int kNetworkTimeoutSeconds = 2; ///< after which a silent connection is given up
constexpr int kJpegQuality = 95;          ///< of raw images in a recording
constexpr int kLargestTestSide = 8192;    ///< pixels
constexpr int kLargestTestRate = 1000;    ///< images per second
constexpr int kMostTestFrames = 1'000'000'000;
/// Formats that a Matroska file can contain uncompressed, and that FFmpeg reads from it.
constexpr std::array<std::string_view, 6> kLosslessFormats{"YUY2",  "I420", "UYVY",
                                                           "GRAY8", "BGR",  "RGB"};
/// Images that may wait for the decoder: few where each stands for itself, so that old ones are
/// dropped at once; more where an image that is missing damages those after it.
constexpr int kWaitingIntraImages = 2;
constexpr int kWaitingInterImages = 30;

/// A value in the text of a pipeline.
std::string quotedValue(std::string_view value) {
  std::string text = "\"";
  for (const char letter : value) {
    if (letter == '"' || letter == '\\') {
      text += '\\';
    }
    text += letter;
  }
  return text + '"';
}

tl::unexpected<Error> badLocation(const LiveCamera& camera, std::string detail) {
  return failure(ErrorCode::BadValue, redactedLocation(camera.location),
                 quotedCameraName(camera.name), std::move(detail));
}

/// What follows the source in every pipeline but the user's own with a sink. Audio and other
/// streams do not pass the filter.
std::string branches(int waitingImages) {
  return fmt::format(
      " ! parsebin ! capsfilter caps=\"image/jpeg;image/png;video/x-raw;video/x-h264;video/x-h265;"
      "video/x-vp8;video/x-vp9;video/x-av1;video/mpeg,systemstream=false;video/x-theora;"
      "video/x-bayer\" ! tee name=dewpoint_tee"
      " dewpoint_tee. ! queue leaky=downstream max-size-buffers={} max-size-bytes=0 max-size-time=0"
      " ! decodebin ! videoconvert ! video/x-raw,format=BGR ! appsink name={} sync=false drop=true"
      " max-buffers=8"
      " dewpoint_tee. ! queue max-size-buffers=0 max-size-bytes=0 max-size-time=2000000000"
      " leaky=downstream ! appsink name={} sync=false",
      waitingImages, kImageSinkName, kEncodedSinkName);
}

PipelineText made(const std::string& source, TimeOrigin origin, int waitingImages,
                  std::vector<std::string> elements) {
  PipelineText pipeline;
  pipeline.text = source + branches(waitingImages);
  pipeline.origin = origin;
  pipeline.elements = std::move(elements);
  for (const char* needed : {"parsebin", "decodebin", "videoconvert", "appsink"}) {
    pipeline.elements.emplace_back(needed);
  }
  return pipeline;
}

/// Path of a V4L2 device; nothing if the location is none.
std::optional<std::string> devicePath(std::string_view location) {
  constexpr std::string_view kDeviceFolder = "/dev/";
  constexpr std::string_view kNumbered = "/dev/video";
  if (const auto number = toNumber<int>(location); number && *number >= 0) {
    return std::string(kNumbered) + std::to_string(*number);
  }
  if (location.starts_with(kNumbered)) {
    const auto number = toNumber<int>(location.substr(kNumbered.size()));
    return number && *number >= 0 ? std::optional(std::string(location)) : std::nullopt;
  }
  return location.starts_with(kDeviceFolder) && location.size() > kDeviceFolder.size()
             ? std::optional(std::string(location))
             : std::nullopt;
}

Result<PipelineText> devicePipeline(const LiveCamera& camera, const std::string& path) {
  const std::string& pixelFormat = camera.device.format.pixelFormat;
  const auto caps = deviceCaps(camera);
  if (!caps) {
    return badLocation(camera, fmt::format("the pixel format '{}' is not supported", pixelFormat));
  }
  PipelineText pipeline =
      made(fmt::format("v4l2src device={} ! capsfilter caps=\"{}\"", quotedValue(path), *caps),
           TimeOrigin::Driver,
           isInterCoded(pixelFormat) ? kWaitingInterImages : kWaitingIntraImages, {"v4l2src"});
  pipeline.devicePath = path;
  return pipeline;
}

PipelineText httpPipeline(const ParsedAddress& address) {
  std::string source = fmt::format("souphttpsrc location={} is-live=true do-timestamp=true "
                                   "timeout={} retries=0 iradio-mode=false",
                                   quotedValue(address.withoutUser()), kNetworkTimeoutSeconds);
  if (!address.user.empty()) {
    source += fmt::format(" user-id={} user-pw={}", quotedValue(address.user),
                          quotedValue(address.password));
  }
  return made(source, TimeOrigin::Arrival, kWaitingIntraImages, {"souphttpsrc"});
}

PipelineText rtspPipeline(const std::string& location) {
  return made(fmt::format("rtspsrc location={} latency={} timeout={} tcp-timeout={}",
                          quotedValue(location), kJitterMilliseconds,
                          kNetworkTimeoutSeconds * 1000000, kNetworkTimeoutSeconds * 1000000),
              TimeOrigin::Sender, kWaitingInterImages, {"rtspsrc"});
}

struct RtpPayload {
  const char* encoding;
  int payload;
  const char* depayloader;
  int waitingImages;
};

constexpr std::array<RtpPayload, 4> kRtpPayloads{{
    {"MP2T", 33, "rtpmp2tdepay", kWaitingInterImages},
    {"JPEG", 26, "rtpjpegdepay", kWaitingIntraImages},
    {"H264", 96, "rtph264depay", kWaitingInterImages},
    {"H265", 96, "rtph265depay", kWaitingInterImages},
}};

std::string udpSource(const ParsedAddress& address) {
  return fmt::format("udpsrc address={} port={} buffer-size=4194304",
                     quotedValue(address.host.empty() ? "0.0.0.0" : address.host),
                     address.port.value_or(0));
}

Result<PipelineText> rtpPipeline(const LiveCamera& camera, const ParsedAddress& address) {
  const std::string encoding = address.option("encoding").value_or("MP2T");
  const auto* const payload = std::ranges::find_if(
      kRtpPayloads, [&](const RtpPayload& one) { return encoding == one.encoding; });
  if (payload == kRtpPayloads.end()) {
    return badLocation(camera, "the option encoding is JPEG, H264, H265 or MP2T");
  }
  const auto number =
      toNumber<int>(address.option("payload").value_or(std::to_string(payload->payload)));
  if (!number || *number < 0 || *number > 127) {
    return badLocation(camera, "the option payload is a number from 0 to 127");
  }
  return made(fmt::format("{} caps=\"application/x-rtp,media=video,clock-rate=90000,"
                          "encoding-name={},payload={}\" ! rtpjitterbuffer latency={} ! {}",
                          udpSource(address), payload->encoding, *number, kJitterMilliseconds,
                          payload->depayloader),
              TimeOrigin::Sender, payload->waitingImages,
              {"udpsrc", "rtpjitterbuffer", payload->depayloader});
}

Result<PipelineText> addressPipeline(const LiveCamera& camera) {
  constexpr std::string_view kPortMissing = "the address needs a port, as in udp://0.0.0.0:5600";
  const auto address = parseAddress(camera.location);
  if (!address) {
    return badLocation(camera, "this is not a valid address");
  }
  const std::string& scheme = address->scheme;
  if (scheme == "http" || scheme == "https") {
    return httpPipeline(*address);
  }
  if (scheme == "rtsp" || scheme == "rtsps") {
    return rtspPipeline(camera.location);
  }
  if (scheme == "srt") {
    return made(fmt::format("srtsrc uri={}", quotedValue(camera.location)), TimeOrigin::Sender,
                kWaitingInterImages, {"srtsrc"});
  }
  if (scheme != "udp" && scheme != "rtp") {
    return badLocation(camera, fmt::format("the program knows no streams of {}://", scheme));
  }
  if (!address->port) {
    return badLocation(camera, std::string(kPortMissing));
  }
  return scheme == "rtp"
             ? rtpPipeline(camera, *address)
             : made(udpSource(*address), TimeOrigin::Sender, kWaitingInterImages, {"udpsrc"});
}

/// The last element of a pipeline: what follows the last exclamation mark outside quotes.
std::string_view lastElement(std::string_view text) {
  std::size_t begin = 0;
  char quote = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '\\') {
      ++k;
    } else if (quote != 0) {
      quote = text[k] == quote ? '\0' : quote;
    } else if (text[k] == '"' || text[k] == '\'') {
      quote = text[k];
    } else if (text[k] == '!') {
      begin = k + 1;
    }
  }
  std::string_view last = text.substr(begin);
  last.remove_prefix(std::min(last.find_first_not_of(" \t\r\n"), last.size()));
  return last;
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// What the time stamps in a user's pipeline mean, by its source.
TimeOrigin originOf(std::string_view text) {
  if (contains(text, "rtpjitterbuffer") || contains(text, "rtpbin") || contains(text, "rtspsrc")) {
    return TimeOrigin::Sender;
  }
  const bool isOfNetwork =
      contains(text, "udpsrc") || contains(text, "soup") || contains(text, "tcp");
  return isOfNetwork ? TimeOrigin::Arrival : TimeOrigin::Driver;
}

Result<PipelineText> userPipeline(const LiveCamera& camera) {
  const std::string text = camera.location.substr(kPipelinePrefix.size());
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    return badLocation(camera, "a GStreamer pipeline is expected after gst:");
  }
  if (!lastElement(text).starts_with("appsink")) {
    return made(text, originOf(text), kWaitingInterImages, {});
  }
  PipelineText pipeline;
  pipeline.text = text;
  pipeline.origin = originOf(text);
  pipeline.hasOwnSink = true;
  pipeline.elements = {"appsink"};
  return pipeline;
}

/// Options of a test pattern; fails by name.
struct TestOptions {
  std::string pattern = "smpte";
  int width = 640;
  int height = 480;
  int rate = 30;
  int frames = 0;
  std::string encoding = "raw";
};

Result<TestOptions> testOptions(const LiveCamera& camera) {
  std::string_view text = std::string_view(camera.location).substr(kTestPrefix.size());
  TestOptions options;
  const std::string_view pattern = text.substr(0, text.find('?'));
  options.pattern = pattern.empty() ? options.pattern : std::string(pattern);
  if (!isTestPattern(options.pattern)) {
    return badLocation(camera, fmt::format("there is no test pattern \"{}\"; there are {}",
                                           options.pattern, testPatternList()));
  }
  text.remove_prefix(std::min(pattern.size() + 1, text.size()));
  const std::array<std::tuple<std::string_view, int*, int, int>, 4> numbers{
      {{"width", &options.width, 16, kLargestTestSide},
       {"height", &options.height, 16, kLargestTestSide},
       {"rate", &options.rate, 1, kLargestTestRate},
       {"frames", &options.frames, 0, kMostTestFrames}}};
  for (const auto& [name, value] : queryOptions(text)) {
    if (name == "encoding" && (value == "raw" || value == "mjpeg" || value == "h264")) {
      options.encoding = value;
      continue;
    }
    const auto* const known =
        std::ranges::find(numbers, name, [](const auto& row) { return std::get<0>(row); });
    if (known == numbers.end()) {
      return badLocation(
          camera, name == "encoding"
                      ? "the encoding of a test pattern is raw, mjpeg or h264"
                      : "a test pattern has the options width, height, rate, encoding and frames");
    }
    const auto number = toNumber<int>(value);
    const auto& [key, place, least, most] = *known;
    if (!number || *number < least || *number > most) {
      return badLocation(camera, fmt::format("the {} of a test pattern is a number from {} to {}",
                                             key, least, most));
    }
    *place = *number;
  }
  return options;
}

Result<PipelineText> testPipeline(const LiveCamera& camera) {
  const auto options = testOptions(camera);
  if (!options) {
    return tl::make_unexpected(options.error());
  }
  std::string source = fmt::format("videotestsrc is-live=true pattern={}", options->pattern);
  if (options->frames > 0) {
    source += fmt::format(" num-buffers={}", options->frames);
  }
  source += fmt::format(" ! video/x-raw,format=I420,width={},height={},framerate={}/1",
                        options->width, options->height, options->rate);
  std::vector<std::string> elements{"videotestsrc"};
  if (options->encoding == "mjpeg") {
    source += " ! jpegenc";
    elements.emplace_back("jpegenc");
  } else if (options->encoding == "h264") {
    source += fmt::format(" ! openh264enc gop-size={}", options->rate);
    elements.emplace_back("openh264enc");
  }
  PipelineText pipeline = made(
      source, TimeOrigin::Driver,
      options->encoding == "h264" ? kWaitingInterImages : kWaitingIntraImages, std::move(elements));
  pipeline.isFinite = options->frames > 0;
  return pipeline;
}

} // namespace

bool isOnlyForFfmpeg(std::string_view location) {
  return location.starts_with("rtmp://") || location.starts_with("tcp://");
}

Result<PipelineText> pipelineText(const LiveCamera& camera) {
  const std::string& location = camera.location;
  if (location.starts_with(kPipelinePrefix)) {
    return userPipeline(camera);
  }
  if (location.starts_with(kTestPrefix)) {
    return testPipeline(camera);
  }
  if (location.find("://") != std::string::npos) {
    return addressPipeline(camera);
  }
  if (const auto path = devicePath(location)) {
    return devicePipeline(camera, *path);
  }
  return badLocation(camera,
                     "expected a device number, /dev/videoN or another path below /dev, a stream "
                     "address such as http://... or rtsp://..., gst: and a GStreamer pipeline, or "
                     "test: and a test pattern");
}

bool isStoredLossless(std::string_view rawFormat) {
  // The last ones become BGR or RGB: the same bytes in another order.
  static constexpr std::array<std::string_view, 5> kSameBytes{"BGRx", "RGBx", "xBGR", "xRGB",
                                                              "GBR"};
  return std::ranges::find(kLosslessFormats, rawFormat) != kLosslessFormats.end() ||
         std::ranges::find(kSameBytes, rawFormat) != kSameBytes.end();
}

std::string storedPipelineText(const std::string& file) {
  return fmt::format("filesrc location={} ! parsebin ! decodebin ! videoconvert"
                     " ! video/x-raw,format=BGR ! appsink name={} sync=false max-buffers=4",
                     quotedValue(file), kImageSinkName);
}

std::string recordingPipelineText(const std::string& mediaType, bool lossless,
                                  const std::string& file) {
  std::string format;
  if (mediaType == "video/x-raw") {
    // For a JPEG through blue, green and red: the encoder stores limited YUV as if it had the full
    // range, and colors would fade.
    format = lossless
                 ? fmt::format(" ! videoconvert ! capsfilter caps=\"video/x-raw,format={{{}}}\"",
                               fmt::join(kLosslessFormats, ","))
                 : fmt::format(" ! videoconvert ! video/x-raw,format=BGR ! jpegenc quality={}",
                               kJpegQuality);
  } else if (mediaType == "image/jpeg") {
    format = " ! jpegparse"; // a network camera does not say the size, which the file needs
  } else if (mediaType == "video/x-h264" || mediaType == "video/x-h265") {
    const bool isH264 = mediaType == "video/x-h264";
    format = fmt::format(" ! {} ! {},stream-format={},alignment=au",
                         isH264 ? "h264parse" : "h265parse", mediaType, isH264 ? "avc" : "hvc1");
  }
  // Short clusters: what was written can be read even if the file has no end.
  return fmt::format("appsrc name=source format=time is-live=true block=false max-bytes=0{}"
                     " ! matroskamux name=muxer writing-app=Dewpoint"
                     " min-cluster-duration=250000000 max-cluster-duration=1000000000"
                     " ! filesink name=file location={} buffer-mode=unbuffered",
                     format, quotedValue(file));
}

} // namespace dewpoint::capture

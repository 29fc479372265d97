// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/scene_renderer.h"

#include "core/base/random.h"
#include "core/base/thread_team.h"
#include "core/simulation/camera_view.h"
#include "core/simulation/room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace dewpoint {
namespace {

using simulation::CameraView;
using simulation::Vector3f;

constexpr int kEdgeSamples = 4; ///< per side of a pixel on a silhouette
constexpr int kMostInstants = 16;
constexpr double kPixelsPerInstant = 1.5;
constexpr std::size_t kNoiseCount = 65536;

/// A moving thing: a ball, or the occluder as a box turned with the first camera.
struct Body {
  bool box = false;
  Vector3f center;
  float radius = 0.0F; ///< of the ball, or around the box
  Vector3f color;      ///< BGR
};

/// Width, height and thickness of the occluder, halved; metres.
const Vector3f kOccluderHalf{0.06F, 0.09F, 0.012F};

/// What one instant contributes to one pixel: color times coverage, and coverage.
struct Share {
  Vector3f color{0.0F, 0.0F, 0.0F};
  float coverage = 0.0F;
};

/// Standard normal numbers to pick from: drawing them anew for every pixel would cost more than all
/// the rest of a frame.
const std::vector<float>& noiseTable() {
  static const std::vector<float> table = [] {
    std::vector<float> values(kNoiseCount);
    const RandomStream stream(0, 0, 0, RandomPurpose::Noise);
    for (std::size_t i = 0; i < kNoiseCount; i += 4) {
      const auto four = stream.normal4(static_cast<std::uint32_t>(i / 4), 1);
      std::ranges::transform(four, values.begin() + static_cast<std::ptrdiff_t>(i),
                             [](double value) { return static_cast<float>(value); });
    }
    return values;
  }();
  return table;
}

/// The color of a ball's surface at `normal`: matte, with a faint broad highlight.
Vector3f ballColor(const Body& body, const Vector3f& point, const Vector3f& direction) {
  const Vector3f normal = (point - body.center) / body.radius;
  const Vector3f halfway =
      ((simulation::kLampPosition - point).normalized() - direction).normalized();
  const float facing = std::max(0.0F, normal.dot(halfway));
  const float facing4 = facing * facing * facing * facing;
  const float gloss = 12.0F * facing4 * facing4 * facing4;
  // A ball on a desk is dark below: it hides the room's light there from itself.
  const float light = simulation::shade(point, normal, 1.0F);
  return (light * body.color + Vector3f::Constant(gloss)).cwiseMin(255.0F);
}

/// Where a ray enters the sphere; nothing when it misses it or the sphere lies behind.
std::optional<float> hitSphere(const Body& body, const Vector3f& origin,
                               const Vector3f& direction) {
  const Vector3f way = body.center - origin;
  const float along = way.dot(direction);
  const float root = along * along - way.squaredNorm() + body.radius * body.radius;
  if (root < 0.0F || along < 0.0F) {
    return std::nullopt;
  }
  return along - std::sqrt(root);
}

} // namespace

struct SceneRenderer::Parts {
  explicit Parts(Scene theScene);

  std::vector<Body> bodiesAt(double time) const;
  void paint(const CameraView& view, std::int64_t frame, cv::Mat& image) const;
  void castShadow(const CameraView& view, const Body& body, cv::Mat& image) const;
  void addInstant(const CameraView& view, const Body& body, const cv::Rect& area,
                  std::vector<Share>& shares) const;
  Share sample(const CameraView& view, const Body& body, const Vector3f& direction,
               float limit) const;
  bool onEdge(const CameraView& view, const Body& body, int column, int row) const;
  cv::Mat develop(const cv::Mat& image, int camera, std::int64_t frame) const;

  Scene scene;
  std::vector<CameraView> views;
  Eigen::Matrix3f occluderAxes = Eigen::Matrix3f::Identity(); ///< rows: its axes in the world
};

SceneRenderer::Parts::Parts(Scene theScene) : scene(std::move(theScene)) {
  const simulation::Room room(scene.clutter);
  const auto count = static_cast<std::int64_t>(scene.cameras.size());
  std::vector<std::optional<CameraView>> built(scene.cameras.size());
  const auto processors = static_cast<std::int64_t>(std::thread::hardware_concurrency());
  ThreadTeam team(
      static_cast<int>(std::clamp<std::int64_t>(processors, 1, std::max<std::int64_t>(1, count))));
  team.forEachRange(count, [&](std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      built[i].emplace(scene.cameras[i], room);
    }
  });
  for (auto& view : built) {
    views.push_back(std::move(*view));
  }
  if (!scene.cameras.empty()) {
    occluderAxes = scene.cameras.front().cameraFromWorld.linear().cast<float>();
  }
}

std::vector<Body> SceneRenderer::Parts::bodiesAt(double time) const {
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    const SceneBall& ball = scene.balls[i];
    bodies.push_back({false, ballPosition(scene, static_cast<int>(i), time).cast<float>(),
                      static_cast<float>(ball.radius), ball.color.cast<float>()});
  }
  if (!scene.balls.empty()) {
    for (int i = 0; i < scene.lookAlikes; ++i) {
      bodies.push_back({false, lookAlikePosition(scene, i).cast<float>(), bodies.front().radius,
                        bodies.front().color});
    }
    if (scene.occluder) {
      bodies.push_back({true,
                        occluderPosition(scene, time).cast<float>(),
                        kOccluderHalf.norm(),
                        {150.0F, 122.0F, 96.0F}});
    }
  }
  return bodies;
}

Share SceneRenderer::Parts::sample(const CameraView& view, const Body& body,
                                   const Vector3f& direction, float limit) const {
  if (!body.box) {
    const auto distance = hitSphere(body, view.center, direction);
    if (!distance || *distance >= limit) {
      return {};
    }
    return {ballColor(body, view.center + *distance * direction, direction), 1.0F};
  }
  const Vector3f o = occluderAxes * (view.center - body.center);
  const Vector3f d = occluderAxes * direction;
  float enter = 0.0F;
  float leave = limit;
  int side = 2;
  for (int axis = 0; axis < 3; ++axis) {
    const float slope = std::abs(d[axis]) < 1e-9F ? 1e-9F : d[axis];
    const float reach = std::copysign(kOccluderHalf[axis], slope);
    if ((-reach - o[axis]) / slope > enter) {
      enter = (-reach - o[axis]) / slope;
      side = axis;
    }
    leave = std::min(leave, (reach - o[axis]) / slope);
  }
  if (enter >= leave || enter <= 0.0F) {
    return {};
  }
  Vector3f normal = occluderAxes.row(side).transpose();
  if (d[side] > 0.0F) {
    normal = -normal;
  }
  return {simulation::shade(view.center + enter * direction, normal, 1.0F) * body.color, 1.0F};
}

bool SceneRenderer::Parts::onEdge(const CameraView& view, const Body& body, int column,
                                  int row) const {
  if (body.box) {
    return true;
  }
  const Vector3f way = body.center - view.center;
  const Vector3f& here = view.directions[view.index(column, row)];
  const float along = way.dot(here);
  const float aside = std::sqrt(std::max(0.0F, way.squaredNorm() - along * along));
  const float pixel = along * (view.direction(column, row, 0.5F, 0.5F) - here).norm();
  return std::abs(aside - body.radius) < 1.2F * pixel;
}

void SceneRenderer::Parts::addInstant(const CameraView& view, const Body& body,
                                      const cv::Rect& area, std::vector<Share>& shares) const {
  auto share = shares.begin();
  for (int row = area.y; row < area.y + area.height; ++row) {
    for (int column = area.x; column < area.x + area.width; ++column, ++share) {
      const std::size_t pixel = view.index(column, row);
      const Vector3f& here = view.directions[pixel];
      if (here.isZero(0.0F)) {
        continue;
      }
      const float limit = view.distances[pixel];
      if (!onEdge(view, body, column, row)) {
        const Share whole = sample(view, body, here, limit);
        share->color += whole.color;
        share->coverage += whole.coverage;
        continue;
      }
      constexpr float kWeight = 1.0F / (kEdgeSamples * kEdgeSamples);
      for (int i = 0; i < kEdgeSamples * kEdgeSamples; ++i) {
        const auto [right, down] = simulation::subpixel(i, kEdgeSamples);
        const Share part = sample(view, body, view.direction(column, row, right, down), limit);
        share->color += kWeight * part.color;
        share->coverage += kWeight * part.coverage;
      }
    }
  }
}

void SceneRenderer::Parts::castShadow(const CameraView& view, const Body& body,
                                      cv::Mat& image) const {
  // Only the shadow on the desk (z = 0) is drawn; a sphere around it bounds its pixels.
  const Vector3f lamp = simulation::kLampPosition;
  if (body.box || body.center.z() + body.radius >= lamp.z() || body.center.z() < 0.0F) {
    return;
  }
  const Vector3f spot = lamp + (body.center - lamp) * (lamp.z() / (lamp.z() - body.center.z()));
  const float penumbra = simulation::kLampRadius * body.center.z() / lamp.z();
  const cv::Rect area = view.boundsOfSphere(spot.cast<double>(), 1.6 * (body.radius + penumbra));
  for (int row = area.y; row < area.y + area.height; ++row) {
    for (int column = area.x; column < area.x + area.width; ++column) {
      const std::size_t pixel = view.index(column, row);
      const float distance = view.distances[pixel];
      if (!(distance < 100.0F)) {
        continue;
      }
      const Vector3f point = view.center + distance * view.directions[pixel];
      const Vector3f way = lamp - point;
      const float length = way.norm();
      const float along = (body.center - point).dot(way) / length;
      if (point.z() > 0.01F || along <= 0.0F) {
        continue;
      }
      const float aside = ((body.center - point) - along / length * way).norm();
      const float blur = std::max(0.002F, simulation::kLampRadius * along / length);
      const float t = std::clamp((aside - body.radius + blur) / (2.0F * blur), 0.0F, 1.0F);
      const float covered = 1.0F - t * t * (3.0F - 2.0F * t);
      image.at<cv::Vec3f>(row, column) *= 1.0F - covered * view.lit[pixel];
    }
  }
}

void SceneRenderer::Parts::paint(const CameraView& view, std::int64_t frame, cv::Mat& image) const {
  const double time = frameTime(scene, frame);
  const double half = 0.5 * scene.exposureSeconds;
  const auto middle = bodiesAt(time);
  const auto opening = bodiesAt(time - half);
  const auto closing = bodiesAt(time + half);
  std::vector<std::size_t> order(middle.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
    castShadow(view, middle[i], image);
  }
  // Far to near: what is nearer covers what is farther.
  std::ranges::sort(order, std::greater<>{},
                    [&](std::size_t i) { return (middle[i].center - view.center).squaredNorm(); });
  std::vector<Share> shares;
  for (const std::size_t i : order) {
    const auto boundsAt = [&](const Body& body) {
      return view.boundsOfSphere(body.center.cast<double>(), body.radius);
    };
    const cv::Rect first = boundsAt(opening[i]);
    const cv::Rect last = boundsAt(closing[i]);
    const cv::Rect area = first | boundsAt(middle[i]) | last;
    if (area.empty()) {
      continue;
    }
    const double travel = cv::norm((first.tl() + first.br() - last.tl() - last.br()) / 2);
    const int instants =
        std::clamp(static_cast<int>(std::ceil(travel / kPixelsPerInstant)), 1, kMostInstants);
    shares.assign(static_cast<std::size_t>(area.area()), {});
    for (int k = 0; k < instants; ++k) {
      const double moment = time + half * ((2.0 * k + 1.0) / instants - 1.0);
      addInstant(view, instants == 1 ? middle[i] : bodiesAt(moment)[i], area, shares);
    }
    auto share = shares.begin();
    const float weight = 1.0F / static_cast<float>(instants);
    for (int row = area.y; row < area.y + area.height; ++row) {
      auto* pixels = image.ptr<cv::Vec3f>(row);
      for (int column = area.x; column < area.x + area.width; ++column, ++share) {
        const Vector3f color = weight * share->color;
        pixels[column] = pixels[column] * (1.0F - weight * share->coverage) +
                         cv::Vec3f{color.x(), color.y(), color.z()};
      }
    }
  }
}

cv::Mat SceneRenderer::Parts::develop(const cv::Mat& image, int camera, std::int64_t frame) const {
  cv::Mat result(image.size(), CV_8UC3);
  const std::vector<float>& normals = noiseTable();
  const auto sigma = static_cast<float>(scene.noiseSigma);
  const RandomStream stream(scene.seed, static_cast<std::uint32_t>(frame),
                            static_cast<std::uint32_t>(camera), RandomPurpose::Simulation);
  const auto values = static_cast<std::size_t>(image.total()) * 3;
  const auto* in = image.ptr<float>();
  auto* out = result.ptr<std::uint8_t>();
  // Eight values from the four words of one draw.
  for (std::size_t i = 0; i < values; i += 8) {
    std::array<std::uint32_t, 4> words{};
    if (sigma > 0.0F) {
      words = stream.words(static_cast<std::uint32_t>(i / 8));
    }
    const std::size_t end = std::min<std::size_t>(8, values - i);
    for (std::size_t k = 0; k < end; ++k) {
      const std::uint32_t pick = (words[k / 2] >> (16U * (k % 2))) & 0xFFFFU;
      const float value = in[i + k] + sigma * normals[pick];
      // Rounds to the nearest: what is cut off begins at one half.
      out[i + k] = static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.5F, 255.5F));
    }
  }
  return result;
}

SceneRenderer::SceneRenderer(Scene scene)
    : parts_(std::make_unique<const Parts>(std::move(scene))) {}
SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

cv::Mat SceneRenderer::render(int camera, std::int64_t frame) const {
  const CameraView& view = parts_->views.at(static_cast<std::size_t>(camera));
  cv::Mat image = view.background.clone();
  parts_->paint(view, frame, image);
  return parts_->develop(image, camera, frame);
}

const Scene& SceneRenderer::scene() const {
  return parts_->scene;
}

} // namespace dewpoint

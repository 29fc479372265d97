// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/surface/texture.h"

#include <cmath>

namespace dewpoint::simulation {
namespace {

/// Noise of several scales, each of half the size and half the strength of the one before.
float layeredNoise(Vector3f position, int layers) {
  float sum = 0.0F;
  float strength = 0.5F;
  for (int layer = 0; layer < layers; ++layer) {
    sum += strength * valueNoise(position);
    position *= 2.03F;
    strength *= 0.5F;
  }
  return sum;
}

/// Planks along X with grain stretched along them.
float woodTone(const Vector3f& position) {
  const float plank = std::floor(position.y() / 0.13F);
  const float shift =
      static_cast<float>(hashOfIntegers(static_cast<std::uint32_t>(static_cast<int>(plank)), 5, 9) &
                         0xFFFFU) /
      65535.0F;
  const Vector3f along{position.x() * 3.0F + 37.0F * shift, position.y() * 28.0F,
                       position.z() * 28.0F};
  const float rings = std::sin(9.0F * layeredNoise(along, 2) + 60.0F * position.y());
  const float fibers =
      layeredNoise({position.x() * 14.0F, position.y() * 260.0F, position.z() * 260.0F}, 2);
  const float across = position.y() / 0.13F - plank;
  const float seam = across < 0.012F ? -0.22F : 0.0F;
  return 0.92F + 0.07F * rings + 0.10F * fibers + 0.10F * (shift - 0.5F) + seam;
}

float floorTone(const Vector3f& position) {
  const float u = position.x() / 0.4F;
  const float v = position.y() / 0.4F;
  const bool joint = u - std::floor(u) < 0.02F || v - std::floor(v) < 0.02F;
  return (joint ? 0.45F : 0.62F) + 0.08F * layeredNoise(position * 9.0F, 3);
}

} // namespace

std::uint32_t hashOfIntegers(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  // The finalizer of MurmurHash3 (Appleby, public domain) over a sum of odd multiples.
  std::uint32_t h = x * 0x9E3779B1U + y * 0x85EBCA77U + z * 0xC2B2AE3DU + 0x27D4EB2FU;
  h = (h ^ (h >> 16U)) * 0x85EBCA6BU;
  h = (h ^ (h >> 13U)) * 0xC2B2AE35U;
  return h ^ (h >> 16U);
}

float valueNoise(const Vector3f& position) {
  const Vector3f base{std::floor(position.x()), std::floor(position.y()), std::floor(position.z())};
  const Vector3f t = position - base;
  const Vector3f s = t.cwiseProduct(t).cwiseProduct(Vector3f::Constant(3.0F) - 2.0F * t);
  const auto corner = [&](int i) {
    const auto cell = [&](int axis, int bit) {
      return static_cast<std::uint32_t>(static_cast<int>(base[axis]) + bit);
    };
    const auto word = hashOfIntegers(cell(0, i & 1), cell(1, (i >> 1) & 1), cell(2, (i >> 2) & 1));
    return static_cast<float>(word >> 8U) / 8388607.5F - 1.0F;
  };
  const auto mix = [](float a, float b, float share) { return a + share * (b - a); };
  const float front =
      mix(mix(corner(0), corner(1), s.x()), mix(corner(2), corner(3), s.x()), s.y());
  const float back = mix(mix(corner(4), corner(5), s.x()), mix(corner(6), corner(7), s.x()), s.y());
  return mix(front, back, s.z());
}

Vector3f textureColor(Pattern pattern, const Vector3f& color, const Vector3f& position) {
  switch (pattern) {
  case Pattern::Wood: {
    const float tone = woodTone(position);
    // Dark grain is browner, not only darker.
    return color.cwiseProduct(Vector3f{tone * tone, std::pow(tone, 1.3F), tone});
  }
  case Pattern::Plaster:
    return color * (0.93F + 0.06F * layeredNoise(position * 5.0F, 2) +
                    0.06F * layeredNoise(position * 60.0F, 2));
  case Pattern::Skin:
    return color * (0.97F + 0.05F * layeredNoise(position * 45.0F, 3));
  case Pattern::Floor:
    return Vector3f{96.0F, 118.0F, 132.0F} * floorTone(position);
  case Pattern::Pages:
    return color * (0.92F + 0.10F * std::sin(position.z() * 3000.0F));
  case Pattern::Plain:
    break;
  }
  return color * (1.0F + 0.03F * layeredNoise(position * 80.0F, 2));
}

} // namespace dewpoint::simulation

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/box_fingerprint.h"

#include "core/experiment/boxes/box_clips.h"
#include "core/experiment/boxes/box_follower.h"
#include "core/experiment/report/fingerprint.h"
#include "core/experiment/report/seed_blocks.h"

#include <cstdint>

namespace dewpoint::experiment {
namespace {

constexpr int kFingerprintParticles = 300; ///< as in the study of boxes
constexpr std::int64_t kImages = 30;       ///< of the clip's beginning; chosen: enough to differ
constexpr double kPixelStep = 0.01;        ///< pixels; coarser than rounding, finer than a change

/// Of one follower; errors of the clip's images and of the start.
Result<std::string> fingerprintOf(const BoxClip& clip, BoxFollower& follower) {
  Fingerprint fingerprint;
  for (std::int64_t k = 0; k < kImages; ++k) {
    const auto image = clip.image(k);
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    if (k == 0) {
      if (const auto started = follower.start(*image, clip.truth.front()); !started) {
        return tl::make_unexpected(started.error());
      }
      continue;
    }
    const auto box = follower.step(*image);
    if (!box) {
      fingerprint.add("lost");
      continue;
    }
    for (const double side : {box->x, box->y, box->width, box->height}) {
      fingerprint.add(side, kPixelStep);
    }
  }
  return fingerprint.text();
}

} // namespace

Result<std::map<std::string, std::string>>
boxFingerprints(const std::vector<std::string>& methods) {
  const BoxClip clip = simulatedBoxClip(kFirstTuningSeed);
  std::map<std::string, std::string> texts;
  for (const std::string& method : methods.empty() ? boxFollowerNames() : methods) {
    auto follower = makeFollowerByName(method, kFingerprintParticles, kFirstTuningSeed);
    if (!follower) {
      return tl::make_unexpected(follower.error());
    }
    auto text = fingerprintOf(clip, **follower);
    if (!text) {
      return tl::make_unexpected(text.error());
    }
    texts[method] = std::move(*text);
  }
  return texts;
}

} // namespace dewpoint::experiment

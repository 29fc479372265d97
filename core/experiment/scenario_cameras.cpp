// SPDX-License-Identifier: GPL-3.0-or-later
// S6: two to eight cameras, and cameras that drop out and return.
#include "core/experiment/scenario_places.h"
#include "core/simulation/rigs.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::scenarios {
namespace {

/// Frames [begin, end) of a camera do not arrive.
struct Dropout {
  int camera = 0;
  std::int64_t begin = 0;
  std::int64_t end = 0;
};

/// One camera after another, in an order of the seed's, is away for 25 to 35 frames. With at least
/// 25 frames between two events what one does is over before the next.
bool withDropouts(ScenarioDraft& draft) {
  constexpr std::int64_t kFirst = 45;
  constexpr std::int64_t kApart = 60;
  const auto count = static_cast<int>(draft.rig.size());
  if (!addDeskBall(draft, kFirst + kApart * count + 15)) {
    return false;
  }
  std::vector<int> order;
  for (int camera = 0; camera < count; ++camera) {
    const auto place = order.begin() + draft.draws.whole(0, camera);
    order.insert(place, camera);
  }
  std::vector<Dropout> dropouts;
  for (const int camera : order) {
    const std::int64_t begin = kFirst + kApart * static_cast<std::int64_t>(dropouts.size());
    const std::int64_t end = begin + 30 + draft.draws.whole(-5, 5);
    dropouts.push_back({camera, begin, end});
    draft.events.push_back({ScenarioEvent::Kind::CameraLost, begin, camera});
    draft.events.push_back({ScenarioEvent::Kind::CameraBack, end, camera});
  }
  draft.lost = [dropouts](std::size_t camera, std::int64_t frame) {
    return std::ranges::any_of(dropouts, [&](const Dropout& dropout) {
      return dropout.camera == static_cast<int>(camera) && frame >= dropout.begin &&
             frame < dropout.end;
    });
  };
  return true;
}

} // namespace

std::vector<ScenarioRecipe> cameraScenarios() {
  std::vector<ScenarioRecipe> recipes;
  for (const int count : {2, 3, 4, 6, 8}) {
    ScenarioRecipe recipe{fmt::format("S6-{}", count),
                          fmt::format("The smooth path before {} cameras.", count),
                          deskRing(count)};
    recipe.complete = [](ScenarioDraft& draft) { return addDeskBall(draft, 180); };
    recipes.push_back(std::move(recipe));
  }
  ScenarioRecipe dropouts{"S6-dropouts",
                          "One of four cameras after another drops out for about 1 s and returns.",
                          deskRing(4)};
  dropouts.complete = withDropouts;
  recipes.push_back(std::move(dropouts));
  return recipes;
}

} // namespace dewpoint::scenarios

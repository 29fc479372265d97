// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/report/seed_blocks.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::experiment {
namespace {

/// What a report says of seeds that are all of one block.
std::string_view judgementOf(SeedPurpose use) {
  switch (use) {
  case SeedPurpose::Tuning:
    return "TUNING seeds, not to be quoted as results";
  case SeedPurpose::Validation:
    return "VALIDATION seeds, which were looked at before; not to be quoted as results";
  case SeedPurpose::Reserve:
    return "RESERVE seeds, kept for later reports; not to be looked at yet";
  case SeedPurpose::Reporting:
    break;
  }
  return "reporting seeds, on which no method was tuned";
}

} // namespace

const SeedBlock& seedBlockOf(std::uint64_t seed) {
  return *std::ranges::find_if(kSeedBlocks,
                               [&](const SeedBlock& block) { return seed <= block.last; });
}

bool areReportingSeeds(const std::vector<std::uint64_t>& seeds) {
  return !seeds.empty() && std::ranges::all_of(seeds, [](std::uint64_t seed) {
    return seedBlockOf(seed).purpose == SeedPurpose::Reporting;
  });
}

std::string describeSeeds(const std::vector<std::uint64_t>& seeds) {
  if (seeds.empty()) {
    return "none";
  }
  const std::string range =
      fmt::format("{} to {}, {} in all: ", seeds.front(), seeds.back(), seeds.size());
  const SeedPurpose use = seedBlockOf(seeds.front()).purpose;
  if (seedBlockOf(seeds.back()).purpose == use) {
    return range + std::string(judgementOf(use));
  }
  std::string names;
  for (const SeedBlock& block : kSeedBlocks) {
    if (std::ranges::any_of(seeds, [&](std::uint64_t seed) {
          return seedBlockOf(seed).purpose == block.purpose;
        })) {
      names += fmt::format("{}{}", names.empty() ? "" : " and ", block.name);
    }
  }
  return range + names + " seeds mixed, not to be quoted as results";
}

std::string describeSeeds(std::uint64_t first, int count) {
  std::vector<std::uint64_t> seeds;
  seeds.reserve(static_cast<std::size_t>(std::max(0, count)));
  for (int k = 0; k < count; ++k) {
    seeds.push_back(first + static_cast<std::uint64_t>(k));
  }
  return describeSeeds(seeds);
}

} // namespace dewpoint::experiment

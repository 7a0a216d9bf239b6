#pragma once

namespace fluidymation {

/// The largest share of a run's time that goes into saved states unless `--checkpoint-every` says
/// how often they are saved.
inline constexpr double kCheckpointShare = 0.02;

}  // namespace fluidymation
